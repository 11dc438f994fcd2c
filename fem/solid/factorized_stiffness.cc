#include "fem/solid/factorized_stiffness.h"

#include "fem/contact/contact_solution.h"
#include "fem/factorisation/blas_threads.h"
#include "fem/solid/solid_contact_zone.h"
#include "fem/solid/stiffness_3d.h"

#include <deal.II/lac/trilinos_solver.h>

#include <iostream>

namespace stemware::fem
{

using namespace dealii;

namespace
{

/// Iterations above which new factors pay: a back substitution costs about a sixtieth of a factorisation.
constexpr unsigned int patience = 30;

std::shared_ptr<const ContactNodes> contact_nodes_of(const SolidLevel &level)
{
  return std::make_shared<const ContactNodes>(level.dof_handler.locally_owned_dofs(),
                                              contact_dofs(level.dof_handler, level.constraints),
                                              level.dof_handler.get_communicator());
}

} // namespace

class FactorizedStiffness::Factors
{
public:
  /// Factorises @p stiffness + B' @p contact B.
  Factors(const TrilinosWrappers::SparseMatrix &stiffness, const std::vector<ContactNodes::Entry> &contact)
      : solver(control, TrilinosWrappers::SolverDirect::AdditionalData(false, "Amesos_Mumps"))
  {
    hold_blas_to_one_thread();
    matrix.copy_from(stiffness);
    for (const ContactNodes::Entry &entry : contact)
      matrix.add(entry.row, entry.column, entry.value);
    matrix.compress(VectorOperation::add);
    // Amesos prints what MUMPS says; the exception says it in the words of a study.
    std::streambuf *const printed = std::cerr.rdbuf(nullptr);
    bool has_failed = false;
    try
    {
      solver.initialize(matrix);
    }
    catch (const ExceptionBase &)
    {
      has_failed = true;
    }
    std::cerr.rdbuf(printed);
    if (has_failed)
      throw ContactFailure(ContactOutcome::linear_solver_failed,
                           "The stiffness of " + std::to_string(matrix.m()) +
                             " unknowns cannot be factorised: distorted cells or not enough memory; repair "
                             "the mesh, use fewer cells, or set Contact/Linear solver = multigrid.");
  }

  void vmult(Vector &dst, const Vector &src) const { solver.solve(dst, src); }

private:
  TrilinosWrappers::SparseMatrix matrix; // which the solver refers to
  SolverControl control;
  mutable TrilinosWrappers::SolverDirect solver; // solve() is not const in deal.II, though it changes nothing
};

FactorizedStiffness::FactorizedStiffness(const Triangulation<3> &triangulation, unsigned int degree,
                                         unsigned int mapping_degree, const ElasticMaterial &material)
    // A pointer that owns nothing.
    : level(std::shared_ptr<const Triangulation<3>>(std::shared_ptr<void>(), &triangulation), degree,
            mapping_degree)
    , nodes(contact_nodes_of(level))
{
  assemble_stiffness(level.mapping, level.dof_handler, material, level.constraints, stiffness);
}

FactorizedStiffness::~FactorizedStiffness() = default;

void FactorizedStiffness::initialize(Vector &vector) const
{
  vector.reinit(level.dof_handler.locally_owned_dofs(), level.dof_handler.get_communicator());
}

void FactorizedStiffness::set_contact(const Eigen::SparseMatrix<double> &tangent)
{
  are_fresh = !factors;
  if (are_fresh)
    factors = std::make_unique<const Factors>(stiffness, nodes->owned_rows(tangent));
}

void FactorizedStiffness::precondition(Vector &dst, const Vector &src) const
{
  factors->vmult(dst, src);
}

void FactorizedStiffness::report_iterations(unsigned int n_iterations)
{
  if (n_iterations > patience && !are_fresh)
    factors.reset();
}

} // namespace stemware::fem
