#pragma once

#include "ring_model/load/slip.h"
#include "ring_model/motion.h"
#include "ring_model/spin/leaning_load.h"

#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace stemware::ring
{
class LoadAtSpin;
class PhaseSampledLoad;

/// Shared load: balances solved for one owner are cached for all owners.
using SharedLoad = std::shared_ptr<const LoadAtSpin>;

/// Load on the ring as a function of the spin; the load of a Question.
class LoadAtSpin : public std::enable_shared_from_this<LoadAtSpin>
{
public:
  virtual ~LoadAtSpin() = default;

  /// Returns the load at the spin @p omega [rad/s] and the glass's tilt, with the marks of glass and table at
  /// @p marks; the mean over the phases if these matter and are not given. Throws NoBalance.
  virtual LeaningLoad at(double omega, const std::optional<Orientation> &marks = {}) const = 0;

  /// Highest harmonic of at().
  virtual unsigned int n_harmonics() const { return at(0.).n_harmonics(); }
  /// Radius of friction [m]: the radius of the load at rest.
  virtual double radius() const { return at(0.).radius(); }
  /// Returns whether at() needs contact solutions.
  virtual bool is_costly() const { return false; }
  /// Returns whether the load comes from a contact pressure and is nowhere negative.
  virtual bool is_pressure() const { return false; }
  /// Returns the load by phase; nullptr if the load does not depend on the phase.
  virtual const PhaseSampledLoad *phases() const { return nullptr; }
  /// Spins at which the load is known without a contact solution [rad/s], ascending.
  virtual std::vector<double> known_spins() const { return {}; }
  /// Margin to lift-off at @p omega, one of known_spins(): the minimum of the pointwise load over a_0;
  /// negative after lift-off, estimated from the free arc by continuing the first harmonic.
  virtual double lift_off_margin(double /*omega*/) const { return 1.; }
  /// SpinSearch::stability_margin at @p omega, a spin for which at() has been called; 1 if unknown.
  virtual double stability_margin(double /*omega*/) const { return 1.; }
  /// SpinSearch::nearest_unbalanced_spin.
  virtual std::optional<double> nearest_unbalanced_spin(double /*omega*/) const { return std::nullopt; }
  /// Bound on the interpolation error of at() over a_0; std::nullopt if the load is not interpolated.
  virtual std::optional<double> interpolation_error() const { return std::nullopt; }

  /// Spin v / R at which the rim speed equals the orbit speed, R the radius at rest [rad/s].
  double spin_scale(const Motion &motion) const { return motion.orbit_speed / radius(); }
};

/// Load that is a function of the spin:
///
///     const LoadFromFunction load([](double omega) -> LeaningLoad {
///       return RingStack({ 0.5, 0. }, { 0., 0.2 + 0.001 * omega }, 0.03); // [N/rad], [m]
///     });
///     answer(load, { Motion() }).omega_terminal(); // [rad/s]
class LoadFromFunction : public LoadAtSpin
{
public:
  explicit LoadFromFunction(std::function<LeaningLoad(double omega)> load)
      : load(std::move(load))
  {
  }
  LeaningLoad at(double omega, const std::optional<Orientation> & = {}) const override { return load(omega); }

private:
  const std::function<LeaningLoad(double omega)> load;
};

/// Decorator: forwards all calls to another load; derived classes override some of them.
class LoadDecorator : public LoadAtSpin
{
public:
  explicit LoadDecorator(SharedLoad whole)
      : whole(std::move(whole))
  {
  }

  unsigned int n_harmonics() const override { return whole->n_harmonics(); }
  double radius() const override { return whole->radius(); }
  bool is_costly() const override { return whole->is_costly(); }
  bool is_pressure() const override { return whole->is_pressure(); }
  const PhaseSampledLoad *phases() const override { return whole->phases(); }
  std::vector<double> known_spins() const override { return whole->known_spins(); }
  double lift_off_margin(double omega) const override { return whole->lift_off_margin(omega); }
  double stability_margin(double omega) const override { return whole->stability_margin(omega); }
  std::optional<double> nearest_unbalanced_spin(double omega) const override
  {
    return whole->nearest_unbalanced_spin(omega);
  }
  std::optional<double> interpolation_error() const override { return whole->interpolation_error(); }

protected:
  const SharedLoad whole;
};

/// Returns @p load truncated after @p n_harmonics; neither contact nor friction is solved again.
SharedLoad truncated(const SharedLoad &load, unsigned int n_harmonics);

/// Returns @p load interpolated between the spins @p lower and @p upper [rad/s], for curves of thousands of
/// values: by a SpinCurve to 1e-6 of a_0 if few samples suffice, else to @p enough, else to 1e-3, else exact;
/// exact outside the interval. A load that is not costly is returned unchanged. If @p like, another
/// interpolated load on the same rings, is one polynomial, the difference to @p like is interpolated.
SharedLoad interpolated(const SharedLoad &load, double lower, double upper, double enough = 2e-5,
                        const LoadAtSpin *like = nullptr);
} // namespace stemware::ring
