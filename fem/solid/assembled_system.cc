#include "fem/solid/assembled_system.h"

#include "fem/solid/binary_stream.h"
#include "fem/solid/conforming_mapping.h"
#include "fem/solid/mesh_hierarchy.h"
#include "fem/solid/stiffness_3d.h"

#include <deal.II/base/mpi.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/lac/trilinos_sparsity_pattern.h>

namespace stemware::fem
{

using namespace dealii;

namespace
{
/// Reduction of the residual by one linear solve; Newton's next step takes care of the rest.
constexpr double linear_reduction = 1e-9;
} // namespace

AssembledSystem::AssembledSystem(const Triangulation<3> &triangulation, const ElasticMaterial &material,
                                 const SolidBody::Gap &gap, const SolidOptions &options)
    : SolidSystem(material)
    , communicator(triangulation.get_communicator())
    , conforming(conforming_mapping(triangulation, options.straight_edges ? 1 : options.degree))
    , geometry(*conforming)
    , element(FE_Q<3>(options.degree), 3)
    , dof_handler(triangulation)
{
  dof_handler.distribute_dofs(element);
  locally_owned = dof_handler.locally_owned_dofs();
  constraints = clamp_stem_cut(dof_handler);
  assemble();
  const auto nodes =
    std::make_shared<const ContactNodes>(locally_owned, contact_dofs(dof_handler, constraints), communicator);
  zone = describe_contact_zone(geometry, dof_handler, constraints, nodes, gap);
  horizontal = horizontal_places(dof_handler, *nodes);
}

void AssembledSystem::assemble()
{
  const IndexSet locally_relevant = DoFTools::extract_locally_relevant_dofs(dof_handler);
  TrilinosWrappers::SparsityPattern sparsity(locally_owned, locally_owned, locally_relevant, communicator);
  DoFTools::make_sparsity_pattern(dof_handler, sparsity, constraints, false,
                                  Utilities::MPI::this_mpi_process(communicator));
  sparsity.compress();
  stiffness.reinit(sparsity);
  assemble_stiffness(geometry, dof_handler, material, constraints, stiffness);
  tangent.copy_from(stiffness);
  displacement.reinit(locally_owned, communicator);
}

AssembledSystem::Vector AssembledSystem::contact_load(const Eigen::VectorXd &forces) const
{
  Vector vector = scatter(forces);
  if (!has_friction)
    return vector;
  const Eigen::VectorXd own = zone.nodes->summed(forces);
  for (const auto &[node, x, y] : horizontal)
  {
    vector.begin()[x] += friction(node, 0) * own(node);
    vector.begin()[y] += friction(node, 1) * own(node);
  }
  return vector;
}

AssembledSystem::Vector AssembledSystem::scatter(const Eigen::VectorXd &parts) const
{
  Vector vector(locally_owned, communicator);
  const Eigen::VectorXd own = zone.nodes->summed(parts);
  for (unsigned int i = 0; i < own.size(); ++i)
    vector.begin()[zone.nodes->own_places()[i]] = own(i);
  return vector;
}

Eigen::VectorXd AssembledSystem::restrict(const Vector &vector) const
{
  Eigen::VectorXd own(zone.nodes->n_own_nodes());
  for (unsigned int i = 0; i < own.size(); ++i)
    own(i) = vector.begin()[zone.nodes->own_places()[i]];
  return zone.nodes->spread(own);
}

void AssembledSystem::set_tangent(const Eigen::SparseMatrix<double> &contact_tangent)
{
  tangent.copy_from(stiffness);
  for (const ContactNodes::Entry &entry : zone.nodes->own_rows(contact_tangent))
    tangent.add(entry.row, entry.column, entry.value);
  tangent.compress(VectorOperation::add);
}

AssembledSystem::Vector AssembledSystem::residual(const Eigen::VectorXd &forces) const
{
  Vector elastic(locally_owned, communicator);
  stiffness.vmult(elastic, displacement);
  Vector result = contact_load(forces);
  result -= elastic;
  return result;
}

Eigen::VectorXd AssembledSystem::contact_displacement() const
{
  return restrict(displacement);
}

NewtonIncrement AssembledSystem::solve(const Eigen::SparseMatrix<double> &contact_tangent,
                                       const Eigen::VectorXd &forces, const LinearConditions &conditions,
                                       const Eigen::Vector3d &motion)
{
  set_tangent(contact_tangent);
  const auto scatter_columns = [&](const Eigen::MatrixX3d &nodal) {
    return std::array<Vector, 3>{ scatter(nodal.col(0)), scatter(nodal.col(1)), scatter(nodal.col(2)) };
  };
  const SurfaceParts &parts = zone.surface.parts;
  const ScaledMotions motions(zone.surface);
  const Eigen::Matrix3d leaning =
    motions.scale.asDiagonal() * conditions.motion_weights() * motions.scale.asDiagonal();
  BorderedSystem system{ tangent, {}, {}, {} };
  const Eigen::MatrixX3d stiffened = contact_tangent * motions.modes;
  system.border = scatter_columns(stiffened);
  if (conditions.are_resultants())
    system.corner = parts.sum(motions.modes.transpose() * stiffened);
  else
  {
    const Eigen::MatrixX3d weights = conditions.weights() * motions.scale.asDiagonal();
    system.condition_border = scatter_columns(contact_tangent * weights);
    system.corner = parts.sum(weights.transpose() * stiffened) - leaning;
  }
  const auto forces_of = [&](const SolidIncrement<Vector> &of) -> Eigen::VectorXd
  { return contact_tangent * (of.displacement + motions.modes * of.motion); };
  const auto solve_symmetric_part = [&](const Vector &of, const Eigen::Vector3d &missing, bool is_first)
  {
    BorderedVector found;
    SolidIncrement<Vector> solution;
    solution.n_iterations = solver.solve(system, { of, missing }, linear_reduction, found, !is_first);
    solution.displacement = restrict(found.body);
    solution.motion = found.motion;
    solution.image.reinit(locally_owned, communicator);
    stiffness.vmult(solution.image, found.body);
    solution.image += contact_load(forces_of(solution));
    solution.body = found.body;
    return solution;
  };

  const Vector unbalanced = residual(forces);
  SolidIncrement<Vector> solution =
    solve_symmetric_part(unbalanced, motions.scale.asDiagonal() * conditions.residual(forces, motion), true);
  if (has_friction)
  {
    constexpr double share_left = 1e-4; // a correction costs little more than a back substitution
    Vector left = unbalanced;
    left -= solution.image;
    correct_for_friction(solution, left, share_left * unbalanced.l2_norm(),
                         [&](const Vector &of, double)
                         { return solve_symmetric_part(of, Eigen::Vector3d::Zero(), false); });
  }

  increment = solution.body;
  NewtonIncrement step;
  step.linear_iterations = solution.n_iterations;
  step.steadiness = steadiness_of(solver.schur_complement(), leaning);
  step.displacement = solution.displacement;
  step.motion = motions.scale.asDiagonal() * solution.motion;
  // The work of friction, which changes with the forces, belongs to the body's.
  step.energy_curvature = solution.image * increment - parts.sum(forces_of(solution).dot(step.displacement));
  step.energy_slope = parts.sum(forces.dot(step.displacement)) - unbalanced * increment;
  return step;
}

void AssembledSystem::update(double step_length)
{
  displacement.add(step_length, increment);
}

void AssembledSystem::reset()
{
  displacement = 0;
}

double AssembledSystem::equilibrium_residual(const Eigen::VectorXd &forces) const
{
  return residual(forces).l2_norm() / zone.nodes->norm(forces);
}

void AssembledSystem::write_state(std::ostream &stream) const
{
  for (const double value : displacement)
    write_binary(stream, &value, 1);
}

void AssembledSystem::read_state(std::istream &stream)
{
  for (const auto dof : locally_owned)
  {
    double value = 0;
    read_binary(stream, &value, 1);
    displacement(dof) = value;
  }
  displacement.compress(VectorOperation::insert);
}

LinearAlgebra::distributed::Vector<double> AssembledSystem::displacement_for_output() const
{
  const IndexSet relevant = DoFTools::extract_locally_relevant_dofs(dof_handler);
  LinearAlgebra::distributed::Vector<double> result(locally_owned, relevant, communicator);
  for (const auto i : locally_owned)
    result(i) = displacement(i);
  constraints.distribute(result);
  result.update_ghost_values();
  return result;
}

} // namespace stemware::fem
