#include "ring_model/load_model.h"

#include "ring_model/require.h"

namespace stemware::ring
{
FirstHarmonicModel::FirstHarmonicModel(double radius)
    : ring_radius(radius)
{
  require_positive(radius, "the ring radius", "m");
}

RingStack FirstHarmonicModel::rings(double normal_force, const Eigen::Vector2d &moment,
                                    const Slip & /*slip*/) const
{
  return RingStack::first_harmonic(normal_force, moment, ring_radius);
}

RingStack FixedLoad::rings(double /*normal_force*/, const Eigen::Vector2d & /*moment*/,
                           const Slip & /*slip*/) const
{
  return fixed;
}

double FixedLoad::lift_off_ratio() const
{
  return fixed.minimum() < 0. ? 0. : std::numeric_limits<double>::infinity();
}
} // namespace stemware::ring
