#pragma once

#include "fem/pipeline/coupling/foot_contact.h"
#include "ring_model/load_model.h"

#include <cstddef>
#include <memory>

namespace stemware::pipeline
{

/// The finite-element foot as the ring sees it: resultants in, load out. Each load is a contact solution.
class ElasticFoot : public ring::LoadModel
{
public:
  ElasticFoot(std::shared_ptr<FootContact> foot, double contact_radius);

  /// Throws fem::ContactFailure.
  ring::RingStack load(double normal_force, const Eigen::Vector2d &moment) const override;
  double radius() const override { return contact_radius; }
  double lift_off_ratio() const override { return 1; } // not used here: the contact itself knows
  double accuracy() const override { return 1e-11; }   // contact resultants are good to 1e-10 or better

  /// The contact solution behind the last load().
  const fem::LoadHarmonics &contact() const { return pressed; }
  std::size_t n_solutions() const { return n_solved; }

  double spin_per_speed = 0; ///< omega / v, which sets the direction of friction that deforms the foot [1/m]

private:
  const std::shared_ptr<FootContact> foot;
  const double contact_radius;
  mutable fem::LoadHarmonics pressed;
  mutable std::size_t n_solved = 0;
};

} // namespace stemware::pipeline
