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

namespace stemware::pipeline
{

class PhaseLoads;

/// No truncation.
inline constexpr unsigned int all_harmonics = std::numeric_limits<unsigned int>::max();

/// The load on the ring at every spin: what all questions about the spin are asked of, wherever the load
/// comes from.
///
/// A value with shared insides: copies are cheap, and the balances that one copy finds are known to all. A
/// load that is the same at every spin, or at every phase of an out-of-flat rim, is the special case that
/// does not look at the argument.
class BalancedLoad
{
public:
  using AtSpin = std::function<LeaningLoad(double omega)>;

  /// The insides of a load; at() goes through the functions, so they may solve contacts.
  struct Parts
  {
    LoadReport at_rest;
    AtSpin at_spin = {};                                 ///< empty: the load at rest
    std::shared_ptr<const PhaseLoads> phases = {};       ///< nothing where the phase does not matter
    std::shared_ptr<CouplingStatistics> statistics = {}; ///< nothing where the spin does not matter
    std::shared_ptr<const fem::ContactState>
      contact = {}; ///< at rest; nothing where the load does not come from one
    /// Solves the contact at a spin again; empty where it is the same at every spin.
    std::function<fem::ContactState(double omega)> contact_at = {};
    unsigned int n_kept = std::numeric_limits<unsigned int>::max(); ///< harmonics that at() gives
    bool is_costly = false; ///< whether a load takes contact solutions
  };

  explicit BalancedLoad(Parts parts);

  /// The load at the spin @p omega [rad/s]; the mean over the phases where these matter. Throws what contact
  /// solutions and balances throw.
  ring::RingStack at(double omega) const;

  /// The load with the marks of glass and table at @p orientation.
  ring::RingStack at(double omega, const ring::Orientation &orientation) const;

  ring::RingStack at_rest() const { return at(0); }

  /// at() with the glass's tilt.
  LeaningLoad leaning(double omega) const;
  LeaningLoad leaning(double omega, const ring::Orientation &orientation) const;

  /// This load cut off after @p n_harmonics; neither contact nor friction is solved again.
  BalancedLoad truncated(unsigned int n_harmonics) const;

  /// This load for curves of thousands of values on spins from @p lower to @p upper [rad/s], where each value
  /// would be a balance of its own: interpolated between exact ones, to 1e-8 of a_0 where 200 of them
  /// suffice, else to 1e-6 or 1e-5, or to @p coarsest if that is more, else exact; outside exact. The error
  /// goes to statistics(). A load that is not costly stays as it is.
  BalancedLoad interpolated(double lower, double upper, double coarsest = 1e-5) const;

  /// Highest harmonic of at().
  unsigned int n_harmonics() const;

  /// The spin v / R at which the ring at rest is as fast as the glass [rad/s].
  double spin_scale(const ring::Motion &motion) const;

  /// The insides, to make another load of.
  const Parts &insides() const { return *parts; }
  const LoadReport &report() const { return parts->at_rest; } ///< of the whole load at rest
  const PhaseLoads *phases() const { return parts->phases.get(); }
  const fem::ContactState *contact() const { return parts->contact.get(); }
  /// Parts::contact_at
  const std::function<fem::ContactState(double omega)> &contact_at() const { return parts->contact_at; }
  std::optional<CouplingStatistics> statistics() const;
  bool follows_spin() const { return parts->statistics != nullptr; }

private:
  BalancedLoad with_curve(AtSpin curve) const;

  std::shared_ptr<const Parts> parts;
  AtSpin curve; ///< in the place of parts->at_spin; empty: that itself
  unsigned int n_kept;
};

/// What a load is to be in balance with.
struct MomentBalance
{
  ring::Motion motion;
  ring::Closure closure = ring::Closure::full;
  ring::Orientation orientation; ///< of the marks of glass and table
};

/// The load of @p model in balance with the friction of its own first @p n_harmonics at every spin; @p
/// at_rest is the load at omega = 0, where the friction, (-mu N, 0), is known beforehand. @p n_harmonics cuts
/// what enters T and tau_z; friction in an elastic foot feels the whole pressure. @p progress is told of
/// every balance and must live as long as the load.
///
/// The load throws as ring::SelfConsistentRing::at() and the model do.
BalancedLoad balance(const std::shared_ptr<const ring::LoadModel> &model, const MomentBalance &balance,
                     const LoadReport &at_rest,
                     unsigned int n_harmonics = std::numeric_limits<unsigned int>::max(),
                     Progress &progress = silent_progress());

/// A load that a formula gives, as a report: pointwise quantities are those of the series.
LoadReport report_of(const ring::RingStack &load);

} // namespace stemware::pipeline
