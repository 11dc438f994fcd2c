#include "fem/geometry/mesh_io.h"

#include "fem/geometry/boundary_ids.h"
#include "fem/geometry/mesh_content.h"
#include "fem/geometry/mesh_quality.h"

#include <deal.II/grid/manifold_lib.h>
#include <deal.II/grid/tria.h>
#include <deal.II/numerics/data_out.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <limits>
#include <map>
#include <ostream>
#include <sstream>
#include <stdexcept>

namespace stemware::fem
{

using namespace dealii;

namespace
{

constexpr types::manifold_id cylinder_id = 1;
constexpr auto contact_id = static_cast<types::boundary_id>(FootBoundary::contact_zone);
constexpr auto stem_cut_id = static_cast<types::boundary_id>(FootBoundary::stem_cut);

unsigned int count_faces(const Triangulation<3> &triangulation, types::boundary_id id)
{
  unsigned int n_faces = 0;
  for (const auto &face : triangulation.active_face_iterators())
    n_faces += face->at_boundary() && face->boundary_id() == id;
  return n_faces;
}

/// The faces of the surface with the cells that they belong to.
template <typename Visit>
void for_each_boundary_face(const Triangulation<3> &triangulation, const Visit &visit)
{
  for (const auto &cell : triangulation.active_cell_iterators())
    for (const unsigned int f : cell->face_indices())
      if (cell->face(f)->at_boundary())
        visit(cell, cell->face(f));
}

using Face = Triangulation<3>::face_iterator;

/// Whether all corners of @p face are at most @p distance from the height @p z.
bool lies_at(const Face &face, double z, double distance)
{
  for (const unsigned int v : face->vertex_indices())
    if (std::abs(face->vertex(v)[2] - z) > distance)
      return false;
  return true;
}

/// The stem cut is the top of the mesh where no face has its id; the contact zone what lies low.
void mark_by_height(const MeshMarks &marks, Triangulation<3> &triangulation)
{
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
  for_each_boundary_face(triangulation,
                         [&](const auto &, const Face &face)
                         {
                           for (const unsigned int v : face->vertex_indices())
                           {
                             lowest = std::min(lowest, face->vertex(v)[2]);
                             highest = std::max(highest, face->vertex(v)[2]);
                           }
                         });
  const bool has_stem_cut = count_faces(triangulation, stem_cut_id) > 0;
  for_each_boundary_face(triangulation,
                         [&](const auto &cell, const Face &face)
                         {
                           const double upward = face->center()[2] - cell->center()[2];
                           if (upward < 0 && lies_at(face, lowest, marks.contact_height))
                             face->set_boundary_id(contact_id);
                           else if (face->boundary_id() == contact_id)
                             face->set_boundary_id(0);
                           if (!has_stem_cut && upward > 0 &&
                               lies_at(face, highest, 1e-6 * (highest - lowest)))
                             face->set_boundary_id(stem_cut_id);
                         });
}

/// Gives the faces of @p marks the ids of FootBoundary, which others lose.
void mark(const MeshMarks &marks, Triangulation<3> &triangulation)
{
  for_each_boundary_face(triangulation,
                         [&](const auto &, const Face &face)
                         {
                           types::boundary_id id = face->boundary_id();
                           if (id == marks.contact_id)
                             id = contact_id;
                           else if (id == marks.stem_id)
                             id = stem_cut_id;
                           else if (id == contact_id || id == stem_cut_id)
                             id = 0;
                           face->set_boundary_id(id);
                         });
  if (marks.contact_height > 0)
    mark_by_height(marks, triangulation);
}

void require_boundaries(const std::string &file_name, const MeshMarks &marks,
                        const std::vector<types::boundary_id> &ids, const Triangulation<3> &triangulation)
{
  std::string known = "; of its faces ";
  for (const types::boundary_id id : ids)
    known += id == 0 ? "" : (known.back() == ' ' ? "" : ", ") + std::to_string(id);
  known = known.back() == ' ' ? "; none of its faces has an id" : known + " are known";
  const std::string subject = "Mesh file = " + file_name;
  if (count_faces(triangulation, contact_id) == 0)
    throw std::invalid_argument(subject + " has no contact zone" + known +
                                "; give the faces that may touch the table the id " +
                                std::to_string(marks.contact_id) + ", or set Contact/Mesh contact height.");
  if (count_faces(triangulation, stem_cut_id) == 0)
    throw std::invalid_argument(subject + " has no stem cut" + known +
                                "; give the faces where the stem was cut the id " +
                                std::to_string(marks.stem_id) + ".");
}

/// The edges round the contact zone: those that belong to one contact face only.
struct RimBorder
{
  explicit RimBorder(const Triangulation<3> &triangulation)
  {
    std::map<unsigned int, std::pair<unsigned int, std::array<Point<3>, 2>>> edges;
    for (const auto &face : triangulation.active_face_iterators())
      if (face->at_boundary() && face->boundary_id() == contact_id)
        for (unsigned int l = 0; l < 4; ++l)
        {
          auto &[n_faces, ends] = edges[face->line(l)->index()];
          ++n_faces;
          ends = { face->line(l)->vertex(0), face->line(l)->vertex(1) };
        }
    double sum_of_deficits = 0;
    unsigned int n_edges = 0;
    for (const auto &[index, edge] : edges)
    {
      if (edge.first != 1)
        continue;
      const auto &[begin, end] = edge.second;
      radii.push_back(std::hypot(begin[0], begin[1]));
      radii.push_back(std::hypot(end[0], end[1]));
      const double turn =
        std::abs(std::atan2(begin[0] * end[1] - begin[1] * end[0], begin[0] * end[0] + begin[1] * end[1]));
      sum_of_deficits += turn > 0 ? 1 - std::sin(turn) / turn : 0;
      ++n_edges;
    }
    area_deficit = sum_of_deficits / n_edges;
    std::sort(radii.begin(), radii.end());
  }

  /// Whether the radii are those of two circles, to 1e-6 of their mean.
  bool is_round() const
  {
    const double tolerance = 1e-6 * middle();
    return std::all_of(radii.begin(), radii.end(),
                       [&](double radius)
                       { return radius - radii.front() < tolerance || radii.back() - radius < tolerance; });
  }

  double middle() const { return (radii.front() + radii.back()) / 2; }

  std::vector<double> radii; ///< ascending
  double area_deficit = 0;   ///< of an annulus whose borders are chords that turn by as much as these edges
};

void attach_cylinder(Triangulation<3> &triangulation)
{
  for (const auto &cell : triangulation.active_cell_iterators())
    for (const unsigned int f : cell->face_indices())
      if (cell->face(f)->at_boundary() && cell->face(f)->boundary_id() == contact_id)
        cell->set_all_manifold_ids(cylinder_id);
}

} // namespace

MeshReport read_foot_mesh(const std::string &file_name, Triangulation<3> &triangulation,
                          const MeshMarks &marks)
{
  Triangulation<3> serial;
  const bool is_second_order = read_hexahedra(file_name, serial);
  const std::vector<types::boundary_id> ids = serial.get_boundary_ids();
  mark(marks, serial);
  require_boundaries(file_name, marks, ids, serial);
  const RimBorder border(serial);
  if (is_second_order && !border.is_round())
    throw std::invalid_argument("Mesh file = " + file_name +
                                " has hexahedra of second order on a rim that is not round, and their inner "
                                "nodes cannot be kept; export smaller hexahedra of first order.");

  MeshReport report;
  report.n_cells = serial.n_active_cells();
  report.n_contact_faces = count_faces(serial, contact_id);
  report.round_rim = border.is_round();
  report.rim_radius = border.middle();
  report.n_repetitions = n_repetitions(serial);
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
  std::vector<bool> moved(triangulation.n_vertices(), false);
  for (const auto &face : triangulation.active_face_iterators())
    if (face->at_boundary() && face->boundary_id() == contact_id)
      for (const unsigned int v : face->vertex_indices())
        if (!moved[face->vertex_index(v)])
        {
          moved[face->vertex_index(v)] = true;
          Point<3> &x = face->vertex(v);
          x[2] += profile.gap(std::hypot(x[0], x[1]));
        }
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
  Vector<double> quality(triangulation.n_active_cells()), boundary(triangulation.n_active_cells());
  const std::vector<double> jacobians = scaled_jacobians(triangulation);
  std::copy(jacobians.begin(), jacobians.end(), quality.begin());
  for (const auto &cell : triangulation.active_cell_iterators())
    for (const auto &face : cell->face_iterators())
      if (face->at_boundary())
        boundary(cell->active_cell_index()) =
          std::max<double>(boundary(cell->active_cell_index()), face->boundary_id());
  DataOut<3> data_out;
  DataOutBase::VtkFlags flags;
  flags.print_date_and_time = false; // equal meshes give equal files
  data_out.set_flags(flags);
  data_out.attach_triangulation(triangulation);
  data_out.add_data_vector(quality, "scaled_jacobian");
  data_out.add_data_vector(boundary, "boundary_id");
  data_out.build_patches();
  std::ostringstream text;
  data_out.write_vtu(text);
  const std::string file = text.str(), declaration = "?>\n";
  const std::size_t root = file.find(declaration) + declaration.size();
  stream << file.substr(0, root) << "<!-- Foot mesh written by Stemware -->\n" << file.substr(root);
}

} // namespace stemware::fem
