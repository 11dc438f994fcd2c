#include "fem/meridian_problem.h"

#include "fem/foot_mesh.h"
#include "fem/meridian_stiffness.h"

#include <deal.II/base/multithread_info.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/mapping_q1.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparse_direct.h>

#include <algorithm>
#include <atomic>
#include <stdexcept>
#include <string>
#include <thread>

namespace stemware::fem
{

using namespace dealii;

namespace
{

/// Displacement components of a meridional problem.
constexpr unsigned int radial = 0;
constexpr unsigned int azimuthal = 1;
constexpr unsigned int vertical = 2;

using Dof = types::global_dof_index;
using NodeDofs = std::array<Dof, 3>;

/// The finite-element space on one meridian, and its nodes on the contact zone and on the axis.
class MeridianProblem
{
public:
  MeridianProblem(const Triangulation<2> &triangulation, const ElasticMaterial &material, unsigned int degree)
      : element(FE_Q<2>(degree), 3)
      , dof_handler(triangulation)
  {
    dof_handler.distribute_dofs(element);
    stiffness = std::make_unique<MeridianStiffness>(dof_handler, material);
    find_nodes();
  }

  unsigned int n_dofs() const { return dof_handler.n_dofs(); }
  unsigned int n_contact_nodes() const { return static_cast<unsigned int>(contact_nodes.size()); }
  double contact_radius(unsigned int i) const { return points[contact_nodes[i][vertical]][0]; }

  /// Displacements of the contact nodes under a vertical unit force per radian on each of them; by
  /// reciprocity also the vertical displacements under radial and azimuthal ones.
  HarmonicCompliance compliance(unsigned int harmonic) const
  {
    const AffineConstraints<double> constraints = make_constraints(harmonic);
    DynamicSparsityPattern dynamic_pattern(dof_handler.n_dofs());
    DoFTools::make_sparsity_pattern(dof_handler, dynamic_pattern, constraints, false);
    SparsityPattern pattern;
    pattern.copy_from(dynamic_pattern);
    SparseMatrix<double> matrix(pattern);
    stiffness->assemble(harmonic, constraints, matrix);
    SparseDirectUMFPACK factors;
    factors.factorize(matrix);

    const unsigned int n_nodes = n_contact_nodes();
    HarmonicCompliance result;
    for (Eigen::MatrixXd *part : { &result.normal, &result.radial, &result.azimuthal })
      part->resize(n_nodes, n_nodes);
    Vector<double> displacement(dof_handler.n_dofs());
    for (unsigned int j = 0; j < n_nodes; ++j)
    {
      displacement = 0;
      displacement(contact_nodes[j][vertical]) = 1;
      factors.solve(displacement);
      constraints.distribute(displacement);
      for (unsigned int i = 0; i < n_nodes; ++i)
      {
        result.normal(i, j) = displacement(contact_nodes[i][vertical]);
        result.radial(j, i) = displacement(contact_nodes[i][radial]);
        result.azimuthal(j, i) = displacement(contact_nodes[i][azimuthal]);
      }
    }
    result.normal = (result.normal + result.normal.transpose()).eval() / 2;
    return result;
  }

private:
  void find_nodes()
  {
    points.resize(dof_handler.n_dofs());
    DoFTools::map_dofs_to_support_points(StaticMappingQ1<2>::mapping, dof_handler, points);
    std::array<std::vector<Dof>, 3> dofs;
    for (unsigned int c = 0; c < 3; ++c)
    {
      ComponentMask mask(3, false);
      mask.set(c, true);
      const IndexSet on_contact = DoFTools::extract_boundary_dofs(
        dof_handler, mask, { static_cast<types::boundary_id>(FootBoundary::contact_zone) });
      on_contact.fill_index_vector(dofs[c]);
      std::sort(dofs[c].begin(), dofs[c].end(), [&](Dof a, Dof b) { return points[a][0] < points[b][0]; });
    }
    if (dofs[0].size() < 2)
      throw std::invalid_argument(
        "The meridional mesh has no contact zone: no boundary face carries the id 2.");
    for (std::size_t i = 0; i < dofs[0].size(); ++i)
      contact_nodes.push_back({ dofs[radial][i], dofs[azimuthal][i], dofs[vertical][i] });
    find_axis();
  }

  /// Nodes at r = 0, one triple of dofs each; an annular section has none of them.
  void find_axis()
  {
    const double tolerance = 1e-9 * points[contact_nodes.back()[vertical]][0];
    std::vector<Dof> cell_dofs(element.n_dofs_per_cell());
    std::vector<bool> seen(dof_handler.n_dofs(), false);
    for (const auto &cell : dof_handler.active_cell_iterators())
    {
      cell->get_dof_indices(cell_dofs);
      for (unsigned int k = 0; k < element.n_dofs_per_cell() / 3; ++k)
      {
        NodeDofs node{};
        for (unsigned int c = 0; c < 3; ++c)
          node[c] = cell_dofs[element.component_to_system_index(c, k)];
        if (points[node[0]][0] > tolerance || seen[node[0]])
          continue;
        seen[node[0]] = true;
        axis_nodes.push_back(node);
      }
    }
  }

  /// Held boundary, hanging nodes, and what keeps the displacement single-valued on the axis: n = 0 moves
  /// along it, n = 1 across it (u_theta = -u_r), higher harmonics not at all.
  AffineConstraints<double> make_constraints(unsigned int harmonic) const
  {
    AffineConstraints<double> constraints;
    DoFTools::make_hanging_node_constraints(dof_handler, constraints);
    const auto hold = [&](Dof dof)
    {
      if (!constraints.is_constrained(dof))
        constraints.add_line(dof);
    };
    DoFTools::make_zero_boundary_constraints(
      dof_handler, static_cast<types::boundary_id>(FootBoundary::stem_cut), constraints);
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

  const FESystem<2> element;
  DoFHandler<2> dof_handler;
  std::unique_ptr<MeridianStiffness> stiffness;
  std::vector<Point<2>> points;
  std::vector<NodeDofs> contact_nodes; ///< ascending radius
  std::vector<NodeDofs> axis_nodes;
};

void solve_harmonics(const MeridianProblem &problem, unsigned int n_threads,
                     std::vector<HarmonicCompliance> &harmonics)
{
  std::atomic<unsigned int> next{ 0 };
  std::vector<std::exception_ptr> errors(n_threads);
  const auto work = [&](unsigned int thread)
  {
    try
    {
      for (unsigned int n = next++; n < harmonics.size(); n = next++)
        harmonics[n] = problem.compliance(n);
    }
    catch (...)
    {
      errors[thread] = std::current_exception();
    }
  };
  std::vector<std::thread> threads;
  for (unsigned int t = 1; t < n_threads; ++t)
    threads.emplace_back(work, t);
  work(0);
  for (std::thread &thread : threads)
    thread.join();
  for (const std::exception_ptr &error : errors)
    if (error)
      std::rethrow_exception(error);
}

} // namespace

ContactCompliance compute_compliance(const Triangulation<2> &triangulation, const ElasticMaterial &material,
                                     const MeridianOptions &options)
{
  material.validate();
  if (options.degree < 1 || options.degree > 4)
    throw std::invalid_argument("Degree = " + std::to_string(options.degree) +
                                " is not allowed for a body of revolution; give 1, 2, 3 or 4.");
  const MeridianProblem problem(triangulation, material, options.degree);
  ContactCompliance result;
  result.degree = options.degree;
  result.n_meridian_unknowns = problem.n_dofs();
  result.radii.resize(problem.n_contact_nodes());
  for (unsigned int i = 0; i < problem.n_contact_nodes(); ++i)
    result.radii(i) = problem.contact_radius(i);
  result.harmonics.resize(options.n_harmonics + 1);
  const unsigned int allowed = options.n_threads > 0 ? options.n_threads : MultithreadInfo::n_threads();
  solve_harmonics(problem, std::min(allowed, options.n_harmonics + 1), result.harmonics);
  return result;
}

} // namespace stemware::fem
