#include "fem/solid/solid_contact_zone.h"

#include "fem/contact/line_integral.h"
#include "fem/geometry/boundary_ids.h"

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

namespace stemware::fem
{

using namespace dealii;
using types::global_dof_index;

namespace
{

/// A contact face, or a quarter of one, sampled at the 3 x 3 points of a biquadratic: everything on it is
/// interpolated from these.
struct SampledFace
{
  std::vector<global_dof_index> dofs;               ///< vertical dofs with support on the face
  std::vector<Eigen::Matrix3d> shapes;              ///< per dof, values at the samples [s, t]
  std::array<std::array<Point<3>, 3>, 3> positions; ///< at the samples [s][t]

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

  /// Makes the first direction the more radial one.
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

/// Tensor product of @p n equidistant points from 0 to 1, first direction running fastest.
Quadrature<2> equidistant_samples(unsigned int n)
{
  std::vector<Point<2>> points;
  for (unsigned int t = 0; t < n; ++t)
    for (unsigned int s = 0; s < n; ++s)
      points.emplace_back(s / (n - 1.), t / (n - 1.));
  return Quadrature<2>(points);
}

std::vector<SampledFace> sample_faces(const Mapping<3> &mapping, const DoFHandler<3> &dof_handler,
                                      const AffineConstraints<double> &constraints)
{
  const FiniteElement<3> &element = dof_handler.get_fe();
  // Parabolas on half an edge stand for what is of a higher degree on the whole of it.
  const unsigned int n_parts = element.degree > 2 ? 2 : 1;
  const unsigned int n_samples = 2 * n_parts + 1;
  FEFaceValues<3> fe_values(mapping, element, equidistant_samples(n_samples),
                            update_values | update_quadrature_points);
  std::vector<global_dof_index> cell_dofs(element.n_dofs_per_cell());
  std::vector<SampledFace> faces;
  for (const auto &cell : dof_handler.active_cell_iterators())
    for (const unsigned int f : cell->face_indices())
    {
      if (!cell->is_locally_owned() || !cell->face(f)->at_boundary() ||
          cell->face(f)->boundary_id() != static_cast<types::boundary_id>(FootBoundary::contact_zone))
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
          if (!constraints.is_constrained(cell_dofs[i]))
            face.add(cell_dofs[i], values);
          else
            for (const auto &[dof, weight] : *constraints.get_constraint_entries(cell_dofs[i]))
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

/// Numbers on which all ranks agree: contact nodes in the order of their dofs.
std::vector<global_dof_index> gather_node_dofs(const std::vector<SampledFace> &faces,
                                               const MPI_Comm &communicator)
{
  std::vector<global_dof_index> local;
  for (const SampledFace &face : faces)
    local.insert(local.end(), face.dofs.begin(), face.dofs.end());
  std::vector<global_dof_index> all;
  for (const std::vector<global_dof_index> &part : Utilities::MPI::all_gather(communicator, local))
    all.insert(all.end(), part.begin(), part.end());
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

unsigned int index_of(const std::vector<global_dof_index> &sorted, global_dof_index dof)
{
  return static_cast<unsigned int>(std::lower_bound(sorted.begin(), sorted.end(), dof) - sorted.begin());
}

/// The line of @p face at @p eta in [-1, 1] of its second direction, standing for a breadth of @p weight.
ContactLine make_line(const SampledFace &face, double eta, double weight,
                      const std::vector<global_dof_index> &node_dofs, const SolidBody::Gap &gap)
{
  const Eigen::Vector3d value = line_shape(eta);
  const Eigen::Vector3d slope(eta - 0.5, -2 * eta, eta + 0.5);
  ContactLine line;
  line.shape.resize(3, static_cast<Eigen::Index>(face.dofs.size()));
  for (unsigned int i = 0; i < face.dofs.size(); ++i)
  {
    line.nodes.push_back(index_of(node_dofs, face.dofs[i]));
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

/// Lines cross the border of contact inside a face, where the line integrals are not smooth in eta: more
/// points than a smooth integrand needs.
constexpr unsigned int n_lines_per_face = 8;

using PackedLine = std::vector<double>;

PackedLine pack(const ContactLine &line)
{
  PackedLine packed = { static_cast<double>(line.nodes.size()), line.azimuth, line.azimuth_width };
  const auto append = [&](const auto &matrix)
  { packed.insert(packed.end(), matrix.data(), matrix.data() + matrix.size()); };
  append(line.position);
  append(line.transverse_tangent);
  append(line.gap);
  append(line.shape);
  packed.insert(packed.end(), line.nodes.begin(), line.nodes.end());
  return packed;
}

ContactLine unpack(const PackedLine &packed)
{
  ContactLine line;
  const auto n_nodes = static_cast<Eigen::Index>(packed[0]);
  line.azimuth = packed[1];
  line.azimuth_width = packed[2];
  const double *next = packed.data() + 3;
  const auto take = [&](auto &matrix)
  {
    std::copy(next, next + matrix.size(), matrix.data());
    next += matrix.size();
  };
  line.shape.resize(3, n_nodes);
  take(line.position);
  take(line.transverse_tangent);
  take(line.gap);
  take(line.shape);
  line.nodes.assign(next, next + n_nodes);
  return line;
}

std::vector<ContactLine> gather_lines(const std::vector<SampledFace> &faces,
                                      const std::vector<global_dof_index> &node_dofs,
                                      const SolidBody::Gap &gap, const MPI_Comm &communicator)
{
  const QGauss<1> gauss(n_lines_per_face);
  std::vector<PackedLine> local;
  for (const SampledFace &face : faces)
    for (unsigned int q = 0; q < gauss.size(); ++q)
      local.push_back(pack(make_line(face, 2 * gauss.point(q)[0] - 1, 2 * gauss.weight(q), node_dofs, gap)));
  std::vector<ContactLine> lines;
  for (const std::vector<PackedLine> &part : Utilities::MPI::all_gather(communicator, local))
    for (const PackedLine &packed : part)
      lines.push_back(unpack(packed));
  return lines;
}

/// Nodes lie at their shapes' support points, on cells of the zone or, where others hang on them, beside it.
void describe_nodes(const Mapping<3> &mapping, const DoFHandler<3> &dof_handler,
                    const std::vector<global_dof_index> &node_dofs, const SolidBody::Gap &gap,
                    ContactSurface &surface)
{
  const MPI_Comm &communicator = dof_handler.get_communicator();
  const FiniteElement<3> &element = dof_handler.get_fe();
  const std::vector<Point<3>> &points = element.get_unit_support_points();
  const auto n_nodes = static_cast<Eigen::Index>(node_dofs.size());
  std::vector<double> owners(node_dofs.size(), 0);
  std::vector<double> coordinates(3 * node_dofs.size(), 0);
  std::vector<global_dof_index> cell_dofs(element.n_dofs_per_cell());
  for (const auto &cell : dof_handler.active_cell_iterators())
  {
    if (!cell->is_locally_owned())
      continue;
    cell->get_dof_indices(cell_dofs);
    for (unsigned int i = 0; i < cell_dofs.size(); ++i)
    {
      const unsigned int node = index_of(node_dofs, cell_dofs[i]);
      if (node == node_dofs.size() || node_dofs[node] != cell_dofs[i] || owners[node] == 1)
        continue;
      const Point<3> position = mapping.transform_unit_to_real_cell(cell, points[i]);
      owners[node] = 1;
      for (unsigned int d = 0; d < 3; ++d)
        coordinates[3 * node + d] = position[d];
    }
  }
  Utilities::MPI::sum(owners, communicator, owners);
  Utilities::MPI::sum(coordinates, communicator, coordinates);
  surface.node_position.resize(n_nodes, 2);
  surface.node_gap.resize(n_nodes);
  for (unsigned int i = 0; i < node_dofs.size(); ++i)
  {
    const double x = coordinates[3 * i] / owners[i];
    const double y = coordinates[3 * i + 1] / owners[i];
    surface.node_position.row(i) << x, y;
    surface.node_gap(i) = coordinates[3 * i + 2] / owners[i] + gap(x, y);
  }
}

void measure(ContactSurface &surface)
{
  surface.node_area = Eigen::VectorXd::Zero(surface.node_gap.size());
  surface.lines_are_radial = true;
  double total_width = 0;
  for (const ContactLine &line : surface.lines)
  {
    add_node_areas(line, surface.node_area);
    total_width += line.azimuth_width;
    const Eigen::RowVector2d begin = line.position.row(0);
    const Eigen::RowVector2d end = line.position.row(2);
    const double sine = std::abs(begin(0) * end(1) - begin(1) * end(0)) / (begin.norm() * end.norm());
    surface.lines_are_radial = surface.lines_are_radial && sine < 1e-9;
  }
  const double n_faces = static_cast<double>(surface.lines.size()) / n_lines_per_face;
  surface.n_sectors =
    static_cast<unsigned int>(std::max(1., std::round(2 * numbers::PI * n_faces / total_width)));
}

double smallest_edge(const std::vector<SampledFace> &faces, const MPI_Comm &communicator)
{
  double smallest = std::numeric_limits<double>::max();
  for (const SampledFace &face : faces)
    for (unsigned int direction = 0; direction < 2; ++direction)
      smallest = std::min(smallest, face.edge_direction(direction).norm());
  return Utilities::MPI::min(smallest, communicator);
}

} // namespace

std::vector<HorizontalDofs> owned_horizontal_dofs(const DoFHandler<3> &dof_handler,
                                                  const std::vector<global_dof_index> &node_dofs)
{
  const FiniteElement<3> &element = dof_handler.get_fe();
  const IndexSet &owned = dof_handler.locally_owned_dofs();
  std::vector<global_dof_index> cell_dofs(element.n_dofs_per_cell());
  std::vector<HorizontalDofs> result;
  std::vector<bool> known(node_dofs.size(), false);
  for (const auto &cell : dof_handler.active_cell_iterators())
  {
    if (!cell->is_locally_owned())
      continue;
    cell->get_dof_indices(cell_dofs);
    for (unsigned int i = 0; i < cell_dofs.size(); ++i)
    {
      const auto [component, place] = element.system_to_component_index(i);
      const unsigned int node = index_of(node_dofs, cell_dofs[i]);
      if (component != 2 || !owned.is_element(cell_dofs[i]) || node == node_dofs.size() ||
          node_dofs[node] != cell_dofs[i] || known[node])
        continue;
      known[node] = true;
      result.push_back({ node, cell_dofs[element.component_to_system_index(0, place)],
                         cell_dofs[element.component_to_system_index(1, place)] });
    }
  }
  return result;
}

SolidContactZone describe_contact_zone(const Mapping<3> &mapping, const DoFHandler<3> &dof_handler,
                                       const AffineConstraints<double> &constraints,
                                       const SolidBody::Gap &gap)
{
  const MPI_Comm &communicator = dof_handler.get_communicator();
  const std::vector<SampledFace> faces = sample_faces(mapping, dof_handler, constraints);
  SolidContactZone zone;
  zone.node_dofs = gather_node_dofs(faces, communicator);
  if (zone.node_dofs.empty())
    throw std::invalid_argument("The mesh has no contact zone: no boundary face carries the id 2; mark the "
                                "faces that may touch the table.");
  describe_nodes(mapping, dof_handler, zone.node_dofs, gap, zone.surface);
  zone.surface.lines = gather_lines(faces, zone.node_dofs, gap, communicator);
  measure(zone.surface);
  zone.smallest_cell = smallest_edge(faces, communicator);
  return zone;
}

} // namespace stemware::fem
