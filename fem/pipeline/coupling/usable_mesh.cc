#include "fem/pipeline/coupling/usable_mesh.h"

#include "fem/pipeline/base/failures.h"
#include "fem/pipeline/base/numbers.h"
#include "fem/pipeline/base/text_file.h"
#include "fem/pipeline/study/study_entries.h"

#include <deal.II/grid/tria.h>

#include <cmath>
#include <filesystem>
#include <fmt/format.h>

namespace stemware::pipeline
{

namespace
{

/// Returns a position as text, e.g. "(0.0003, 0) m". Values below 1e-6 @p size (rounding) are printed as 0.
std::string place(double x, double y, double size)
{
  const auto shown = [&](double value) { return std::abs(value) < 1e-6 * size ? 0. : value; };
  return fmt::format(FMT_STRING("({:.4g}, {:.4g}) m"), shown(x), shown(y));
}

void require_readable_size(const std::string &file, double memory_limit)
{
  constexpr double memory_per_byte = 12; // measured: 7 for hexahedra; files with short rows need more
  std::error_code error;
  const auto size = static_cast<double>(std::filesystem::file_size(file, error));
  ensure(error || memory_per_byte * size <= memory_limit,
         fmt::format(
           FMT_STRING("The mesh {} has {:.2g} GB, and reading it takes about {:.2g} GB of memory, above "
                      "{} GB; give a coarser mesh, or allow more with Contact/Memory limit = {:.0f} GB."),
           shortened_path(file), size / 1e9, memory_per_byte * size / 1e9, to_short_text(memory_limit / 1e9),
           std::ceil(memory_per_byte * size / 1e9)));
}

} // namespace

fem::MeshReport read_mesh_file(const std::string &file, const fem::MeshFileOptions &marks,
                               dealii::Triangulation<3, 3> &mesh, double memory_limit)
try
{
  require_regular_file("The mesh " + shortened_path(file), file);
  require_readable_size(file, memory_limit);
  return fem::read_foot_mesh(file, mesh, marks);
}
catch (const std::invalid_argument &error)
{
  throw BadInput(with_entries(error.what()));
}

void require_usable(const std::string &origin, const fem::MeshCheck &check, const fem::MeshFileOptions &marks)
{
  const std::string mesh = "The mesh (" + shortened_path(origin) + ")";
  ensure(
    check.n_disconnected == 0,
    fmt::format(FMT_STRING("{} has {} of {} cells not connected to the stem cut by faces, one at ({:.4g}, "
                           "{:.4g}, {:.4g}) m; export the foot only, as one body."),
                mesh, check.n_disconnected, check.n_cells, check.disconnected_place[0],
                check.disconnected_place[1], check.disconnected_place[2]));
  ensure(
    check.n_inverted == 0,
    fmt::format(FMT_STRING("{} has {} cells that are flat or inverted at a corner, the worst near ({:.4g}, "
                           "{:.4g}, {:.4g}); remesh this region."),
                mesh, check.n_inverted, check.worst_place[0], check.worst_place[1], check.worst_place[2]));
  if (check.upward_share > 0 && check.mean_height > check.stem_height)
  {
    const std::string swap =
      fmt::format(FMT_STRING("swap the ids (Contact/Mesh contact id = {}, Contact/Mesh stem id = {})"),
                  marks.stem_id, marks.contact_id);
    const std::string turn = "rotate the mesh so that the glass stands upright, z upwards";
    // A stem is narrower than the rim. If the marked contact zone is narrower than the stem cut, the ids are
    // swapped.
    const bool are_swapped = check.outer_radius <= check.stem_radius;
    throw BadInput(mesh + " has its contact zone above its stem cut, facing up; " +
                   (are_swapped ? swap + ", or if they are right, " + turn : turn + ", or " + swap) + ".");
  }
  ensure(
    check.n_zones == 1,
    fmt::format(FMT_STRING("{} has a contact zone of {} parts that share no edge; mark one ring of faces "
                           "round the axis."),
                mesh, check.n_zones));
  const bool looks_up = check.upward_share > 0;
  ensure(!looks_up && !(check.sideways_share > 0),
         fmt::format(FMT_STRING("{} has a contact zone of which {:.3g} % faces {}; mark only faces that "
                                "face down, and rotate the mesh so that z points upwards."),
                     mesh, 100 * (looks_up ? check.upward_share : check.sideways_share),
                     looks_up ? "up" : "sideways"));
  const auto &[x, y] = check.rim_centre;
  constexpr double round = 1e-3;
  ensure(check.rim_deviation > round || std::hypot(x, y) <= 1e-3 * check.outer_radius,
         fmt::format(
           FMT_STRING("{} has its rim round {}; move the mesh by {}, so that the axis of the glass is x = "
                      "y = 0."),
           mesh, place(x, y, check.outer_radius), place(-x, -y, check.outer_radius)));
  ensure(std::hypot(check.centre[0], check.centre[1]) <= 0.01 * check.outer_radius,
         fmt::format(
           FMT_STRING("{} has its contact zone round {}; move it so that the axis of the glass is x = y = "
                      "0."),
           mesh, place(check.centre[0], check.centre[1], check.outer_radius)));
}

void require_same_glass(const fem::MeshReport &report, const std::string &file, double unit,
                        double contact_radius)
{
  const auto fits = [&](double rim) { return std::abs(rim - contact_radius) <= 0.1 * contact_radius; };
  if (fits(report.rim_radius))
    return;
  std::string advice = "give the radius of the mesh, and the unit of its coordinates as Contact/Mesh unit";
  for (const auto &[name, size] : mesh_units())
    if (fits(report.rim_radius / unit * size))
      advice = "set Contact/Mesh unit = " + name + ", the likely unit of the coordinates";
  const std::string rim = report.round_rim
                            ? "The rim of the mesh " + shortened_path(file) + " has a radius of "
                            : "The land of the mesh " + shortened_path(file) +
                                " is not round; the mean of the smallest and largest distance of its border "
                                "from the axis, used as contact radius, is ";
  throw BadInput(fmt::format(FMT_STRING("{}{} m, but Glass/Contact radius = {} m; {}."), rim,
                             to_short_text(report.rim_radius), to_text(contact_radius), advice));
}

void require_usable_mesh(const ContactSection &contact, double contact_radius)
{
  dealii::Triangulation<3> mesh;
  const fem::MeshReport report =
    read_mesh_file(contact.mesh_file, contact.mesh_file_options, mesh, contact.memory_limit);
  require_usable(contact.mesh_file, fem::check_mesh(mesh), contact.mesh_file_options);
  require_same_glass(report, contact.mesh_file, contact.mesh_file_options.unit, contact_radius);
}

} // namespace stemware::pipeline
