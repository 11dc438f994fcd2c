#include "fem/solid/solid_body.h"

#include "fem/solid/solid_body_implementation.h"

#include <deal.II/base/mpi.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/lac/trilinos_sparsity_pattern.h>

#include <stdexcept>

namespace stemware::fem
{

using namespace dealii;

namespace
{
/// Reduction of the residual by one linear solve; Newton's next step takes care of the rest.
constexpr double linear_reduction = 1e-9;

/// Above this size a factorisation costs more time and memory than multigrid does (docs/method.md, "Linear
/// solves").
constexpr types::global_dof_index largest_direct_system = 150000;

constexpr auto stem_cut_id = static_cast<types::boundary_id>(FootBoundary::stem_cut);

void require_degree(unsigned int degree)
{
  if (degree != 1 && degree != 2)
    throw std::invalid_argument("Degree = " + std::to_string(degree) +
                                " is not allowed for a solid body; give 1 or 2.");
}
} // namespace

SolidBody::Implementation::Implementation(Triangulation<3> &triangulation, const ElasticMaterial &material,
                                          const SolidOptions &options)
    : communicator(triangulation.get_communicator())
    , mapping(options.straight_edges ? 1 : options.degree)
    , element(FE_Q<3>(options.degree), 3)
    , dof_handler(triangulation)
    , material(material)
{
  dof_handler.distribute_dofs(element);
  locally_owned = dof_handler.locally_owned_dofs();
  DoFTools::extract_locally_relevant_dofs(dof_handler, locally_relevant);
  clamp_stem_cut();
  assemble();
}

void SolidBody::Implementation::clamp_stem_cut()
{
  const IndexSet clamped =
    DoFTools::extract_boundary_dofs(dof_handler, ComponentMask(3, true), { stem_cut_id });
  if (Utilities::MPI::sum(clamped.n_elements(), communicator) == 0)
    throw std::invalid_argument(
      "The mesh has no stem cut: no boundary face carries the id 1; mark the faces where the stem was cut.");
  constraints.reinit(locally_relevant);
  DoFTools::make_hanging_node_constraints(dof_handler, constraints);
  DoFTools::make_zero_boundary_constraints(dof_handler, stem_cut_id, constraints);
  constraints.close();
}

void SolidBody::Implementation::assemble()
{
  TrilinosWrappers::SparsityPattern sparsity(locally_owned, locally_owned, locally_relevant, communicator);
  DoFTools::make_sparsity_pattern(dof_handler, sparsity, constraints, false,
                                  Utilities::MPI::this_mpi_process(communicator));
  sparsity.compress();
  stiffness.reinit(sparsity);
  assemble_stiffness(mapping, dof_handler, material, constraints, stiffness);
  tangent.copy_from(stiffness);
  displacement.reinit(locally_owned, communicator);
}

BorderedSolver::MakePreconditioner SolidBody::Implementation::preconditioner_maker(LinearSolver kind) const
{
  const bool direct = kind == LinearSolver::direct ||
                      (kind == LinearSolver::automatic && dof_handler.n_dofs() <= largest_direct_system);
  if (direct)
    return factorize;
  return [this](const TrilinosWrappers::SparseMatrix &matrix)
  {
    const RigidBodyModes modes(mapping, dof_handler, constraints);
    return make_multigrid(matrix, modes, element.degree > 1);
  };
}

TrilinosWrappers::MPI::Vector SolidBody::Implementation::scatter(const Eigen::VectorXd &nodal) const
{
  TrilinosWrappers::MPI::Vector vector(locally_owned, communicator);
  for (unsigned int i = 0; i < zone.node_dofs.size(); ++i)
    if (locally_owned.is_element(zone.node_dofs[i]))
      vector(zone.node_dofs[i]) = nodal(i);
  vector.compress(VectorOperation::insert);
  return vector;
}

Eigen::VectorXd SolidBody::Implementation::restrict(const TrilinosWrappers::MPI::Vector &vector) const
{
  std::vector<double> nodal(zone.node_dofs.size(), 0);
  for (unsigned int i = 0; i < zone.node_dofs.size(); ++i)
    if (locally_owned.is_element(zone.node_dofs[i]))
      nodal[i] = vector(zone.node_dofs[i]);
  Utilities::MPI::sum(nodal, communicator, nodal);
  return Eigen::Map<const Eigen::VectorXd>(nodal.data(), static_cast<Eigen::Index>(nodal.size()));
}

void SolidBody::Implementation::set_tangent(const Eigen::SparseMatrix<double> &contact_tangent)
{
  tangent.copy_from(stiffness);
  for (Eigen::Index column = 0; column < contact_tangent.outerSize(); ++column)
    for (Eigen::SparseMatrix<double>::InnerIterator entry(contact_tangent, column); entry; ++entry)
    {
      const auto row_dof = zone.node_dofs[static_cast<std::size_t>(entry.row())];
      if (locally_owned.is_element(row_dof))
        tangent.add(row_dof, zone.node_dofs[static_cast<std::size_t>(entry.col())], entry.value());
    }
  tangent.compress(VectorOperation::add);
}

TrilinosWrappers::MPI::Vector SolidBody::Implementation::residual(const Eigen::VectorXd &forces) const
{
  TrilinosWrappers::MPI::Vector elastic(locally_owned, communicator);
  stiffness.vmult(elastic, displacement);
  TrilinosWrappers::MPI::Vector result = scatter(forces);
  result -= elastic;
  return result;
}

SolidBody::SolidBody(Triangulation<3> &triangulation, const ElasticMaterial &material, const Gap &gap,
                     const SolidOptions &options)
{
  require_degree(options.degree);
  material.validate();
  implementation = std::make_unique<Implementation>(triangulation, material, options);
  implementation->zone = describe_contact_zone(implementation->mapping, implementation->dof_handler, gap);
  implementation->solver =
    std::make_unique<BorderedSolver>(implementation->preconditioner_maker(options.linear_solver));
}

SolidBody::~SolidBody() = default;

const ContactSurface &SolidBody::contact_surface() const
{
  return implementation->zone.surface;
}

Eigen::VectorXd SolidBody::contact_displacement() const
{
  return implementation->restrict(implementation->displacement);
}

NewtonIncrement SolidBody::solve(const Eigen::SparseMatrix<double> &contact_tangent,
                                 const Eigen::VectorXd &forces, const LinearConditions &conditions,
                                 const Eigen::Vector3d &motion)
{
  Implementation &body = *implementation;
  body.set_tangent(contact_tangent);

  // Tilts are counted as heights at the rim, so that all unknowns are lengths and all residuals forces.
  Eigen::MatrixX3d modes = body.zone.surface.motion_modes();
  const double length = modes.rightCols<2>().rowwise().norm().maxCoeff();
  const Eigen::Vector3d scale(1, 1 / length, 1 / length);
  modes = modes * scale.asDiagonal();
  const auto scatter = [&](const Eigen::MatrixX3d &nodal)
  {
    return std::array<TrilinosWrappers::MPI::Vector, 3>{ body.scatter(nodal.col(0)),
                                                         body.scatter(nodal.col(1)),
                                                         body.scatter(nodal.col(2)) };
  };
  BorderedSystem system{ body.tangent, {}, {}, {} };
  const Eigen::MatrixX3d stiffened = contact_tangent * modes;
  system.border = scatter(stiffened);
  if (conditions.are_resultants())
    system.corner = modes.transpose() * stiffened;
  else
  {
    const Eigen::MatrixX3d weights = conditions.weights() * scale.asDiagonal();
    system.condition_border = scatter(contact_tangent * weights);
    system.corner =
      weights.transpose() * stiffened - scale.asDiagonal() * conditions.motion_weights() * scale.asDiagonal();
  }
  const BorderedVector rhs{ body.residual(forces), scale.asDiagonal() * conditions.residual(forces, motion) };
  BorderedVector increment;
  NewtonIncrement step;
  step.linear_iterations = body.solver->solve(system, rhs, linear_reduction, increment);

  body.increment = increment.body;
  step.displacement = body.restrict(body.increment);
  step.motion = scale.asDiagonal() * increment.motion;
  TrilinosWrappers::MPI::Vector image(body.locally_owned, body.communicator);
  body.stiffness.vmult(image, body.increment);
  step.energy_curvature = image * body.increment;
  step.energy_slope = image * body.displacement;
  return step;
}

void SolidBody::update(double step_length)
{
  implementation->displacement.add(step_length, implementation->increment);
}

void SolidBody::reset()
{
  implementation->displacement = 0;
}

double SolidBody::equilibrium_residual(const Eigen::VectorXd &forces) const
{
  return implementation->residual(forces).l2_norm() / forces.norm();
}

unsigned int SolidBody::n_unknowns() const
{
  return static_cast<unsigned int>(implementation->dof_handler.n_dofs());
}

double SolidBody::contact_cell_size() const
{
  return implementation->zone.smallest_cell;
}

} // namespace stemware::fem
