#pragma once

#include "ring_model/yaw_motion.h"

#include <cstddef>
#include <optional>

namespace stemware::ring
{
/// Motion of a spin that follows its torque so fast that an explicit method needs steps below its time
/// constant. Three-stage Radau IIA, order 5; without inertia each stage is a zero of the torque (Hairer &
/// Wanner, Solving Ordinary Differential Equations II, IV.5).
class StiffMotion
{
public:
  /// For the arguments see yaw_motion().
  StiffMotion(PhasedTorqueFunction torque, double yaw_inertia, double accuracy, double spin_scale);

  /// Returns whether few steps, between @p n_times outputs until @p end [s], cost less than explicit steps.
  bool is_stiff(const YawSample &start, double end, std::size_t n_times) const;

  /// Returns the state after one step from @p state, not beyond the time @p end [s]. @p step [s]: first
  /// trial, overwritten by the next trial. Throws NoBalance if no step is small enough.
  YawSample after_step(const YawSample &state, double end, double &step) const;

  /// Returns the state one step of @p step [s] after @p state, without an estimate of its error. Throws
  /// NoBalance if the step is not found.
  YawSample within_step(const YawSample &state, double step) const;

private:
  /// Derivatives of the torque.
  struct Slopes
  {
    double angle; ///< derivative with respect to the yaw angle [N m]
    double spin;  ///< derivative with respect to the spin [N m s]
  };

  Slopes slopes(const YawSample &at) const;
  /// Returns the difference of the ends of two steps relative to the requested accuracy.
  double relative_difference(const YawSample &a, const YawSample &b) const;
  /// Returns one step from @p start; std::nullopt if Newton's method with @p slope does not converge.
  std::optional<YawSample> collocated(const YawSample &start, const Slopes &slope, double step) const;

  const PhasedTorqueFunction torque;
  const double yaw_inertia, accuracy, spin_scale;
};
} // namespace stemware::ring
