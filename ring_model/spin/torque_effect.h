#pragma once

#include "ring_model/spin/answer.h"

#include <optional>
#include <vector>

namespace stemware::ring
{
/// Effect of the harmonics 2 ... n of one load on tau_z of friction. At each spin, the complete load at
/// that spin is truncated after n harmonics; neither contact nor balance of moments is solved again. With
/// waviness all values are means over the phases. (docs/theory/budget.md)
struct TorqueEffect
{
  /// Values at one spin [N m].
  struct AtSpin
  {
    double change; ///< Delta tau_z(n) = tau_z(n) - tau_z(1)
    double rest;   ///< tau_z(all) - tau_z(n)
    double bound;  ///< a-priori bound on |rest|
  };

  unsigned int harmonics = 0;     ///< n
  std::optional<AtSpin> half;     ///< effect at half the terminal spin; std::nullopt without a terminal spin
  std::optional<AtSpin> terminal; ///< effect at the terminal spin; std::nullopt without a terminal spin
  /// Delta tau_z(n) of largest absolute value between rest and the terminal spin, or tipping [N m], and its
  /// spin [rad/s]; std::nullopt if no curve was requested.
  std::optional<double> largest, largest_at;
  std::vector<double> curve; ///< Delta tau_z(n) at TorqueEffects::spins [N m]; NaN without a balance
};

/// Effects of one load by number of harmonics.
struct TorqueEffects
{
  double torque_at_rest = 0.;     ///< |tau_z(0)|, the denominator of relative effects [N m]
  std::vector<double> spins = {}; ///< spins from rest to the terminal spin, or to tipping [rad/s]
  std::vector<TorqueEffect> rows = {};
};

/// Returns the effects of the harmonics up to each of @p orders under @p load, whose answer is @p all with
/// its state at rest. @p curve is the same load, cheap to evaluate between rest and Answer::last_spin();
/// nullptr leaves out the curves and their largest values. Throws as @p load, but for NoBalance.
TorqueEffects torque_effects(const Load &load, const Motion &motion, const Answer &all,
                             const std::vector<unsigned int> &orders, const Load *curve = nullptr);
} // namespace stemware::ring
