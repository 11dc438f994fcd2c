#include "fem/contact/linear_conditions.h"

#include <stdexcept>
#include <utility>

namespace stemware::fem
{

LinearConditions::LinearConditions(const ContactSurface &surface, Eigen::MatrixX3d weights,
                                   const Eigen::Vector3d &target, const Eigen::Matrix3d &motion_weights)
    : L(std::move(weights))
    , t(target)
    , H(motion_weights)
{
  if (!(t.allFinite() && t(0) > 0))
    throw std::invalid_argument(
      "The normal force must be a finite number greater than 0 N and the moment finite.");
  if (L.rows() != surface.n_nodes() || !L.allFinite() || !H.allFinite() || (L.col(0).array() != 1).any())
    throw std::invalid_argument("The conditions on the contact forces are not allowed; give three finite "
                                "weights for every contact node, the first of them 1.");
  symmetric = H.isZero(0) && L == surface.motion_modes();
}

LinearConditions prescribed_resultants(const ContactSurface &surface, const Resultants &load)
{
  return LinearConditions(surface, surface.motion_modes(),
                          { load.normal_force, -load.moment_y, load.moment_x });
}

} // namespace stemware::fem
