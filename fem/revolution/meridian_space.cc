#include "fem/revolution/meridian_space.h"

#include "fem/geometry/boundary_ids.h"

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_tools.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparse_matrix.h>

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <string>

namespace stemware::fem
{

using namespace dealii;

namespace
{

constexpr unsigned int radial = 0;
constexpr unsigned int azimuthal = 1;
constexpr unsigned int vertical = 2;

} // namespace

MeridianSpace::MeridianSpace(const Triangulation<2> &triangulation, const ElasticMaterial &material,
                             unsigned int degree)
    : curves(degree)
    , element(FE_Q<2>(degree), 3)
    , dofs(triangulation)
{
  dofs.distribute_dofs(element);
  stiffness = std::make_unique<MeridianStiffness>(curves, dofs, material);
  find_nodes();
}

double MeridianSpace::contact_radius(unsigned int i) const
{
  return points[contact_nodes[i][vertical]][0];
}

std::vector<LowerTriangle> MeridianSpace::assembled(const std::vector<std::array<double, 3>> &sums,
                                                    const AffineConstraints<double> &constraints) const
{
  DynamicSparsityPattern dynamic_pattern(dofs.n_dofs());
  DoFTools::make_sparsity_pattern(dofs, dynamic_pattern, constraints, false);
  SparsityPattern pattern;
  pattern.copy_from(dynamic_pattern);
  SparseMatrix<double> matrix(pattern);
  std::vector<LowerTriangle> matrices;
  for (const std::array<double, 3> &factors : sums)
  {
    stiffness->assemble(factors, constraints, matrix);
    matrices.push_back(lower_triangle_of(matrix));
  }
  return matrices;
}

MeridianSpace::Factors::Factors(const MeridianSpace &space, unsigned int harmonic)
    : constraints(space.make_constraints(harmonic))
{
  factors.compute(space.assembled({ MeridianStiffness::factors_of(harmonic) }, constraints).front());
  if (factors.info() != Eigen::Success)
    throw std::runtime_error("The stiffness of harmonic " + std::to_string(harmonic) +
                             " is not positive definite: the mesh is distorted or the body is not fixed.");
}

void MeridianSpace::Factors::solve(Vector<double> &forces) const
{
  Eigen::Map<Eigen::VectorXd> values(forces.begin(), forces.size());
  values = factors.solve(values).eval();
  constraints.distribute(forces);
}

const MeridianSpace::Factors &MeridianSpace::factors(unsigned int harmonic) const
{
  {
    const std::lock_guard<std::mutex> lock(mutex);
    if (const auto found = by_harmonic.find(harmonic); found != by_harmonic.end())
      return *found->second;
  }
  auto made = std::make_unique<const Factors>(*this, harmonic);
  const std::lock_guard<std::mutex> lock(mutex);
  return *by_harmonic.emplace(harmonic, std::move(made)).first->second;
}

MeridianSpace::Compliances::Compliances(const MeridianSpace &space, unsigned int harmonic, Eigen::Index first,
                                        Eigen::Index size)
    : constraints(space.make_constraints(harmonic))
    , n_nodes(size)
{
  for (const unsigned int component : { vertical, radial, azimuthal })
    for (Eigen::Index i = first; i < first + size; ++i)
      of_contact.push_back(
        static_cast<unsigned int>(space.contact_nodes[static_cast<std::size_t>(i)][component]));
  std::vector<std::array<double, 3>> sums = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
  if (harmonic < 2)
    sums = { MeridianStiffness::factors_of(harmonic) };
  for (const LowerTriangle &matrix : space.assembled(sums, constraints))
  {
    parts.emplace_back(matrix.coeffs());
    if (!inverse)
      inverse = std::make_unique<BlockInverse>(matrix, of_contact);
  }
}

HarmonicCompliance MeridianSpace::Compliances::operator()(unsigned int harmonic) const
{
  const std::array<double, 3> factors = MeridianStiffness::factors_of(harmonic);
  Eigen::MatrixXd displacements = (*inverse)(
    parts.size() == 1 ? parts[0] : factors[0] * parts[0] + factors[1] * parts[1] + factors[2] * parts[2],
    static_cast<unsigned int>(n_nodes));
  // Only contact nodes on the axis are constrained.
  for (Eigen::Index i = 0; i < 3 * n_nodes; ++i)
    if (const auto *entries = constraints.get_constraint_entries(of_contact[static_cast<std::size_t>(i)]))
    {
      displacements.row(i).setZero();
      if (i < n_nodes)
        displacements.col(i).setZero();
      for (const auto &[dof, factor] : *entries)
        displacements.row(i) +=
          factor *
          displacements.row(std::find(of_contact.begin(), of_contact.end(), dof) - of_contact.begin());
    }
  HarmonicCompliance result;
  result.normal = displacements.topRows(n_nodes);
  result.radial = displacements.middleRows(n_nodes, n_nodes).transpose();
  result.azimuthal = displacements.bottomRows(n_nodes).transpose();
  result.normal = (result.normal + result.normal.transpose()).eval() / 2;
  return result;
}

void MeridianSpace::find_nodes()
{
  points.resize(dofs.n_dofs());
  DoFTools::map_dofs_to_support_points(mapping(), dofs, points);
  const IndexSet on_contact = DoFTools::extract_boundary_dofs(
    dofs, ComponentMask(), { static_cast<types::boundary_id>(FootBoundary::contact_zone) });
  std::vector<NodeDofs> nodes;
  std::vector<Dof> cell_dofs(element.n_dofs_per_cell());
  std::vector<bool> seen(dofs.n_dofs(), false);
  for (const auto &cell : dofs.active_cell_iterators())
  {
    cell->get_dof_indices(cell_dofs);
    for (unsigned int k = 0; k < element.n_dofs_per_cell() / 3; ++k)
    {
      NodeDofs node{};
      for (unsigned int c = 0; c < 3; ++c)
        node[c] = cell_dofs[element.component_to_system_index(c, k)];
      if (seen[node[radial]])
        continue;
      seen[node[radial]] = true;
      nodes.push_back(node);
    }
  }
  const auto radius = [&](const NodeDofs &node) { return points[node[radial]][0]; };
  std::copy_if(nodes.begin(), nodes.end(), std::back_inserter(contact_nodes),
               [&](const NodeDofs &node) { return on_contact.is_element(node[radial]); });
  if (contact_nodes.size() < 2)
    throw std::invalid_argument(
      "The meridional mesh has no contact zone: no boundary face carries the id 2.");
  std::sort(contact_nodes.begin(), contact_nodes.end(),
            [&](const NodeDofs &a, const NodeDofs &b) { return radius(a) < radius(b); });
  const double tolerance = 1e-9 * radius(contact_nodes.back());
  std::copy_if(nodes.begin(), nodes.end(), std::back_inserter(axis_nodes),
               [&](const NodeDofs &node) { return radius(node) <= tolerance; });
}

AffineConstraints<double> MeridianSpace::make_constraints(unsigned int harmonic) const
{
  AffineConstraints<double> constraints;
  DoFTools::make_hanging_node_constraints(dofs, constraints);
  const auto hold = [&](Dof dof)
  {
    if (!constraints.is_constrained(dof))
      constraints.add_line(dof);
  };
  DoFTools::make_zero_boundary_constraints(dofs, static_cast<types::boundary_id>(FootBoundary::stem_cut),
                                           constraints);
  for (const NodeDofs &node : axis_nodes)
  {
    if (harmonic != 1)
    {
      hold(node[radial]);
      hold(node[azimuthal]);
    }
    else if (!constraints.is_constrained(node[azimuthal]))
    {
      constraints.add_line(node[azimuthal]);
      constraints.add_entry(node[azimuthal], node[radial], -1);
    }
    if (harmonic != 0)
      hold(node[vertical]);
  }
  constraints.close();
  return constraints;
}

} // namespace stemware::fem
