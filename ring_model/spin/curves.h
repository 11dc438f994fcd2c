#pragma once

#include "ring_model/spin/answer.h"
#include "ring_model/spin/load.h"

#include <string>
#include <vector>

namespace stemware::ring
{
/// Returns the torques under @p load at @p spins [rad/s]: NaN, and the @p reason, without a balance.
std::vector<Torques> torque_curve(const Load &load, const Question &question,
                                  const std::vector<double> &spins, std::string *reason = nullptr);

/// Returns all spins within 1.5 v / R at which the torques balance, ascending, with their stability; includes
/// a glass held at rest and the terminal spin of @p found, the answer about @p load. Pairs closer than v /
/// (32 R) may be missed. The search ends where the load has no balance, and at 1.05 v / R if friction brakes
/// under every load beyond. Empty without a terminal spin, or if the phase matters. Throws as @p load.
std::vector<TerminalSpin> terminal_spins(const Load &load, const Question &question, const Answer &found);

/// Returns the spin-up from rest at the equally spaced @p times [s] with error control; NaN after @p fall,
/// the tipping of the glass under @p load. Throws as @p load and Question::observer.
std::vector<YawSample> spin_up(const Load &load, const Question &question, const std::vector<double> &times,
                               const std::optional<RingState> &fall = {});

/// Returns spin_up() by forward Euler in equal steps of at most @p longest [s], as in the paper.
std::vector<YawSample> euler_spin_up(const Load &load, const Question &question,
                                     const std::vector<double> &times, double longest,
                                     const std::optional<RingState> &fall = {});

/// Returns the torque of friction and lean under @p load, which has phases(), tabulated for 1e5 evaluations
/// near one spin. For spins within @p reach [rad/s] of @p middle and the load's
/// PhaseSampledLoad::polynomial_range(), the torque at each sampled phase is an AdaptiveCurve accurate to @p
/// tolerance [N m], interpolated between phases like the load. Elsewhere, or if the tolerance is not reached,
/// the load is evaluated. Keeps references to @p load and @p motion.
PhasedTorqueFunction tabulated_torque(const Load &load, const Motion &motion, double middle, double reach,
                                      double tolerance);

/// One instant of a spin-up.
struct Instant : YawSample
{
  RingState state;
};

/// Returns at most 25 instants of @p spin_up under @p load, from rest until the spin is within 0.5 % of its
/// last value before tipping.
std::vector<Instant> instants_of(const std::vector<YawSample> &spin_up, const Load &load,
                                 const Question &question);

/// Returns tau_z of friction [N m] at the spin @p omega [rad/s] at each of PhaseSampledLoad::phases().
std::vector<double> torques_by_phase(const PhaseSampledLoad &phases, const Motion &motion, double omega);

/// Returns @p load interpolated in the spin from @p lower to @p upper [rad/s], or to tipping, for curves of
/// thousands of values. @p found: the answer about @p load. If some spins have no balance: interpolated from
/// rest to the terminal spin, or, if that fails, exact. @p similar as in Load::interpolated().
Load interpolated_for_curves(const Load &load, const Answer &found, double lower, double upper,
                             const Load *similar = nullptr);

/// Returns 201 equally spaced times from 0 to @p end [s].
std::vector<double> output_times(double end);

/// Slip of a rim point over the table, and the friction on the point: x along the travel, y to the left.
struct RimSlip
{
  double azimuth = 0;                    ///< theta [rad]
  double slip_x = 0, slip_y = 0;         ///< velocity over the hand's speed
  double friction_x = 0, friction_y = 0; ///< friction per angle, over the friction of the mean load at rest
};

/// Returns slip and friction at 24 points of a rim of @p radius [m], spin @p omega [rad/s]. Negative loads
/// count as 0.
std::vector<RimSlip> rim_slip(const Motion &motion, double radius, const RingStack &load, double omega);
} // namespace stemware::ring
