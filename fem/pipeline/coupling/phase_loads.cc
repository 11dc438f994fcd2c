#include "fem/pipeline/coupling/phase_loads.h"

#include "fem/pipeline/support/numbers.h"
#include "ring_model/coulomb_ring.h"

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace stemware::pipeline
{

namespace
{

/// Sampling goes on until the difference is below the first; once that has taken many phases, below the
/// second: each doubling doubles the work.
constexpr double tolerance = 1e-7, tolerance_of_many = 1e-5;
constexpr unsigned int many_phases = 32;
/// Above, more phases are taken even where they do not halve the error.
constexpr double good_enough = 3e-2;
/// Largest error allowed: of the mean over the phases, which the band of error contains, and between them,
/// where ripple alone depends on it.
constexpr double largest_of_mean = 3e-2, largest_between = 0.3;
constexpr unsigned int most_phases = 128; ///< of one angle

Eigen::VectorXd column_of(const LeaningLoad &load)
{
  const std::vector<double> row = load.coefficients(load.n_harmonics());
  return Eigen::Map<const Eigen::VectorXd>(row.data(), static_cast<Eigen::Index>(row.size()));
}

PeriodicGrid first_grid(double period)
{
  return period > 0 ? PeriodicGrid(period, 8) : PeriodicGrid(boost::math::double_constants::two_pi, 1);
}

/// Largest difference at those nodes of @p grids that half as many in one angle leave out.
double error_of_halved(const LoadAtPhase &load, const PhaseGrids &grids, bool in_glass)
{
  PhaseGrids halved = grids;
  PeriodicGrid &angle = in_glass ? halved.glass : halved.table;
  angle = angle.halved();
  const PhaseLoads loads(load, halved);
  double error = 0;
  for (unsigned int i = 0; i < grids.size(); ++i)
    if ((in_glass ? i / grids.table.size() : i % grids.table.size()) % 2 == 1)
      error = std::max(error, torque_difference(loads.at(0, grids.phase(i)), load(0, grids.phase(i))));
  return error;
}

/// Error of one angle's grid, as the samples themselves tell it.
struct AngleError
{
  AngleError(const LoadAtPhase &load, const PhaseGrids &grids, bool in_glass)
  {
    if ((in_glass ? grids.glass : grids.table).size() == 1)
      return;
    PhaseGrids halved = grids;
    PeriodicGrid &angle = in_glass ? halved.glass : halved.table;
    angle = angle.halved();
    const double of_quarter = error_of_halved(load, halved, in_glass);
    of_half = error_of_halved(load, grids, in_glass);
    falls = of_half < of_quarter / 2;
    estimate = of_half * std::min(1., of_half / of_quarter);
  }

  double of_half = 0;  ///< with half the phases, measured
  double estimate = 0; ///< with all of them, if it goes on to fall no slower
  bool falls = false;  ///< whether twice the phases have halved it
};

/// How far the mean over all phases is from that over half of them, of either angle.
double error_of_mean(const LoadAtPhase &load, const PhaseGrids &grids)
{
  const LeaningLoad mean = PhaseLoads(load, grids).mean(0);
  double error = 0;
  for (PeriodicGrid PhaseGrids::*angle : { &PhaseGrids::glass, &PhaseGrids::table })
  {
    PhaseGrids halved = grids;
    halved.*angle = (grids.*angle).halved();
    error += torque_difference(PhaseLoads(load, halved).mean(0), mean);
  }
  return error;
}

/// Largest difference at a few phases, none of which is near a node for ever finer grids.
double error_of_check(const LoadAtPhase &load, const PhaseGrids &grids)
{
  const PhaseLoads loads(load, grids);
  double error = 0;
  for (const double turns : { 0.618034, 0.236068, 0.854102 })
  {
    const ring::Orientation phase = { turns * grids.periods.glass, (1 - turns) * grids.periods.table };
    error = std::max(error, torque_difference(loads.at(0, phase), load(0, phase)));
  }
  return error;
}

void require_resolved(unsigned int n_phases, double error, double mean_error)
{
  if (error <= largest_between && mean_error <= largest_of_mean)
    return;
  throw ring::NoBalance("The load's dependence on the phase of the waviness is not resolved: between " +
                        std::to_string(n_phases) + " phases its torque is off by " + to_short_text(error) +
                        " mu N R, in the mean by " + to_short_text(mean_error) +
                        "; give more Contact/Azimuth lines, or a smaller waviness.");
}

} // namespace

double torque_difference(const LeaningLoad &one, const LeaningLoad &other)
{
  const ring::CoulombRing friction(1);
  const double radius = other.radius();
  double largest = 0;
  for (int quarter = -4; quarter <= 4; ++quarter)
  {
    const auto torque = [&](const LeaningLoad &load)
    { return friction.wrench(load, quarter / 4., radius).torque; };
    largest = std::max(largest, std::abs(torque(one) - torque(other)));
  }
  return largest / (other.normal_force() * radius);
}

PhaseGrids find_phases(const LoadAtPhase &load, const PhasePeriods &periods, unsigned int most_samples)
{
  PhaseGrids grids = { first_grid(periods.glass), first_grid(periods.table), periods };
  const auto can_refine = [&](const PeriodicGrid &grid)
  { return grid.size() > 1 && grid.size() < most_phases && 2 * grids.size() <= most_samples; };
  while (true)
  {
    grids.turning = true;
    AngleError glass(load, grids, true), table(load, grids, false);
    grids.turning = false;
    const AngleError unturned_glass(load, grids, true), unturned_table(load, grids, false);
    if (std::max(glass.of_half, table.of_half) < std::max(unturned_glass.of_half, unturned_table.of_half))
      grids.turning = true;
    else
    {
      glass = unturned_glass;
      table = unturned_table;
    }
    grids.error = std::max({ glass.estimate, table.estimate, error_of_check(load, grids) });
    const bool glass_is_worse = glass.estimate > table.estimate;
    PeriodicGrid &worse = glass_is_worse ? grids.glass : grids.table;
    const bool pays = grids.error > good_enough || (glass_is_worse ? glass : table).falls;
    if (grids.error <= (grids.size() < many_phases ? tolerance : tolerance_of_many) || !pays ||
        !can_refine(worse))
      break;
    worse = worse.refined();
  }
  grids.mean_error = error_of_mean(load, grids);
  require_resolved(grids.size(), grids.error, grids.mean_error);
  return grids;
}

PhaseLoads::PhaseLoads(LoadAtPhase load_given, const PhaseGrids &grids, const SpinSampling &spins_asked,
                       const PhaseExtremes &extremes)
    : load(std::move(load_given))
    , grids(grids)
    , spins_asked(spins_asked)
    , extremes(extremes)
    , at_rest(sample({ 0 }, grids).front())
    , largest_error(grids.error)
    , largest_mean_error(grids.mean_error)
{
}

LeaningLoad PhaseLoads::load_of(const Eigen::VectorXd &column) const
{
  return LeaningLoad::from_coefficients({ column.begin(), column.end() }, n_rings);
}

Eigen::Index PhaseLoads::n_harmonics(Eigen::Index n_rows) const
{
  return ((n_rows - 2) / static_cast<Eigen::Index>(n_rings) - 2) / 2;
}

unsigned int PhaseLoads::crest_harmonic(Eigen::Index n) const
{
  constexpr double turn = boost::math::double_constants::two_pi;
  return static_cast<unsigned int>(static_cast<double>(n) * grids.turning_period() / turn + 0.5);
}

void PhaseLoads::turn(Eigen::VectorXd &column, double angle) const
{
  if (grids.turning_period() == 0)
    return;
  const Eigen::Index n_max = n_harmonics(column.size());
  const double n_crests = boost::math::double_constants::two_pi / grids.turning_period();
  for (Eigen::Index n = 1; n <= n_max; ++n)
  {
    const double by = crest_harmonic(n) * n_crests * angle, cosine = std::cos(by), sine = std::sin(by);
    for (std::size_t j = 0; j < n_rings; ++j)
    {
      const Eigen::Index ring = static_cast<Eigen::Index>(j) * (2 * n_max + 2);
      double &even = column(ring + 1 + n), &odd = column(ring + 1 + n_max + n);
      const double before = even;
      even = before * cosine - odd * sine;
      odd = before * sine + odd * cosine;
    }
  }
}

std::vector<Eigen::MatrixXd> PhaseLoads::sample(const std::vector<double> &omegas, const PhaseGrids &on) const
{
  std::vector<Eigen::MatrixXd> columns(omegas.size());
  const unsigned int n_table = on.table.size();
  for (unsigned int step = 0; step < on.size(); ++step)
  {
    // To and fro in the table's angle: each contact starts from that of the phase before.
    const unsigned int row = step / n_table, place = step % n_table;
    const unsigned int i = row * n_table + (row % 2 == 0 ? place : n_table - 1 - place);
    // All spins of a phase in a row: each is near the one before.
    for (std::size_t k = 0; k < omegas.size(); ++k)
    {
      const LeaningLoad exact = load(omegas[k], on.phase(i));
      n_rings = exact.rings().size();
      Eigen::VectorXd column = column_of(exact);
      turn(column, -on.turning_angle(on.phase(i)));
      columns[k].conservativeResize(column.size(), on.size());
      columns[k].col(i) = column;
    }
  }
  return columns;
}

std::pair<SpinInterval, double> PhaseLoads::find_spins(long interval) const
{
  // How the load depends on the spin is much the same at every phase: one decides on the spins.
  const auto at_one_phase = [&](double omega) { return column_of(load(omega, grids.phase(0))); };
  const double lower = static_cast<double>(interval) * spins_asked.unit;
  SpinInterval spins(lower, lower + spins_asked.unit, 2);
  for (double error_before = std::numeric_limits<double>::infinity();;)
  {
    double error = 0;
    for (const double omega : spins.between())
    {
      const Eigen::VectorXd weights = spins.weights(omega), exact = at_one_phase(omega);
      Eigen::VectorXd interpolated = Eigen::VectorXd::Zero(exact.size());
      for (unsigned int k = 0; k < spins.size(); ++k)
        interpolated += weights(k) * at_one_phase(spins.node(k));
      error = std::max(error, torque_difference(load_of(interpolated), load_of(exact)));
    }
    const double enough =
      std::max({ tolerance, std::min(grids.error, tolerance_of_many) / 10, grids.mean_error });
    const bool pays = error > good_enough || error < error_before / 3;
    if (error <= enough || !pays || 2 * (spins.size() - 1) > spins_asked.most_steps)
      return { spins, error };
    error_before = error;
    spins = spins.refined();
  }
}

const PhaseLoads::Samples &PhaseLoads::samples_around(double omega) const
{
  const auto interval = static_cast<long>(std::floor(omega / spins_asked.unit));
  const auto known = intervals.find(interval);
  if (known != intervals.end())
    return known->second;
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

PhaseLoads::Samples PhaseLoads::samples_of(long interval) const
{
  const auto [spins, error_between_spins] = find_spins(interval);
  Samples samples = { spins, {} };
  const unsigned int middle = spins.size() / 2;
  for (const PhaseGrids &on : { grids.halved(), grids })
  {
    samples.columns = spread(spins.nodes(), on);
    const double error = error_of(samples);
    const LeaningLoad of_fewer = mean_of(spread({ spins.node(middle) }, on.halved()).front());
    const double of_mean = torque_difference(of_fewer, mean_of(samples.columns[middle]));
    if (on.size() < grids.size() &&
        (error > std::max(spins_asked.enough, grids.error) || of_mean > largest_of_mean / 2))
      continue;
    // Between spins the load may be off by as much at every phase, but a kink is not at the same spin.
    largest_error = std::max({ largest_error, error, error_between_spins });
    const double between_means = std::min(error_between_spins, error_of_halved_spins(samples));
    largest_mean_error = std::max(largest_mean_error, grids.mean_error + of_mean + between_means);
    require_resolved(on.size(), largest_error, largest_mean_error);
    break;
  }
  return samples;
}

std::vector<Eigen::MatrixXd> PhaseLoads::spread(const std::vector<double> &omegas, const PhaseGrids &on) const
{
  Eigen::MatrixXd weights(on.size(), grids.size());
  for (unsigned int i = 0; i < grids.size(); ++i)
    weights.col(i) = on.weights(grids.phase(i));
  const Eigen::MatrixXd rest = sample({ 0 }, on).front();
  std::vector<Eigen::MatrixXd> columns = sample(omegas, on);
  for (Eigen::MatrixXd &column : columns)
    column = at_rest + (column - rest) * weights;
  return columns;
}

double PhaseLoads::error_of(const Samples &samples) const
{
  const unsigned int n_table = grids.table.size(), k = samples.spins.size() / 2;
  double error = 0;
  for (const unsigned int row : { 1u, grids.glass.size() / 2 + 1 })
    for (const unsigned int place : { 1u, n_table / 2 + 1 })
    {
      const unsigned int i = row % grids.glass.size() * n_table + place % n_table;
      const ring::Orientation phase = grids.phase(i);
      Eigen::VectorXd column = samples.columns[k].col(i);
      turn(column, grids.turning_angle(phase));
      error = std::max(error, torque_difference(load_of(column), load(samples.spins.node(k), phase)));
    }
  return error;
}

double PhaseLoads::error_of_halved_spins(const Samples &samples) const
{
  const SpinInterval &spins = samples.spins;
  const unsigned int last = spins.size() - 1;
  const SpinInterval halved(spins.node(0), spins.node(last), last / 2);
  double error = 0;
  for (unsigned int k = 1; k < last; k += 2)
  {
    const Eigen::VectorXd weights = halved.weights(spins.node(k));
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(at_rest.rows(), at_rest.cols());
    for (unsigned int i = 0; i < halved.size(); ++i)
      sum += weights(i) * samples.columns[2 * i];
    error = std::max(error, torque_difference(mean_of(sum), mean_of(samples.columns[k])));
  }
  return error;
}

Eigen::MatrixXd PhaseLoads::at_spin(double omega) const
{
  if (spins_asked.unit == 0 || omega == 0)
    return at_rest;
  const Samples &samples = samples_around(omega);
  const Eigen::VectorXd weights = samples.spins.weights(omega);
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(at_rest.rows(), at_rest.cols());
  for (unsigned int k = 0; k < samples.spins.size(); ++k)
    sum += weights(k) * samples.columns[k];
  return sum;
}

Eigen::MatrixXd PhaseLoads::in_slip_frame(Eigen::MatrixXd columns) const
{
  for (unsigned int i = 0; i < grids.size(); ++i)
  {
    Eigen::VectorXd column = columns.col(i);
    turn(column, grids.turning_angle(grids.phase(i)));
    columns.col(i) = column;
  }
  return columns;
}

LeaningLoad PhaseLoads::at(double omega, const ring::Orientation &phase) const
{
  const Eigen::VectorXd of_phase = grids.weights(phase);
  Eigen::VectorXd column;
  if (spins_asked.unit == 0 || omega == 0)
    column = at_rest * of_phase;
  else
  {
    const Samples &samples = samples_around(omega);
    const Eigen::VectorXd weights = samples.spins.weights(omega);
    column.setZero(at_rest.rows());
    for (unsigned int k = 0; k < samples.spins.size(); ++k)
      column += weights(k) * (samples.columns[k] * of_phase);
  }
  turn(column, grids.turning_angle(phase));
  return load_of(column);
}

LeaningLoad PhaseLoads::mean(double omega) const
{
  return mean_of(at_spin(omega));
}

LeaningLoad PhaseLoads::mean_of(const Eigen::MatrixXd &columns) const
{
  const Eigen::MatrixXd loads = in_slip_frame(columns);
  Eigen::VectorXd mean_column = loads.rowwise().mean();
  // Of what turns with the crests there is a mean only up to the interpolant's highest frequency, which
  // counts half; the mean of the samples would take beats for one.
  const Eigen::Index n_max = grids.turning_period() > 0 ? n_harmonics(loads.rows()) : 0;
  for (Eigen::Index n = 1; n <= n_max; ++n)
    if (2 * crest_harmonic(n) >= grids.n_turning_phases())
      for (std::size_t j = 0; j < n_rings; ++j)
        for (const Eigen::Index row : { 1 + n, 1 + n_max + n })
          mean_column(static_cast<Eigen::Index>(j) * (2 * n_max + 2) + row) *=
            2 * crest_harmonic(n) == grids.n_turning_phases() ? 0.5 : 0;
  const LeaningLoad mean = load_of(mean_column);
  if (mean.rings().size() > 1)
    return mean; // its radii are the same at every phase
  // M_N = pi R (b_1, -a_1): the radius that makes it the mean moment.
  Eigen::Vector2d moment = Eigen::Vector2d::Zero();
  for (Eigen::Index i = 0; i < loads.cols(); ++i)
    moment += load_of(loads.col(i)).moment() / static_cast<double>(loads.cols());
  const ring::RingStack::Ring &ring = mean.rings().front();
  const double first = mean.moment().norm() / ring.radius;
  if (first == 0)
    return mean;
  return { ring::RingStack(ring.a, ring.b, moment.norm() / first), mean.tilt };
}

std::vector<ring::RingStack> PhaseLoads::samples(double omega) const
{
  const Eigen::MatrixXd loads = in_slip_frame(at_spin(omega));
  std::vector<ring::RingStack> all;
  for (Eigen::Index i = 0; i < loads.cols(); ++i)
    all.push_back(load_of(loads.col(i)));
  return all;
}

std::size_t PhaseLoads::n_spins() const
{
  std::size_t n = 1;
  for (const auto &[interval, samples] : intervals)
    n += samples.columns.size();
  return n;
}

} // namespace stemware::pipeline
