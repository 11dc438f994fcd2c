#pragma once

#include "ring_model/spin/answer.h"

#include <optional>
#include <vector>

namespace stemware::ring
{
/// Effect of the harmonics 2 ... n of one load on tau_z of friction: at each spin, the full load is truncated
/// after n harmonics, without another balance. With waviness, means over the phases (docs/theory/budget.md).
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
  /// Largest |Delta tau_z(n)| up to terminal spin or tipping, signed [N m]; its spin [rad/s]. Needs a curve.
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

/// Returns the effects of the harmonics up to each of @p orders under @p load. @p all: the answer about @p
/// load, with the state at rest. @p curve: the same load, cheap up to Answer::last_spin(); nullptr: no curves
/// and largest values. Throws as @p load, except NoBalance.
TorqueEffects torque_effects(const Load &load, const Motion &motion, const Answer &all,
                             const std::vector<unsigned int> &orders, const Load *curve = nullptr);
} // namespace stemware::ring
