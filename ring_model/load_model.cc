#include "ring_model/load_model.h"

#include "ring_model/load/require.h"

namespace stemware::ring
{
FirstHarmonicModel::FirstHarmonicModel(double radius)
    : ring_radius(radius)
{
  require_positive(radius, "the ring radius", "m");
}

RingStack FirstHarmonicModel::rings(double normal_force, const Eigen::Vector2d &moment) const
{
  return RingStack::first_harmonic(normal_force, moment, ring_radius);
}
} // namespace stemware::ring
