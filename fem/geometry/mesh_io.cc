#include "fem/geometry/mesh_io.h"

#include "fem/geometry/boundary_ids.h"
#include "fem/geometry/mesh_content.h"
#include "fem/geometry/mesh_quality.h"

#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold_lib.h>
#include <deal.II/grid/tria.h>
#include <deal.II/lac/vector.h>
#include <deal.II/numerics/data_out.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <map>
#include <ostream>
#include <set>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace stemware::fem
{

using namespace dealii;

namespace
{

constexpr types::manifold_id cylinder_id = 1;
constexpr auto contact_id = static_cast<types::boundary_id>(FootBoundary::contact_zone);
constexpr auto stem_cut_id = static_cast<types::boundary_id>(FootBoundary::stem_cut);

unsigned int count_faces(const Triangulation<3> &triangulation, FootBoundary boundary)
{
  unsigned int n_faces = 0;
  for (const auto &face : triangulation.active_face_iterators())
    n_faces += is_on(face, boundary);
  return n_faces;
}

bool lies_at(const Triangulation<3>::face_iterator &face, double z, double distance)
{
  for (const unsigned int v : face->vertex_indices())
    if (std::abs(face->vertex(v)[2] - z) > distance)
      return false;
  return true;
}

/// Marks the downward faces within MeshFileOptions::contact_height of the lowest point as contact zone. Marks
/// the top of the mesh as stem cut if no face has the id of the stem cut.
void mark_by_height(const MeshFileOptions &marks, Triangulation<3> &triangulation)
{
  const auto [lower, upper] = GridTools::compute_bounding_box(triangulation).get_boundary_points();
  const double lowest = lower[2], highest = upper[2];
  const bool has_stem_cut = count_faces(triangulation, FootBoundary::stem_cut) > 0;
  for (const auto &cell : triangulation.active_cell_iterators())
    for (const auto &face : cell->face_iterators())
    {
      if (!face->at_boundary())
        continue;
      const auto outward = face->center() - cell->center();
      // The margin excludes vertical walls whose slope has a rounding error.
      const double upward = outward[2] + 1e-6 * outward.norm();
      if (upward < 0 && lies_at(face, lowest, marks.contact_height))
        face->set_boundary_id(contact_id);
      else if (face->boundary_id() == contact_id)
        face->set_boundary_id(0);
      if (!has_stem_cut && upward > 0 && lies_at(face, highest, 1e-6 * (highest - lowest)))
        face->set_boundary_id(stem_cut_id);
    }
}

/// Replaces the ids of @p marks by the ids of FootBoundary. Faces with any other id are free.
void mark(const MeshFileOptions &marks, Triangulation<3> &triangulation)
{
  for (const auto &face : triangulation.active_face_iterators())
    if (face->at_boundary())
    {
      const types::boundary_id id = face->boundary_id();
      if (id == marks.contact_id)
        face->set_boundary_id(contact_id);
      else if (id == marks.stem_id)
        face->set_boundary_id(stem_cut_id);
      else if (id == contact_id || id == stem_cut_id)
        face->set_boundary_id(0);
    }
  if (marks.contact_height > 0)
    mark_by_height(marks, triangulation);
}

/// Returns the mean height [m] of the faces of each boundary id that a study may name.
std::map<types::boundary_id, double> heights_by_id(const Triangulation<3> &triangulation)
{
  constexpr types::boundary_id max_entry = 65000;
  std::map<types::boundary_id, double> heights;
  std::map<types::boundary_id, unsigned int> n_faces;
  for (const auto &face : triangulation.active_face_iterators())
    if (face->at_boundary() && face->boundary_id() != 0 && face->boundary_id() <= max_entry)
    {
      heights[face->boundary_id()] += face->center()[2];
      ++n_faces[face->boundary_id()];
    }
  for (auto &[id, height] : heights)
    height /= n_faces[id];
  return heights;
}

std::string listed(const std::vector<std::string> &texts)
{
  constexpr std::size_t max_texts = 6;
  std::string list;
  for (std::size_t i = 0; i < std::min(texts.size(), max_texts); ++i)
    list += (i > 0 ? ", " : "") + texts[i];
  return list + (texts.size() > max_texts ? ", ..." : "");
}

/// Throws std::invalid_argument if the contact zone or the stem cut has no faces.
void require_boundaries(const std::string &file_name, const MeshFileOptions &marks,
                        const std::map<types::boundary_id, double> &heights, const FaceNames &names,
                        const Triangulation<3> &triangulation)
{
  const bool has_contact = count_faces(triangulation, FootBoundary::contact_zone) > 0,
             has_stem = count_faces(triangulation, FootBoundary::stem_cut) > 0;
  if (has_contact && has_stem)
    return;
  std::vector<std::string> ids;
  for (const auto &[id, height] : heights)
  {
    const auto name = names.find(id);
    ids.push_back(std::to_string(id) + (name == names.end() ? "" : " (" + printable(name->second) + ")"));
  }
  std::string text =
    "Mesh file = " + file_name + (has_contact ? " has no stem cut: " : " has no contact zone: ");
  if (heights.empty())
    throw std::invalid_argument(text +
                                "none of its faces has an id; save it without Mesh.SaveAll and give its "
                                "surfaces physical ids, " +
                                std::to_string(marks.contact_id) + " for the contact zone and " +
                                std::to_string(marks.stem_id) +
                                " for the stem cut, or set a mesh contact height.");

  // The message suggests the lowest faces as contact zone and the highest faces as stem cut.
  const auto is_lower = [](const auto &a, const auto &b) { return a.second < b.second; };
  const auto lowest = std::min_element(heights.begin(), heights.end(), is_lower),
             highest = std::max_element(heights.begin(), heights.end(), is_lower);
  const bool names_contact = !has_contact && lowest->first != marks.stem_id,
             names_stem =
               !has_stem && highest->first != marks.contact_id && (has_contact || lowest != highest);
  text += "its faces have the ids " + listed(ids) + "; ";
  if (names_contact)
    text += "set mesh contact id = " + std::to_string(lowest->first) + ", its lowest faces";
  if (names_stem)
    text += (names_contact ? ", and " : "set ") + ("mesh stem id = " + std::to_string(highest->first)) +
            ", its highest ones";
  if (!names_contact && !names_stem)
    text +=
      "give the faces of the " + (has_contact ? "stem cut the id " + std::to_string(marks.stem_id)
                                              : "contact zone the id " + std::to_string(marks.contact_id));
  throw std::invalid_argument(text + (has_contact ? "." : ", or set a mesh contact height."));
}

double exterior_angle(const std::array<double, 2> &before, const std::array<double, 2> &here,
                      const std::array<double, 2> &after)
{
  const double x[] = { here[0] - before[0], after[0] - here[0] },
               y[] = { here[1] - before[1], after[1] - here[1] };
  return std::abs(std::atan2(x[0] * y[1] - x[1] * y[0], x[0] * x[1] + y[0] * y[1]));
}

struct RimBorder
{
  explicit RimBorder(const Triangulation<3> &triangulation)
  {
    constexpr double corner = 1; // minimum angle of a corner [rad]; chords of a curve meet at smaller angles
    double sum_of_deficits = 0;
    for (const Outline &outline : contact_outlines(triangulation))
    {
      std::vector<double> angles;
      const std::size_t n = outline.size();
      for (std::size_t i = 0; i < n; ++i)
      {
        radii.push_back(std::hypot(outline[i][0], outline[i][1]));
        const double angle = exterior_angle(outline[(i + n - 1) % n], outline[i], outline[(i + 1) % n]);
        angles.push_back(angle < corner ? angle : 0);
      }
      for (std::size_t i = 0; i < n; ++i)
      {
        const double turn = (angles[i] + angles[(i + 1) % n]) / 2;
        sum_of_deficits += turn > 1e-9 ? 1 - std::sin(turn) / turn : 0;
      }
    }
    area_deficit = sum_of_deficits / static_cast<double>(radii.size());
    std::sort(radii.begin(), radii.end());
  }

  bool is_round() const
  {
    const double tolerance = 1e-6 * middle();
    return std::all_of(radii.begin(), radii.end(),
                       [&](double radius)
                       { return radius - radii.front() < tolerance || radii.back() - radius < tolerance; });
  }

  double middle() const { return radii.empty() ? 0 : (radii.front() + radii.back()) / 2; }

  std::vector<double> radii; ///< radii of the outlines' points, ascending
  double area_deficit = 0;   ///< relative area loss of the land, because its border consists of chords
};

void attach_cylinder(Triangulation<3> &triangulation)
{
  for (const auto &cell : triangulation.active_cell_iterators())
    for (const auto &face : cell->face_iterators())
      if (is_on(face, FootBoundary::contact_zone))
        cell->set_all_manifold_ids(cylinder_id);
}

} // namespace

MeshReport read_foot_mesh(const std::string &file_name, Triangulation<3> &triangulation,
                          const MeshFileOptions &marks)
{
  Triangulation<3> serial;
  const MeshContent file = read_hexahedra(file_name, marks.unit, serial);
  const std::map<types::boundary_id, double> heights = heights_by_id(serial);
  mark(marks, serial);
  require_boundaries(file_name, marks, heights, file.names, serial);
  const RimBorder border(serial);
  if (file.is_second_order && !border.is_round())
    throw std::invalid_argument("Mesh file = " + file_name +
                                " has hexahedra of second order on a rim that is not round, and their inner "
                                "nodes cannot be kept; export smaller hexahedra of first order.");

  MeshReport report;
  report.round_rim = border.is_round();
  report.rim_radius = border.middle();
  report.n_symmetry_sectors = n_symmetry_sectors(serial);
  report.land_area_deficit = report.round_rim ? 0 : border.area_deficit;
  if (report.round_rim)
    attach_cylinder(serial);
  triangulation.copy_triangulation(serial);
  if (report.round_rim)
    triangulation.set_manifold(cylinder_id, CylindricalManifold<3>(2));
  return report;
}

void move_to_crown(const GlassProfile &profile, Triangulation<3> &triangulation)
{
  std::set<unsigned int> moved;
  for (const auto &face : triangulation.active_face_iterators())
    if (is_on(face, FootBoundary::contact_zone))
      for (const unsigned int v : face->vertex_indices())
        if (moved.insert(face->vertex_index(v)).second)
          face->vertex(v)[2] += profile.gap(std::hypot(face->vertex(v)[0], face->vertex(v)[1]));
}

void write_msh(const Triangulation<3> &triangulation, std::ostream &stream)
{
  stream << std::setprecision(17) << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Comments\n"
         << "Foot mesh written by Stemware\n$EndComments\n$Nodes\n"
         << triangulation.n_vertices() << '\n';
  for (unsigned int v = 0; v < triangulation.n_vertices(); ++v)
    stream << v + 1 << ' ' << triangulation.get_vertices()[v] << '\n';
  stream << "$EndNodes\n$Elements\n";

  std::ostringstream elements;
  unsigned int n_elements = 0;
  for (const auto &face : triangulation.active_face_iterators())
    if (face->at_boundary() && face->boundary_id() != 0)
    {
      elements << ++n_elements << " 3 2 " << face->boundary_id() << ' ' << face->boundary_id();
      for (const unsigned int v : { 0u, 1u, 3u, 2u })
        elements << ' ' << face->vertex_index(v) + 1;
      elements << '\n';
    }
  for (const auto &cell : triangulation.active_cell_iterators())
  {
    elements << ++n_elements << " 5 2 0 0";
    for (const unsigned int v : { 0u, 1u, 3u, 2u, 4u, 5u, 7u, 6u })
      elements << ' ' << cell->vertex_index(v) + 1;
    elements << '\n';
  }
  stream << n_elements << '\n' << elements.str() << "$EndElements\n";
}

void write_mesh_vtu(const Triangulation<3> &triangulation, std::ostream &stream)
{
  const std::vector<double> of_cells = scaled_jacobians(triangulation);
  const Vector<double> jacobians(of_cells.begin(), of_cells.end());
  Vector<double> ids(triangulation.n_active_cells());
  for (const auto &cell : triangulation.active_cell_iterators())
    for (const auto &face : cell->face_iterators())
      if (double &id = ids(cell->active_cell_index()); face->at_boundary())
        id = std::max<double>(id, face->boundary_id());
  DataOut<3> output;
  output.attach_triangulation(triangulation);
  output.add_data_vector(jacobians, "scaled_jacobian");
  output.add_data_vector(ids, "boundary_id");
  output.build_patches();
  DataOutBase::VtkFlags flags;
  flags.print_date_and_time = false; // for reproducible files
  output.set_flags(flags);
  std::ostringstream text;
  output.write_vtu(text);
  const std::string file = text.str();
  const std::size_t root = file.find("<VTKFile");
  stream << file.substr(0, root) << "<!-- Foot mesh written by Stemware -->\n" << file.substr(root);
}

} // namespace stemware::fem
