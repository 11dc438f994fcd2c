#pragma once

#include "ring_model/spin/phases.h"

#include <exception>
#include <functional>
#include <map>
#include <utility>
#include <vector>

namespace stemware::ring
{

/// The load at a spin [rad/s] with the marks at a phase; each is a contact solution, or several.
using LoadAtPhase = std::function<LeaningLoad(double omega, const Orientation &phase)>;

/// Samples at rest, as many as their mean takes: 8 of one angle or 4 of each of two, doubled in the angle in
/// which half of them have a mean farther off, until the mean of half is within 1e-5,
/// PhaseSamples::error(); at most 128 in each angle and @p max_samples together. Throws NoBalance, with a
/// sentence, where the error of the mean stays above 3e-2 or that between phases above 0.3.
PhaseSamples sample_phases(const LoadAtPhase &load, const PhasePeriods &periods, unsigned int max_samples);

/// Sampling of a load that depends on the spin.
struct SpinSampling
{
  double unit = 0; ///< length of the intervals of spins, which begin at 0 [rad/s]; 0: no dependence
  unsigned int max_steps = 16; ///< on an interval, a power of two
};

/// The worst of all sampled phases, at rest.
struct PhaseExtremes
{
  double least_load = 0;             ///< pointwise [N/rad]
  double least_contact_fraction = 0; ///< LoadReport::contact_fraction
};

/// A load that depends on where the marks of glass and table stand, and maybe on the spin: sampled at rest on
/// a grid of phases; what the spin changes is sampled at some of these phases and, interval by interval as
/// spins are asked for, on Chebyshev points; interpolated in between, trigonometrically in the phases and by
/// polynomials in the spin.
class PhaseSampledLoad
{
public:
  /// @p load is kept.
  PhaseSampledLoad(LoadAtPhase load, const PhasePeriods &periods, const PhaseSamples &at_rest,
                   const SpinSampling &spins = {}, const PhaseExtremes &extremes = {});

  /// Throws NoBalance, as sample_phases(), where the samples round @p omega leave as large an error.
  LeaningLoad at(double omega, const Orientation &phase) const;

  /// Mean over all phases. It carries the mean moment.
  LeaningLoad mean(double omega) const { return at_spin(omega).mean(); }

  /// The load with the marks at the first of phases(), asked for itself, not interpolated.
  LeaningLoad at_first_phase(double omega) const { return load(omega, phases().phase(0)); }

  /// Returns the spins [rad/s] between which at() is one polynomial of the same samples as at @p omega:
  /// without bounds if the load does not depend on the spin.
  std::pair<double, double> polynomial_range(double omega) const;

  /// The loads at all sampled phases.
  std::vector<RingStack> samples(double omega) const;
  const PhaseGrids &phases() const { return at_rest.phases(); }
  const PhasePeriods &periods() const { return phase_periods; }

  std::size_t n_spins() const; ///< sampled so far; 1 where the load does not depend on the spin
  /// Largest error so far of mean() and of at(): PhaseSamples::error() at rest, that of the change to the
  /// farther end of each interval of spins, and what interpolation between spins leaves, at one phase or, for
  /// the mean, if that is less, what half of the spins say otherwise.
  const SampleError &error() const { return largest_error; }
  const PhaseExtremes &at_rest_extremes() const { return extremes; }

private:
  /// Samples on one interval of spins.
  struct Samples
  {
    PhaseSamples at(double omega) const;

    ChebyshevInterval spins;
    std::vector<PhaseSamples> at_nodes; ///< of the spins
  };

  bool varies_with_spin(double omega) const { return spins_asked.unit > 0 && omega != 0; }
  PhaseSamples at_spin(double omega) const;
  /// Spins of an interval, as many as it takes, and the error between them, torque_difference(); where the
  /// load has kinks in the spin, as many as it takes below 3e-2 until twice as many leave over a third of it.
  std::pair<ChebyshevInterval, double> find_spins(long interval) const;
  /// Changes that the spins @p omegas make in the loads at rest, at the phases of @p grids: a matrix for each
  /// spin, with a column for each phase.
  std::vector<Eigen::MatrixXd> changes_from_rest(const std::vector<double> &omegas,
                                                 const PhaseGrids &grids) const;
  /// Some of phases(), as many as it takes to know what the spin @p omega changes in the mean, and the error
  /// that they leave of that change.
  std::pair<PhaseGrids, SampleError> sample_phases_of_change(double omega) const;
  /// The loads at rest and, interpolated between the phases of @p grids, @p changes: a column for each.
  PhaseSamples changed(const PhaseGrids &grids, const Eigen::MatrixXd &changes) const;
  const Samples &samples_around(double omega) const;
  Samples samples_of(long interval) const;
  /// Largest torque_difference() of mean() at every other spin of @p samples from what the others say.
  double error_of_halved_spins(const Samples &samples) const;

  const LoadAtPhase load;
  const PhasePeriods phase_periods;
  const PhaseSamples at_rest;
  const SpinSampling spins_asked;
  const PhaseExtremes extremes;
  mutable std::map<long, Samples> intervals;
  mutable std::map<long, std::exception_ptr> failures; ///< of other intervals
  mutable SampleError largest_error;
};

} // namespace stemware::ring
