#pragma once

#include "fem/pipeline/coupling/elastic_foot.h"
#include "fem/pipeline/study/motion_section.h"
#include "ring_model/spin/hand_drive.h"
#include "ring_model/yaw_motion.h"

#include <memory>
#include <optional>
#include <vector>

namespace stemware::pipeline
{

/// Spin-up while the hand's speed changes.
struct DrivenSpinUp
{
  std::vector<double> time;         ///< [s]
  std::vector<double> speed;        ///< v(t) [m/s]
  std::vector<double> acceleration; ///< dv/dt [m/s^2]
  std::vector<double> omega;        ///< all harmonics, error control [rad/s]
  /// Change of omega for linear instead of monotone cubic interpolation of the file, on a rigid rim [rad/s].
  double interpolation_change = 0;               ///< maximum over the times
  double interpolation_change_at_end = 0;        ///< at the last time
  double integration_error = 0;                  ///< requested accuracy [rad/s]
  std::optional<ring::Breakaway> breakaway = {}; ///< if the hand starts from rest
};

/// Returns the spin-up with Motion/Orbit speed file, if given, at @p times. Each torque solves the balance of
/// contact, friction and moments at the present speed, acceleration and spin; moment balances hand and full
/// include the hand's tangential force m dv/dt. @p foot: study_foot() with its rings; nullptr for a
/// first-harmonic load on a ring of @p contact_radius [m]. Throws BadInput if the glass tips, and as contact
/// solves, balances and @p observer.
std::optional<DrivenSpinUp> driven_spin_up(const MotionSection &motion, double contact_radius,
                                           const std::shared_ptr<ElasticFoot> &foot,
                                           const std::vector<double> &times,
                                           const ring::TimeObserver &observer = {});

} // namespace stemware::pipeline
