#include "fem/contact/rigid_foot.h"

#include "fem/contact/contact_solution.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>

namespace stemware::fem
{

Eigen::Matrix3d motion_stiffness(const Eigen::SparseMatrix<double> &tangent, const Eigen::MatrixX3d &weights,
                                 const Eigen::MatrixX3d &modes)
{
  Eigen::Matrix3d support = Eigen::Matrix3d::Zero();
  for (Eigen::Index column = 0; column < tangent.outerSize(); ++column)
  {
    Eigen::RowVector3d resisted = Eigen::RowVector3d::Zero();
    bool loaded = false;
    // Most entries of the sparsity pattern are zero, because their nodes are unloaded.
    for (Eigen::SparseMatrix<double>::InnerIterator entry(tangent, column); entry; ++entry)
      if (entry.value() != 0)
      {
        loaded = true;
        resisted += entry.value() * modes.row(entry.row());
      }
    if (loaded)
      support += weights.row(column).transpose() * resisted;
  }
  return support;
}

NewtonIncrement RigidFoot::solve(const Eigen::SparseMatrix<double> &tangent, const Eigen::VectorXd &forces,
                                 const LinearConditions &conditions, const Eigen::Vector3d &motion)
{
  const Eigen::Matrix3d stiffness =
    surface.parts.sum(motion_stiffness(tangent, conditions.weights(), modes)) - conditions.motion_weights();
  const Eigen::Vector3d residual = conditions.residual(forces, motion);
  NewtonIncrement step;
  step.displacement = Eigen::VectorXd::Zero(surface.n_nodes());
  bool is_regular = false;
  if (conditions.are_resultants())
  {
    const Eigen::LDLT<Eigen::Matrix3d> factors(stiffness);
    is_regular = factors.info() == Eigen::Success && factors.isPositive();
    step.motion = factors.solve(residual);
  }
  else
  {
    const Eigen::FullPivLU<Eigen::Matrix3d> factors(stiffness);
    is_regular = factors.isInvertible();
    step.motion = factors.solve(residual);
  }
  if (!is_regular)
    throw ContactFailure(
      ContactOutcome::linear_solver_failed,
      "The table's tangent does not support a rigid foot: the loaded points lie on one line.");
  return step;
}

} // namespace stemware::fem
