#include "ring_model/spin/phase_loads.h"

#include "ring_model/failures.h"
#include "ring_model/load/constants.h"
#include "ring_model/load/require.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace stemware::ring
{

namespace
{

/// Torque tolerances [mu N R] of the load averaged over the phases and of its interpolation in the spin.
constexpr double tolerance_of_phases = 1e-6, tolerance_of_spins = 1e-5;
/// Maximum torque errors [mu N R] of the mean load (part of the error band) and of the load interpolated in
/// the phase (affects mainly the ripple of the spin).
constexpr SampleError largest_allowed = { 3e-2, 0.3 };
/// Initial number of phases per angle for loads that depend on one angle (first) or two angles (second).
/// Powers of two allow an error estimate from every second and every fourth phase.
constexpr unsigned int first_phases = 8, first_phases_of_two = 4;
constexpr unsigned int max_phases = 128;

PeriodicGrid first_grid(double period, unsigned int n_phases)
{
  return period > 0 ? PeriodicGrid(period, n_phases) : PeriodicGrid(2 * pi, 1);
}

void require_resolved(unsigned int n_phases, const SampleError &error, double max_mean = largest_allowed.mean)
{
  if (error.between <= largest_allowed.between && error.mean <= max_mean)
    return;
  throw NoBalance(sentence(
    "The dependence of the load on the phase of the waviness is not resolved: between ", n_phases,
    " phases its torque is off by ", rounded_text(error.between, 6), " mu N R (allowed ",
    rounded_text(largest_allowed.between, 2), "), in the mean by ", rounded_text(error.mean, 6), " (allowed ",
    rounded_text(max_mean, 2), "); give more Contact/Azimuth lines, or a smaller waviness."));
}

SampleError larger(const SampleError &one, const SampleError &other)
{
  return { std::max(one.mean, other.mean), std::max(one.between, other.between) };
}

PhaseSamples sampled_at(const LoadAtPhase &load, double omega, const PhaseGrids &grids)
{
  Eigen::MatrixXd columns;
  std::size_t n_rings = 1;
  const unsigned int n_table = grids.table.size();
  for (unsigned int step = 0; step < grids.size(); ++step)
  {
    // The table's angles increase and decrease in turn, so contact solves start from a neighbouring phase.
    const unsigned int row = step / n_table, place = step % n_table;
    const unsigned int i = row * n_table + (row % 2 == 0 ? place : n_table - 1 - place);
    const Sample exact = load(omega, grids.phase(i));
    n_rings = exact.rings().size();
    const Eigen::VectorXd column = exact.coefficients(exact.n_harmonics());
    columns.conservativeResize(column.size(), grids.size());
    columns.col(i) = column;
  }
  return { grids, columns, n_rings };
}

} // namespace

PhaseSamples sample_phases(const LoadAtPhase &load, const PhasePeriods &periods, unsigned int max_samples,
                           double max_error)
{
  const unsigned int first = periods.glass > 0 && periods.table > 0 ? first_phases_of_two : first_phases;
  PhaseGrids grids = { first_grid(periods.glass, first), first_grid(periods.table, first) };
  while (true)
  {
    const PhaseSamples samples = sampled_at(load, 0, grids);
    const double of_glass = samples.error(&PhaseGrids::glass).mean,
                 of_table = samples.error(&PhaseGrids::table).mean;
    PeriodicGrid &worse = of_glass > of_table ? grids.glass : grids.table;
    if (of_glass + of_table <= tolerance_of_phases || worse.size() == max_phases ||
        2 * grids.size() > max_samples)
    {
      require_resolved(grids.size(), samples.error(), max_error);
      return samples;
    }
    worse = worse.refined();
  }
}

PhaseSampledLoad::PhaseSampledLoad(LoadAtPhase load_given, const PhasePeriods &periods,
                                   const PhaseSamples &at_rest, const SpinSampling &sampling)
    : load(std::move(load_given))
    , phase_periods(periods)
    , at_rest(at_rest)
    , sampling(sampling)
    , largest_error(at_rest.error())
{
}

PhaseSamples PhaseSampledLoad::samples_from(const Eigen::VectorXd &columns) const
{
  return { phases(), columns.reshaped(at_rest.columns().rows(), phases().size()), at_rest.n_rings() };
}

PhaseSamples PhaseSampledLoad::at_spin(double omega) const
{
  return varies_with_spin(omega) ? samples_from(interval_around(omega).first(omega)) : at_rest;
}

const PhaseSampledLoad::Interval &PhaseSampledLoad::interval_around(double omega) const
{
  const double lower = polynomial_range(omega).first,
               upper = std::abs(omega) <= sampling.rest ? sampling.rest : lower + sampling.unit;
  const auto known = intervals.find(lower);
  if (known != intervals.end())
    return known->second;
  if (intervals.size() >= sampling.max_intervals)
    throw NoBalance(
      sentence("The spin swings with the phase of the waviness over more than ", sampling.max_intervals,
               " intervals of ", rounded_text(sampling.unit, 3),
               " rad/s, each of which takes a contact at every phase; give a smaller waviness."));
  // Failures are cached, because a search requests the failed interval again at other spins.
  if (const auto failed = failures.find(lower); failed != failures.end())
    std::rethrow_exception(failed->second);
  try
  {
    return intervals.emplace(lower, sampled(lower, upper)).first->second;
  }
  catch (...)
  {
    failures.emplace(lower, std::current_exception());
    throw;
  }
}

PhaseSampledLoad::Interval PhaseSampledLoad::sampled(double lower, double upper) const
{
  const auto columns = [&](double omega) -> Eigen::VectorXd
  { return sampled_at(load, omega, phases()).columns().reshaped(); };
  const auto error_of_mean = [&](double, const Eigen::VectorXd &interpolated, const Eigen::VectorXd &exact)
  { return torque_difference(samples_from(interpolated).mean(), samples_from(exact).mean()); };
  // The target is ten times the wanted error, because the last sample typically reduces the error to a tenth.
  CurveTolerance tolerances;
  tolerances.target = 10 * std::max(tolerance_of_spins, at_rest.error().mean);
  tolerances.relaxed = std::max(tolerances.target, 1e-3);
  tolerances.max_samples = sampling.max_samples;
  tolerances.usual_samples = std::min<std::size_t>(9, tolerances.max_samples);
  const AdaptiveCurve curve({ columns, error_of_mean }, lower, upper, tolerances);
  // The samples may miss a kink, so the error is also measured between sampled spins, at one phase.
  constexpr int n_checks = 6;
  constexpr double safety = 2;
  double between_spins = 0;
  for (int i = 0; i < n_checks; ++i)
  {
    const double omega = lower + (upper - lower) * (i + 0.5) / n_checks;
    const Sample interpolated = samples_from(curve(omega)).sample(0);
    between_spins =
      std::max(between_spins, safety * torque_difference(interpolated, load(omega, phases().phase(0))));
  }
  const PhaseSamples farthest = samples_from(curve(lower < 0 ? lower : upper));
  const SampleError of_phases = larger(at_rest.error(), farthest.error());
  const SampleError error = { of_phases.mean + between_spins, std::max(of_phases.between, between_spins) };
  largest_error = larger(largest_error, error);
  require_resolved(phases().size(), largest_error);
  return { curve, error };
}

SampleError PhaseSampledLoad::error(double lower, double upper) const
{
  SampleError largest = at_rest.error();
  for (const auto &[begin, interval] : intervals)
    if (const auto &[curve, error] = interval; begin <= upper && curve.upper() >= lower)
      largest = larger(largest, error);
  return largest;
}

std::pair<double, double> PhaseSampledLoad::polynomial_range(double omega) const
{
  if (!(sampling.unit > 0))
    return { -HUGE_VAL, HUGE_VAL };
  if (std::abs(omega) <= sampling.rest)
    return { -sampling.rest, sampling.rest };
  const double lower = std::floor(omega / sampling.unit) * sampling.unit;
  return { lower, lower + sampling.unit * (1 - 1e-9) };
}

std::vector<Sample> PhaseSampledLoad::samples(double omega) const
{
  const PhaseSamples at = at_spin(omega);
  std::vector<Sample> all;
  for (unsigned int i = 0; i < phases().size(); ++i)
    all.push_back(at.sample(i));
  return all;
}

std::size_t PhaseSampledLoad::n_spins() const
{
  std::size_t n = 1;
  for (const auto &[begin, interval] : intervals)
    n += interval.first.n_samples();
  return n;
}

} // namespace stemware::ring
