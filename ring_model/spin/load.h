#pragma once

#include "ring_model/load/slip.h"
#include "ring_model/motion.h"
#include "ring_model/spin/adaptive_curve.h"
#include "ring_model/spin/sample.h"

#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

namespace stemware::ring
{
class PhaseSampledLoad;

/// Load on the rings as a function of the spin and, with waviness, of the marks' azimuths.
///
///     const Load load([](double omega) -> Sample {
///       return RingStack({ 0.5, 0. }, { 0., 0.2 + 0.001 * omega }, 0.03); // [N/rad], [m]
///     });
///     answer(load, { Motion() }).omega_terminal(); // [rad/s]
///
/// Copies share the solved samples.
class Load
{
public:
  using Function = std::function<Sample(double omega)>;

  /// Load that is cheap to evaluate. @p is_pressure: comes from a contact and is nowhere negative.
  explicit Load(Function load, bool is_pressure = false);
  /// Load from a contact pressure that depends on the phase.
  explicit Load(std::shared_ptr<const PhaseSampledLoad> phases);
  /// Returns the load by @p solve, which is called once for each spin. @p at_rest: sample at rest.
  static Load solved_once(Function solve, const Sample &at_rest);

  /// Returns the load at @p omega [rad/s] and @p marks, else the mean over the phases. Throws NoBalance.
  Sample at(double omega, const std::optional<Orientation> &marks = {}) const;

  /// Returns the highest harmonic of at().
  unsigned int n_harmonics() const;
  /// Returns the radius of friction [m]: the radius of the load at rest.
  double radius() const { return at(0.).radius(); }
  /// Returns v / R [rad/s] with the radius at rest: the spin at which the rim is as fast as the orbit.
  double spin_scale(const Motion &motion) const { return motion.orbit_speed / radius(); }
  /// Returns whether at() needs contact solutions.
  bool is_costly() const;
  /// Returns whether the load comes from a contact pressure and is nowhere negative.
  bool is_pressure() const;
  /// Returns the load by phase; nullptr if the load does not depend on the phase.
  const PhaseSampledLoad *phases() const;
  /// Returns SpinSearch::stability_margin at @p omega, if solved; else 1.
  double stability_margin(double omega) const;
  /// Returns SpinSearch::nearest_unbalanced_spin among the solved spins at which the glass tips.
  std::optional<double> nearest_unbalanced_spin(double omega) const;
  /// Returns a bound on the interpolation error of at() over a_0; std::nullopt for a load not interpolated.
  std::optional<double> interpolation_error() const;

  /// Returns the load truncated after @p n_harmonics; neither contact nor friction is solved again.
  Load truncated(unsigned int n_harmonics) const;

  /// Returns the load interpolated between the spins @p lower and @p upper [rad/s], for curves of thousands
  /// of values: an AdaptiveCurve with pieces that end where the rim lifts off and with the @p tolerance of
  /// RingStack::difference(). Where the load jumps with the spin, interpolation_error() exceeds the
  /// tolerance. Exact outside the interval; a load that is not costly is unchanged. If @p similar,
  /// interpolated on the same rings, is one polynomial, the difference to @p similar is interpolated.
  Load interpolated(double lower, double upper, const CurveTolerance &tolerance = {},
                    const Load *similar = nullptr) const;

private:
  struct Source;
  struct Interpolant;

  /// Returns the spins in [@p lower, @p upper], between solved ones, at which lift-off begins or ends.
  std::vector<double> lift_offs(double lower, double upper) const;

  std::shared_ptr<const Source> source;
  unsigned int n_kept = std::numeric_limits<unsigned int>::max();
  std::shared_ptr<const Interpolant> curve = {};
};
} // namespace stemware::ring
