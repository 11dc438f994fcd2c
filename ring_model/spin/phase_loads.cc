#include "ring_model/spin/phase_loads.h"

#include "ring_model/load/require.h"
#include "ring_model/no_balance.h"
#include "ring_model/spin/to_precision.h"

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace stemware::ring
{

namespace
{

/// Error wanted of the mean over the phases, and of the load between spins: a tenth of what rim and table out
/// of flat leave unknown in most studies.
constexpr double tolerance = 1e-5;
/// Largest errors allowed: of the mean over the phases, which the band of error contains, and between them,
/// where ripple alone depends on it.
constexpr SampleError largest_allowed = { 3e-2, 0.3 };
/// Phases of one angle to begin with, alone and together with another, of which each asks for as many again:
/// the smallest numbers with a half and a quarter that tell their error.
constexpr unsigned int first_phases = 8, first_phases_of_two = 4;
constexpr unsigned int max_phases = 128; ///< of one angle

PeriodicGrid first_grid(double period, unsigned int n_phases)
{
  return period > 0 ? PeriodicGrid(period, n_phases) : PeriodicGrid(boost::math::double_constants::two_pi, 1);
}

void require_resolved(unsigned int n_phases, const SampleError &error, double max_mean = largest_allowed.mean)
{
  if (error.between <= largest_allowed.between && error.mean <= max_mean)
    return;
  throw NoBalance(sentence(
    "The dependence of the load on the phase of the waviness is not resolved: between ", n_phases,
    " phases its torque is off by ", to_precision(error.between, 6), " mu N R (allowed ",
    to_precision(largest_allowed.between, 2), "), in the mean by ", to_precision(error.mean, 6), " (allowed ",
    to_precision(max_mean, 2), "); give more Contact/Azimuth lines, or a smaller waviness."));
}

SampleError larger(const SampleError &one, const SampleError &other)
{
  return { std::max(one.mean, other.mean), std::max(one.between, other.between) };
}

/// Samples at the spins @p omegas.
std::vector<PhaseSamples> sample(const LoadAtPhase &load, const std::vector<double> &omegas,
                                 const PhaseGrids &grids)
{
  std::vector<Eigen::MatrixXd> columns(omegas.size());
  std::size_t n_rings = 1;
  const unsigned int n_table = grids.table.size();
  for (unsigned int step = 0; step < grids.size(); ++step)
  {
    // To and fro in the table's angle: each contact starts from that of the phase before.
    const unsigned int row = step / n_table, place = step % n_table;
    const unsigned int i = row * n_table + (row % 2 == 0 ? place : n_table - 1 - place);
    // All spins of a phase in a row: each is near the one before.
    for (std::size_t k = 0; k < omegas.size(); ++k)
    {
      const Sample exact = load(omegas[k], grids.phase(i));
      n_rings = exact.rings().size();
      const Eigen::VectorXd column = exact.coefficients(exact.n_harmonics());
      columns[k].conservativeResize(column.size(), grids.size());
      columns[k].col(i) = column;
    }
  }
  std::vector<PhaseSamples> samples;
  for (const Eigen::MatrixXd &of_spin : columns)
    samples.emplace_back(grids, of_spin, n_rings);
  return samples;
}

} // namespace

PhaseSamples sample_phases(const LoadAtPhase &load, const PhasePeriods &periods, const RestSampling &asked)
{
  const unsigned int first = periods.glass > 0 && periods.table > 0 ? first_phases_of_two : first_phases;
  PhaseGrids grids = { first_grid(periods.glass, first), first_grid(periods.table, first) };
  while (true)
  {
    const PhaseSamples samples = sample(load, { 0 }, grids).front();
    const double of_glass = samples.error(&PhaseGrids::glass).mean,
                 of_table = samples.error(&PhaseGrids::table).mean;
    PeriodicGrid &worse = of_glass > of_table ? grids.glass : grids.table;
    if (of_glass + of_table <= tolerance || worse.size() == max_phases ||
        2 * grids.size() > asked.max_samples)
    {
      require_resolved(grids.size(), samples.error(), asked.max_error);
      return samples;
    }
    worse = worse.refined();
  }
}

PhaseSamples PhaseSampledLoad::Samples::at(double omega) const
{
  const Eigen::VectorXd weights = spins.weights(omega);
  Eigen::MatrixXd sum = weights(0) * at_nodes.front().columns();
  for (unsigned int k = 1; k < spins.size(); ++k)
    sum += weights(k) * at_nodes[k].columns();
  return { at_nodes.front().phases(), sum, at_nodes.front().n_rings() };
}

PhaseSampledLoad::PhaseSampledLoad(LoadAtPhase load_given, const PhasePeriods &periods,
                                   const PhaseSamples &at_rest, const SpinSampling &spins_asked)
    : load(std::move(load_given))
    , phase_periods(periods)
    , at_rest(at_rest)
    , spins_asked(spins_asked)
    , largest_error(at_rest.error())
{
}

Sample PhaseSampledLoad::at(double omega, const Orientation &phase) const
{
  if (!varies_with_spin(omega))
    return at_rest.at(phase);
  // An integrator asks often: the phases go first, so that no samples are made.
  const Samples &samples = samples_around(omega);
  const Eigen::VectorXd spins = samples.spins.weights(omega);
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(samples.at_nodes.front().columns().rows());
  for (unsigned int k = 0; k < samples.spins.size(); ++k)
    sum += spins(k) * phases().interpolated(samples.at_nodes[k].columns(), phase);
  return Sample::from_coefficients(sum, samples.at_nodes.front().n_rings());
}

PhaseSamples PhaseSampledLoad::at_spin(double omega) const
{
  return varies_with_spin(omega) ? samples_around(omega).at(omega) : at_rest;
}

std::pair<ChebyshevInterval, double> PhaseSampledLoad::find_spins(long interval) const
{
  // How the load depends on the spin is much the same at every phase: one decides on the spins.
  const PhaseGrids one_phase = { first_grid(0, 1), first_grid(0, 1) };
  const double lower = static_cast<double>(interval) * spins_asked.unit;
  ChebyshevInterval spins(lower, lower + spins_asked.unit, 2);
  for (double error_before = std::numeric_limits<double>::infinity();;)
  {
    const Samples samples = { spins, sample(load, spins.nodes(), one_phase) };
    double error = 0;
    for (const double omega : spins.between())
      error =
        std::max(error, torque_difference(samples.at(omega).sample(0), load(omega, one_phase.phase(0))));
    const bool pays = error > largest_allowed.mean || error < error_before / 3;
    if (error <= std::max(tolerance, at_rest.error().mean) || !pays ||
        2 * (spins.size() - 1) > spins_asked.max_steps)
      return { spins, error };
    error_before = error;
    spins = spins.refined();
  }
}

const PhaseSampledLoad::Samples &PhaseSampledLoad::samples_around(double omega) const
{
  const auto interval = static_cast<long>(std::floor(omega / spins_asked.unit));
  const auto known = intervals.find(interval);
  if (known != intervals.end())
    return known->second;
  if (intervals.size() >= spins_asked.max_intervals)
    throw NoBalance(
      sentence("The spin swings with the phase of the waviness over more than ", spins_asked.max_intervals,
               " intervals of ", to_precision(spins_asked.unit, 3),
               " rad/s, each of which takes a contact at every phase; give a smaller waviness."));
  // A search for a spin comes back, with other spins of the same interval.
  if (const auto failed = failures.find(interval); failed != failures.end())
    std::rethrow_exception(failed->second);
  try
  {
    return intervals.emplace(interval, samples_of(interval)).first->second;
  }
  catch (...)
  {
    failures.emplace(interval, std::current_exception());
    throw;
  }
}

PhaseSampledLoad::Samples PhaseSampledLoad::samples_of(long interval) const
{
  const auto [spins, between_spins] = find_spins(interval);
  Samples samples = { spins, sample(load, spins.nodes(), phases()) };
  const PhaseSamples &farthest = interval < 0 ? samples.at_nodes.front() : samples.at_nodes.back();
  const SampleError of_phases = larger(at_rest.error(), farthest.error());
  // Between spins the load may be off by as much at every phase, but a kink is not at the same spin.
  samples.error = { of_phases.mean + std::min(between_spins, error_of_halved_spins(samples)),
                    std::max(of_phases.between, between_spins) };
  largest_error = larger(largest_error, samples.error);
  require_resolved(phases().size(), largest_error);
  return samples;
}

SampleError PhaseSampledLoad::error(double lower, double upper) const
{
  SampleError error = at_rest.error();
  for (const auto &[interval, samples] : intervals)
    if (const double begin = static_cast<double>(interval) * spins_asked.unit;
        begin <= upper && begin + spins_asked.unit >= lower)
      error = larger(error, samples.error);
  return error;
}

double PhaseSampledLoad::error_of_halved_spins(const Samples &samples) const
{
  const unsigned int n = samples.spins.size();
  Samples half = { ChebyshevInterval(samples.spins.node(0), samples.spins.node(n - 1), (n - 1) / 2), {} };
  for (unsigned int k = 0; k < n; k += 2)
    half.at_nodes.push_back(samples.at_nodes[k]);
  double error = 0;
  for (unsigned int k = 1; k < n; k += 2)
    error =
      std::max(error, torque_difference(half.at(samples.spins.node(k)).mean(), samples.at_nodes[k].mean()));
  return error;
}

std::pair<double, double> PhaseSampledLoad::polynomial_range(double omega) const
{
  if (!(spins_asked.unit > 0))
    return { -HUGE_VAL, HUGE_VAL };
  // Not the upper end itself: there the next samples begin.
  const double lower = std::floor(omega / spins_asked.unit) * spins_asked.unit;
  return { lower, lower + spins_asked.unit * (1 - 1e-9) };
}

std::vector<RingStack> PhaseSampledLoad::samples(double omega) const
{
  const PhaseSamples at = at_spin(omega);
  std::vector<RingStack> all;
  for (unsigned int i = 0; i < phases().size(); ++i)
    all.push_back(at.sample(i));
  return all;
}

std::size_t PhaseSampledLoad::n_spins() const
{
  std::size_t n = 1;
  for (const auto &[interval, samples] : intervals)
    n += samples.at_nodes.size();
  return n;
}

} // namespace stemware::ring
