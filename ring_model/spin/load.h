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

/// Load on the rings as a function of the spin, and of the marks' azimuths if these matter.
///
///     const Load load([](double omega) -> Sample {
///       return RingStack({ 0.5, 0. }, { 0., 0.2 + 0.001 * omega }, 0.03); // [N/rad], [m]
///     });
///     answer(load, { Motion() }).omega_terminal(); // [rad/s]
///
/// A value: copies share the samples that were solved.
class Load
{
public:
  using Function = std::function<Sample(double omega)>;

  /// Load that is cheap to evaluate. @p is_pressure: it comes from a contact and is nowhere negative.
  explicit Load(Function load, bool is_pressure = false);
  /// Contact pressure that depends on the phase.
  explicit Load(std::shared_ptr<const PhaseSampledLoad> phases);
  /// Returns the contact pressure that @p solve finds; each spin is solved once, successfully or not. @p
  /// at_rest: its sample at rest.
  static Load solved_once(Function solve, const Sample &at_rest);

  /// Returns the load at the spin @p omega [rad/s] with the marks of glass and table at @p marks; the mean
  /// over the phases if these matter and are not given. Throws NoBalance.
  Sample at(double omega, const std::optional<Orientation> &marks = {}) const;

  /// Returns the highest harmonic of at().
  unsigned int n_harmonics() const;
  /// Returns the radius of friction [m]: the radius of the load at rest.
  double radius() const { return at(0.).radius(); }
  /// Returns the spin v / R at which the rim speed equals the orbit speed, R the radius at rest [rad/s].
  double spin_scale(const Motion &motion) const { return motion.orbit_speed / radius(); }
  /// Returns whether at() needs contact solutions.
  bool is_costly() const;
  /// Returns whether the load comes from a contact pressure and is nowhere negative.
  bool is_pressure() const;
  /// Returns the load by phase; nullptr if the load does not depend on the phase.
  const PhaseSampledLoad *phases() const;
  /// Returns SpinSearch::stability_margin at @p omega, if solved; else 1.
  double stability_margin(double omega) const;
  /// Returns SpinSearch::nearest_unbalanced_spin: of the solved spins at which the glass tips.
  std::optional<double> nearest_unbalanced_spin(double omega) const;
  /// Returns a bound on the interpolation error of at() over a_0; std::nullopt if the load is not
  /// interpolated.
  std::optional<double> interpolation_error() const;

  /// Returns the load truncated after @p n_harmonics; neither contact nor friction is solved again.
  Load truncated(unsigned int n_harmonics) const;

  /// Returns the load interpolated between the spins @p lower and @p upper [rad/s], for curves of thousands
  /// of values: by an AdaptiveCurve whose pieces end where the rim lifts off, to @p tolerance of
  /// RingStack::difference(), else exact; exact outside the interval. A load that is not costly is returned
  /// unchanged. If @p similar, another interpolated load on the same rings, is one polynomial, the difference
  /// to @p similar is interpolated.
  Load interpolated(double lower, double upper, const CurveTolerance &tolerance = {},
                    const Load *similar = nullptr) const;

private:
  struct Source;
  struct Interpolant;

  /// Returns the spins between the solved ones from @p lower to @p upper at which the rim lifts off or comes
  /// back into contact.
  std::vector<double> lift_offs(double lower, double upper) const;

  std::shared_ptr<const Source> source;
  unsigned int n_kept = std::numeric_limits<unsigned int>::max();
  std::shared_ptr<const Interpolant> curve = {};
};
} // namespace stemware::ring
