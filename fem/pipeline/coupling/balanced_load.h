#pragma once

#include "fem/contact/foot.h"
#include "fem/pipeline/coupling/contact_report.h"
#include "fem/pipeline/coupling/leaning_load.h"
#include "fem/pipeline/support/progress.h"
#include "ring_model/load_model.h"
#include "ring_model/moment_balance.h"
#include "ring_model/motion.h"

#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace stemware::pipeline
{

class BalancedLoad;
class PhaseLoads;

/// Loads are shared: the balances that one owner finds are known to all.
using SharedLoad = std::shared_ptr<const BalancedLoad>;

/// No truncation.
inline constexpr unsigned int all_harmonics = std::numeric_limits<unsigned int>::max();

/// The load on the ring at every spin: what all questions about the spin are asked of, wherever the load
/// comes from. All loads are SharedLoad.
class BalancedLoad : public std::enable_shared_from_this<BalancedLoad>
{
public:
  virtual ~BalancedLoad() = default;

  /// The load at the spin @p omega [rad/s] and the glass's tilt, with the marks of glass and table at @p
  /// marks; the mean over the phases where these matter and are not given. Throws what contact solutions and
  /// balances throw.
  virtual LeaningLoad at(double omega, const std::optional<ring::Orientation> &marks = {}) const = 0;

  /// The whole load at rest.
  virtual const LoadReport &report() const = 0;
  /// Highest harmonic of at().
  virtual unsigned int n_harmonics() const { return report().rings.n_harmonics(); }
  /// Whether a load takes contact solutions.
  virtual bool is_costly() const { return false; }
  /// The contact at a spin; nothing where the load does not come from one.
  virtual std::optional<fem::ContactState> contact(double /*omega*/) const { return std::nullopt; }
  /// Nothing where the phase does not matter.
  virtual const PhaseLoads *phases() const { return nullptr; }
  /// Where the load is known without a contact solution [rad/s], ascending.
  virtual std::vector<double> known_spins() const { return {}; }
  /// How far the rim is from lifting off at @p omega, one of known_spins(): the least pointwise load over
  /// a_0; where it has lifted off, how far below 0 the least load would be that a first harmonic continues to
  /// there, by the arc that carries nothing.
  virtual double clearance(double /*omega*/) const { return 1; }
  /// fem::ContactSolution::steadiness at @p omega, a spin that at() has been asked for; 1 if that is not
  /// known.
  virtual double steadiness(double /*omega*/) const { return 1; }
  /// The spin nearest to rest, on the way from there to @p omega, at which a contact that was asked for falls
  /// over; nothing where none is known.
  virtual std::optional<double> fall_before(double /*omega*/) const { return std::nullopt; }
  /// How the loads have been found so far; nothing where they are the same at every spin.
  virtual std::optional<CouplingStatistics> statistics() const { return std::nullopt; }

  /// This load cut off after @p n_harmonics; neither contact nor friction is solved again.
  SharedLoad truncated(unsigned int n_harmonics) const;

  /// This load for curves of thousands of values on spins from @p lower to @p upper [rad/s], where each value
  /// would be a balance of its own: interpolated between exact ones (LoadCurve) to 1e-6 of a_0
  /// where few of them suffice, else to @p enough, else to 1e-3, else exact; outside exact. The error is in
  /// its statistics(). A load that is not costly stays as it is. Where @p like, another
  /// interpolated load on the same rings, has no kink, the difference to it is interpolated.
  SharedLoad interpolated(double lower, double upper, double enough = 2e-5,
                          const BalancedLoad *like = nullptr) const;

  /// The spin v / R at which the ring at rest is as fast as the glass [rad/s].
  double spin_scale(const ring::Motion &motion) const { return motion.orbit_speed / report().rings.radius(); }
};

/// A load that a function of the spin gives, or that is the same at every spin.
class GivenLoad : public BalancedLoad
{
public:
  explicit GivenLoad(LoadReport at_rest, std::function<LeaningLoad(double omega)> function = {})
      : at_rest(std::move(at_rest))
      , function(std::move(function))
  {
  }
  /// The same at every spin, from the contact @p state.
  GivenLoad(LoadReport at_rest, const fem::ContactState &state)
      : at_rest(std::move(at_rest))
      , state(state)
  {
  }

  LeaningLoad at(double omega, const std::optional<ring::Orientation> &) const override
  {
    return function ? function(omega) : LeaningLoad(at_rest.rings, at_rest.tilt);
  }
  const LoadReport &report() const override { return at_rest; }
  std::optional<fem::ContactState> contact(double) const override { return state; }

private:
  const LoadReport at_rest;
  const std::function<LeaningLoad(double omega)> function;
  const std::optional<fem::ContactState> state;
};

/// Another load but for what it changes.
class ChangedLoad : public BalancedLoad
{
public:
  explicit ChangedLoad(SharedLoad whole)
      : whole(std::move(whole))
  {
  }

  const LoadReport &report() const override { return whole->report(); }
  unsigned int n_harmonics() const override { return whole->n_harmonics(); }
  bool is_costly() const override { return whole->is_costly(); }
  std::optional<fem::ContactState> contact(double omega) const override { return whole->contact(omega); }
  const PhaseLoads *phases() const override { return whole->phases(); }
  std::vector<double> known_spins() const override { return whole->known_spins(); }
  double clearance(double omega) const override { return whole->clearance(omega); }
  double steadiness(double omega) const override { return whole->steadiness(omega); }
  std::optional<double> fall_before(double omega) const override { return whole->fall_before(omega); }
  std::optional<CouplingStatistics> statistics() const override { return whole->statistics(); }

protected:
  const SharedLoad whole;
};

/// The load of @p model in balance with the friction of its own first @p n_harmonics at every spin; @p
/// at_rest is the load at omega = 0, where the friction, (-mu N, 0), is known beforehand. @p n_harmonics cuts
/// what enters T and tau_z; friction in an elastic foot feels the whole pressure.
///
/// The load throws as ring::SelfConsistentRing::at() and the model do.
SharedLoad balance(const std::shared_ptr<const ring::LoadModel> &model, const ring::Motion &motion,
                   ring::Closure closure, LoadReport at_rest, unsigned int n_harmonics = all_harmonics);

/// A load that a formula gives, as a report: pointwise quantities are those of the series.
LoadReport report_of(const ring::RingStack &load);

} // namespace stemware::pipeline
