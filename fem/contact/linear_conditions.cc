#include "fem/contact/linear_conditions.h"

#include "fem/contact/contact_solution.h"
#include "fem/geometry/require.h"
#include "ring_model/load/constants.h"

#include <boost/math/tools/minima.hpp>

#include <cmath>
#include <limits>
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

void LinearConditions::require_possible(double radius, bool is_ring) const
{
  const Eigen::Vector2d centre = t.tail<2>() / t(0);
  if (centre.norm() == 0)
    return;
  // The distance from the axis to the convex hull's border is the minimum distance, along the centre's
  // direction, to a tangent of the hull: a convex function of the tangent of its angle. For a moment balance,
  // the moment weights replace the positions. The hull of a ring is assumed to be a circle.
  const Eigen::Vector2d direction = centre.normalized(), across(-direction(1), direction(0));
  const auto to_tangent = [&](double angle)
  { return parts.max_entry(L.rightCols<2>() * (direction + std::tan(angle) * across)); };
  constexpr double widest = ring::pi / 2 - 1e-6;
  constexpr int bits = std::numeric_limits<double>::digits;
  const double limit =
    is_ring ? to_tangent(0) : boost::math::tools::brent_find_minima(to_tangent, -widest, widest, bits).second;
  if (centre.norm() < limit)
    return;
  throw TippingDemand(sentence("the centre of pressure lies ", centre.norm(),
                               " m from the axis, outside the hull of the contact zone, ", limit,
                               " m in this direction; reduce the moment: the foot tips at "
                               "|M_N| = ",
                               limit / radius, " N R."));
}

LinearConditions prescribed_resultants(const ContactSurface &surface, const Resultants &load)
{
  return LinearConditions(surface, surface.motion_modes(),
                          { load.normal_force, -load.moment_y, load.moment_x });
}

} // namespace stemware::fem
