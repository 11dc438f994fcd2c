#include "fem/rigid_foot.h"

#include <Eigen/Cholesky>

#include <stdexcept>

namespace stemware::fem
{

ContactStep RigidFoot::solve(const Eigen::SparseMatrix<double> &tangent, const Eigen::VectorXd & /*forces*/,
                             const Eigen::Vector3d &resultant_excess)
{
  const Eigen::Matrix3d stiffness = modes.transpose() * (tangent * modes);
  const Eigen::LDLT<Eigen::Matrix3d> factors(stiffness);
  if (factors.info() != Eigen::Success || !factors.isPositive())
    throw std::runtime_error(
      "The table's tangent does not support a rigid foot: the loaded places lie on one line.");
  ContactStep step;
  step.displacement = Eigen::VectorXd::Zero(surface.n_nodes());
  step.motion = factors.solve(resultant_excess);
  return step;
}

} // namespace stemware::fem
