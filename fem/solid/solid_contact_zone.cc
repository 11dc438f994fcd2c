#include "fem/solid/solid_contact_zone.h"

#include "fem/contact/line_integral.h"
#include "fem/geometry/boundary_ids.h"
#include "fem/solid/solid_level.h"
#include "ring_model/load/constants.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>

namespace stemware::fem
{

using namespace dealii;
using types::global_dof_index;

namespace
{

/// Contact face, or a quarter of it, sampled at 3 x 3 points for biquadratic interpolation.
struct SampledFace
{
  std::vector<global_dof_index> dofs;               ///< vertical dofs with support on the face
  std::vector<Eigen::Matrix3d> shapes;              ///< values at the samples [s, t], one matrix per dof
  std::array<std::array<Point<3>, 3>, 3> positions; ///< positions of the samples [s][t]

  void add(global_dof_index dof, const Eigen::Matrix3d &values)
  {
    const auto place = std::find(dofs.begin(), dofs.end(), dof);
    if (place != dofs.end())
    {
      shapes[static_cast<std::size_t>(place - dofs.begin())] += values;
      return;
    }
    dofs.push_back(dof);
    shapes.push_back(values);
  }

  Tensor<1, 3> edge_direction(unsigned int direction) const
  {
    return direction == 0 ? positions[2][1] - positions[0][1] : positions[1][2] - positions[1][0];
  }

  void orient()
  {
    const Point<3> centre = positions[1][1];
    const auto radial_share = [&](unsigned int direction)
    {
      const Tensor<1, 3> edge = edge_direction(direction);
      return std::abs(edge[0] * centre[0] + edge[1] * centre[1]) / edge.norm();
    };
    if (radial_share(0) >= radial_share(1))
      return;
    for (Eigen::Matrix3d &shape : shapes)
      shape.transposeInPlace();
    for (unsigned int s = 0; s < 3; ++s)
      for (unsigned int t = 0; t < s; ++t)
        std::swap(positions[s][t], positions[t][s]);
  }
};

std::vector<SampledFace> sample_faces(const SolidLevel &mesh)
{
  const FiniteElement<3> &element = mesh.element;
  // Above degree 2, the shape functions are approximated by a quadratic on each half of an edge.
  const unsigned int n_parts = element.degree > 2 ? 2 : 1;
  const unsigned int n_samples = 2 * n_parts + 1;
  const QIterated<2> equidistant(QTrapezoid<1>(), 2 * n_parts); // the first direction runs fastest
  FEFaceValues<3> fe_values(mesh.mapping, element, equidistant, update_values | update_quadrature_points);
  std::vector<global_dof_index> cell_dofs(element.n_dofs_per_cell());
  std::vector<SampledFace> faces;
  for (const auto &cell : mesh.dof_handler.active_cell_iterators())
    for (const unsigned int f : cell->face_indices())
    {
      if (!cell->is_locally_owned() || !is_on(cell->face(f), FootBoundary::contact_zone))
        continue;
      fe_values.reinit(cell, f);
      cell->get_dof_indices(cell_dofs);
      for (unsigned int part = 0; part < n_parts * n_parts; ++part)
      {
        const unsigned int first = 2 * (part / n_parts * n_samples + part % n_parts);
        const auto sample = [&](unsigned int s, unsigned int t) { return first + t * n_samples + s; };
        SampledFace face;
        for (unsigned int i = 0; i < cell_dofs.size(); ++i)
        {
          if (element.system_to_component_index(i).first != 2 || !element.has_support_on_face(i, f))
            continue;
          Eigen::Matrix3d values;
          for (unsigned int s = 0; s < 3; ++s)
            for (unsigned int t = 0; t < 3; ++t)
              values(s, t) = fe_values.shape_value(i, sample(s, t));
          if (!mesh.constraints.is_constrained(cell_dofs[i]))
            face.add(cell_dofs[i], values);
          else
            for (const auto &[dof, weight] : *mesh.constraints.get_constraint_entries(cell_dofs[i]))
              face.add(dof, weight * values);
        }
        for (unsigned int s = 0; s < 3; ++s)
          for (unsigned int t = 0; t < 3; ++t)
            face.positions[s][t] = fe_values.quadrature_point(sample(s, t));
        face.orient();
        faces.push_back(face);
      }
    }
  return faces;
}

/// Returns the line of @p face at @p eta in [-1, 1], the coordinate of the second direction, with the
/// quadrature weight @p weight.
ContactLine make_line(const SampledFace &face, double eta, double weight, const ContactNodes &nodes,
                      const SolidGap &gap)
{
  const Eigen::Vector3d value = line_shape(eta);
  const Eigen::Vector3d slope(eta - 0.5, -2 * eta, eta + 0.5);
  ContactLine line;
  line.shape.resize(3, static_cast<Eigen::Index>(face.dofs.size()));
  for (unsigned int i = 0; i < face.dofs.size(); ++i)
  {
    line.nodes.push_back(nodes.find(face.dofs[i]));
    line.shape.col(i) = face.shapes[i] * value;
  }
  for (unsigned int s = 0; s < 3; ++s)
  {
    Point<3> position;
    Tensor<1, 3> across;
    for (unsigned int t = 0; t < 3; ++t)
    {
      position += value(t) * face.positions[s][t];
      across += slope(t) * face.positions[s][t];
    }
    line.position.row(s) << position[0], position[1];
    line.transverse_tangent.row(s) << weight * across[0], weight * across[1];
    line.gap(s) = position[2] + gap(position[0], position[1]);
  }
  const Eigen::RowVector2d middle = line.position.row(1);
  const Eigen::RowVector2d transverse_tangent = line.transverse_tangent.row(1);
  line.azimuth = std::atan2(middle(1), middle(0));
  line.azimuth_width =
    std::abs(middle(0) * transverse_tangent(1) - middle(1) * transverse_tangent(0)) / middle.squaredNorm();
  return line;
}

/// Calls @p visit(cell, shape, node, dofs of the cell) once for each owned node, with one of this rank's
/// cells at the node and the node's shape function in this cell. The cell may have no contact face.
template <typename Visit>
void for_each_own_node(const SolidLevel &mesh, const ContactNodes &nodes, const Visit &visit)
{
  const FiniteElement<3> &element = mesh.element;
  std::vector<bool> is_visited(nodes.n_owned_nodes(), false);
  std::vector<global_dof_index> cell_dofs(element.n_dofs_per_cell());
  for (const auto &cell : mesh.dof_handler.active_cell_iterators())
  {
    if (!cell->is_locally_owned())
      continue;
    cell->get_dof_indices(cell_dofs);
    for (unsigned int i = 0; i < cell_dofs.size(); ++i)
    {
      if (element.system_to_component_index(i).first != 2)
        continue;
      const unsigned int node = nodes.find(cell_dofs[i]);
      if (node >= nodes.n_owned_nodes() || is_visited[node])
        continue;
      is_visited[node] = true;
      visit(cell, i, node, cell_dofs);
    }
  }
}

void describe_nodes(const SolidLevel &mesh, const ContactNodes &nodes, const SolidGap &gap,
                    ContactSurface &surface)
{
  const std::vector<Point<3>> &points = mesh.element.get_unit_support_points();
  Eigen::MatrixX3d coordinates(nodes.n_owned_nodes(), 3);
  for_each_own_node(mesh, nodes,
                    [&](const auto &cell, unsigned int shape, unsigned int node, const auto &)
                    {
                      const Point<3> position = mesh.mapping.transform_unit_to_real_cell(cell, points[shape]);
                      coordinates.row(node) << position[0], position[1], position[2];
                    });
  surface.node_position.resize(nodes.n_nodes(), 2);
  for (Eigen::Index d = 0; d < 2; ++d)
    surface.node_position.col(d) = nodes.spread(coordinates.col(d));
  surface.node_gap = nodes.spread(coordinates.col(2));
  for (Eigen::Index i = 0; i < surface.node_gap.size(); ++i)
    surface.node_gap(i) += gap(surface.node_position(i, 0), surface.node_position(i, 1));
}

void measure(ContactSurface &surface, const ContactNodes &nodes, unsigned int lines_per_face)
{
  Eigen::VectorXd areas = Eigen::VectorXd::Zero(surface.n_nodes());
  bool are_radial = true, is_crowned = false;
  double total_width = 0, inner = std::numeric_limits<double>::max(), outer = 0;
  for (const ContactLine &line : surface.lines)
  {
    add_node_areas(line, areas);
    total_width += line.azimuth_width;
    const Eigen::RowVector2d begin = line.position.row(0);
    const Eigen::RowVector2d end = line.position.row(2);
    const double sine = std::abs(begin(0) * end(1) - begin(1) * end(0)) / (begin.norm() * end.norm());
    are_radial = are_radial && sine < 1e-9;
    // Minimum slope of a crown, above the slope of a flat land with waviness.
    constexpr double steep = 1e-3;
    const double rise = line.gap.maxCoeff() - line.gap.minCoeff();
    is_crowned = is_crowned || rise > steep * (end - begin).norm();
    inner = std::min(inner, line.position.rowwise().norm().minCoeff());
    outer = std::max(outer, line.position.rowwise().norm().maxCoeff());
  }
  surface.node_area = nodes.spread(nodes.summed(areas));
  surface.lines_are_radial = !surface.parts.any(!are_radial);
  surface.is_crowned = surface.parts.any(is_crowned);
  // Minimum ratio of inner to outer radius of a ring. A smaller hole is an artefact of the cells at the axis.
  constexpr double min_hole = 0.1;
  surface.is_ring = surface.parts.min(inner) > min_hole * surface.parts.max(outer);
  const double n_faces = surface.parts.sum(static_cast<double>(surface.lines.size())) / lines_per_face;
  surface.n_sectors = static_cast<unsigned int>(
    std::max(1., std::round(2 * ring::pi * n_faces / surface.parts.sum(total_width))));
}

} // namespace

std::vector<HorizontalPlaces> horizontal_places(const SolidLevel &mesh, const ContactNodes &nodes)
{
  const FiniteElement<3> &element = mesh.element;
  const IndexSet &owned = mesh.dof_handler.locally_owned_dofs();
  std::vector<HorizontalPlaces> places;
  for_each_own_node(
    mesh, nodes,
    [&](const auto &, unsigned int shape, unsigned int node, const std::vector<global_dof_index> &cell_dofs)
    {
      const unsigned int support = element.system_to_component_index(shape).second;
      const auto place = [&](unsigned int component)
      {
        const auto dof = cell_dofs[element.component_to_system_index(component, support)];
        return static_cast<unsigned int>(owned.index_within_set(dof));
      };
      places.push_back({ node, place(0), place(1) });
    });
  return places;
}

std::vector<global_dof_index> contact_dofs(const SolidLevel &mesh)
{
  std::set<global_dof_index> dofs;
  for (const SampledFace &face : sample_faces(mesh))
    dofs.insert(face.dofs.begin(), face.dofs.end());
  return { dofs.begin(), dofs.end() };
}

SolidContactZone describe_contact_zone(const SolidLevel &mesh, const ContactNodes &nodes, const SolidGap &gap,
                                       unsigned int lines_per_face)
{
  const std::vector<SampledFace> faces = sample_faces(mesh);
  SolidContactZone zone;
  zone.surface.parts = nodes.parts();
  zone.surface.n_ghost_nodes = nodes.n_nodes() - nodes.n_owned_nodes();
  if (!zone.surface.parts.any(!faces.empty()))
    throw std::invalid_argument("The mesh has no contact zone: no boundary face carries the id 2; mark the "
                                "faces that may touch the table.");
  describe_nodes(mesh, nodes, gap, zone.surface);
  const QGauss<1> gauss(lines_per_face);
  double smallest = std::numeric_limits<double>::max();
  for (const SampledFace &face : faces)
  {
    for (unsigned int q = 0; q < gauss.size(); ++q)
      zone.surface.lines.push_back(
        make_line(face, 2 * gauss.point(q)[0] - 1, 2 * gauss.weight(q), nodes, gap));
    for (unsigned int direction = 0; direction < 2; ++direction)
      smallest = std::min(smallest, face.edge_direction(direction).norm());
  }
  measure(zone.surface, nodes, lines_per_face);
  zone.smallest_cell = zone.surface.parts.min(smallest);
  return zone;
}

} // namespace stemware::fem
