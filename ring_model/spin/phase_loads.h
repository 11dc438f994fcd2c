#pragma once

#include "ring_model/spin/adaptive_curve.h"
#include "ring_model/spin/phases.h"

#include <exception>
#include <functional>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace stemware::ring
{

/// Load at a spin [rad/s] and a phase; each call solves one contact or several.
using LoadAtPhase = std::function<Sample(double omega, const Orientation &phase)>;

/// Samples the load at rest over the phases until the error of its mean is 1e-6 mu N R
/// (PhaseSamples::error()). Begins with 8 phases of one angle, or 4 of each of two, and doubles the angle
/// with the larger error, up to 128 in each and @p max_samples in all. Throws NoBalance if the error of the
/// mean stays above @p max_error [mu N R], or the error between phases above 0.3.
PhaseSamples sample_phases(const LoadAtPhase &load, const PhasePeriods &periods, unsigned int max_samples,
                           double max_error = 3e-2);

/// Sampling of a load that depends on the spin.
struct SpinSampling
{
  double unit = 0; ///< length of the spin intervals from 0 on [rad/s]; 0: no dependence on the spin
  unsigned int max_samples = 17; ///< per interval
  std::size_t max_intervals = std::numeric_limits<std::size_t>::max();
  double rest = 0; ///< > 0: a shorter interval from - to + this spin [rad/s], for a glass that stays at rest
};

/// Load that depends on the phases of glass and table, and possibly on the spin. Sampled on one grid of
/// phases, at rest and at some spins of each requested interval; trigonometric in the phases, polynomial in
/// the spin.
class PhaseSampledLoad
{
public:
  /// Keeps a copy of @p load.
  PhaseSampledLoad(LoadAtPhase load, const PhasePeriods &periods, const PhaseSamples &at_rest,
                   const SpinSampling &spins = {});

  /// Returns the load at a spin and phase. Throws NoBalance if the samples around @p omega are not accurate
  /// enough (sample_phases()) or would exceed SpinSampling::max_intervals.
  Sample at(double omega, const Orientation &phase) const { return at_spin(omega).at(phase); }

  /// Returns the mean over all phases, which has the mean moment.
  Sample mean(double omega) const { return at_spin(omega).mean(); }

  /// Returns the load at the first of phases(), solved, not interpolated.
  Sample at_first_phase(double omega) const { return load(omega, phases().phase(0)); }

  /// Returns the interval of spins [rad/s] around @p omega on which at() is one polynomial; else infinite.
  std::pair<double, double> polynomial_range(double omega) const;

  /// Returns the loads at all sampled phases.
  std::vector<Sample> samples(double omega) const;
  const PhaseGrids &phases() const { return at_rest.phases(); }
  const PhasePeriods &periods() const { return phase_periods; }

  std::size_t n_spins() const; ///< sampled so far; 1 if the load does not depend on the spin
  /// Returns the largest error so far of mean() and at(): PhaseSamples::error() at rest and at the far end of
  /// each interval, plus the interpolation error in the spin.
  const SampleError &error() const { return largest_error; }
  /// Returns error() for the sampled spins from @p lower to @p upper [rad/s].
  SampleError error(double lower, double upper) const;

private:
  /// Loads at all phases on one interval of spins, PhaseSamples::columns() reshaped, and their error.
  using Interval = std::pair<AdaptiveCurve, SampleError>;

  bool varies_with_spin(double omega) const { return sampling.unit > 0 && omega != 0; }
  PhaseSamples at_spin(double omega) const;
  PhaseSamples samples_from(const Eigen::VectorXd &columns) const;
  const Interval &interval_around(double omega) const;
  /// Samples an interval to a torque_difference() of mean(); for a load with kinks in the spin, to 3e-2.
  Interval sampled(double lower, double upper) const;

  const LoadAtPhase load;
  const PhasePeriods phase_periods;
  const PhaseSamples at_rest;
  const SpinSampling sampling;
  mutable std::map<double, Interval> intervals;          ///< by their lower end [rad/s]
  mutable std::map<double, std::exception_ptr> failures; ///< failures of other intervals
  mutable SampleError largest_error;
};

} // namespace stemware::ring
