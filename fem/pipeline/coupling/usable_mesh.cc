#include "fem/pipeline/coupling/usable_mesh.h"

#include "fem/pipeline/coupling/finite_elements.h"
#include "fem/pipeline/support/failures.h"
#include "fem/pipeline/support/numbers.h"
#include "fem/pipeline/support/text_file.h"

#include <cmath>
#include <fmt/format.h>

namespace stemware::pipeline
{

fem::MeshReport read_mesh_file(const std::string &file, const fem::MeshMarks &marks,
                               dealii::Triangulation<3, 3> &mesh)
try
{
  require_regular_file("The mesh " + shortened_path(file), file);
  return finite_elements().read_foot_mesh(file, mesh, marks);
}
catch (const std::invalid_argument &error)
{
  throw BadInput(error.what());
}

void require_usable(const std::string &origin, const fem::MeshCheck &check)
{
  const std::string mesh = "The mesh (" + shortened_path(origin) + ")";
  require(
    check.n_inverted == 0,
    fmt::format(FMT_STRING("{} has {} cells that are flat or inside out at a corner, the worst near ({:.4g}, "
                           "{:.4g}, {:.4g}); mesh that place anew."),
                mesh, check.n_inverted, check.worst_place[0], check.worst_place[1], check.worst_place[2]));
  require(
    check.n_zones == 1,
    fmt::format(FMT_STRING("{} has a contact zone of {} parts that share no edge; mark one ring of faces "
                           "round the axis."),
                mesh, check.n_zones));
  require(!(check.upward_share > 0),
          fmt::format(
            FMT_STRING("{} has a contact zone of which {:.3g} % looks up; turn the mesh so that the glass "
                       "stands upright on it, z upwards."),
            mesh, 100 * check.upward_share));
  require(std::hypot(check.centre[0], check.centre[1]) <= 0.01 * check.outer_radius,
          fmt::format(
            FMT_STRING("{} has its contact zone round ({:.4g}, {:.4g}) m; move it so that the axis of the "
                       "glass is x = y = 0."),
            mesh, check.centre[0], check.centre[1]));
}

void require_same_glass(const fem::MeshReport &report, const std::string &file, const Study &study)
{
  const double radius = study.glass.profile.contact_radius;
  require(
    std::abs(report.rim_radius - 1000 * radius) > 100 * radius,
    fmt::format(FMT_STRING("The mesh {} is in millimetres: its rim has a radius of {} and Glass/Contact "
                           "radius = {} m; multiply its coordinates by 0.001."),
                shortened_path(file), to_short_text(report.rim_radius), to_text(radius)));
  require(std::abs(report.rim_radius - radius) <= 0.1 * radius,
          fmt::format(
            FMT_STRING("The rim of the mesh {} has a radius of {} m, but Glass/Contact radius = {} m; give "
                       "the radius of the mesh, and the mesh in metres."),
            shortened_path(file), to_short_text(report.rim_radius), to_text(radius)));
}

void require_usable_mesh(const Study &study)
{
  const std::string &file = study.contact.mesh_file;
  const auto mesh = finite_elements().empty_mesh();
  const fem::MeshReport report = read_mesh_file(file, study.contact.mesh_marks, *mesh);
  require_usable(file, finite_elements().check_mesh(*mesh));
  require_same_glass(report, file, study);
}

} // namespace stemware::pipeline
