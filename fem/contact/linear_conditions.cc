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
    , parts(surface.parts)
{
  if (!(t.allFinite() && t(0) > 0))
    throw std::invalid_argument(
      "The normal force must be a finite number greater than 0 N and the moment finite.");
  if (parts.any(L.rows() != surface.n_nodes() || !L.allFinite() || !H.allFinite() ||
                (L.col(0).array() != 1).any()))
    throw std::invalid_argument("The conditions on the contact forces are not allowed; give three finite "
                                "weights for every contact node, the first of them 1.");
  symmetric = !parts.any(!H.isZero(0) || L != surface.motion_modes());
}

LinearConditions LinearConditions::with_scaled_moment(const ContactSurface &surface, double share) const
{
  const Eigen::MatrixX3d modes = surface.motion_modes();
  Eigen::MatrixX3d weights = modes;
  if (!are_resultants())
    weights += share * (L - modes);
  return { surface, std::move(weights), { t(0), share * t(1), share * t(2) }, share * H };
}

LinearConditions prescribed_resultants(const ContactSurface &surface, const Resultants &load)
{
  return LinearConditions(surface, surface.motion_modes(),
                          { load.normal_force, -load.moment_y, load.moment_x });
}

} // namespace stemware::fem
