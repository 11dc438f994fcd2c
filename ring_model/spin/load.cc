#include "ring_model/spin/load.h"

#include "ring_model/failures.h"
#include "ring_model/spin/phase_loads.h"

#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <exception>
#include <map>
#include <utility>

namespace stemware::ring
{
struct Load::Source
{
  struct Failure
  {
    std::exception_ptr cause;
    bool tips;
  };

  Function load;
  bool is_costly, is_pressure;
  std::shared_ptr<const PhaseSampledLoad> phases = {};
  mutable std::map<double, Sample> samples = {};
  mutable std::map<double, Failure> failures = {};

  const Sample &solved(double omega) const
  {
    if (const auto known = samples.find(omega); known != samples.end())
      return known->second;
    if (const auto failed = failures.find(omega); failed != failures.end())
      std::rethrow_exception(failed->second.cause);
    try
    {
      return samples.emplace(omega, load(omega)).first->second;
    }
    catch (const NoBalance &failure)
    {
      failures.emplace(omega, Failure{ std::current_exception(), failure.tips() });
      throw;
    }
  }
};

/// Interpolated Fourier coefficients of a load, or of its difference from the load `similar`.
struct Load::Interpolant
{
  unsigned int n_harmonics;
  std::size_t n_rings;
  std::optional<Load> similar;
  std::optional<AdaptiveCurve> rows = {};

  Eigen::VectorXd reference(double omega) const
  {
    const auto size = static_cast<Eigen::Index>(2 + n_rings * (2 * n_harmonics + 3));
    return similar ? similar->at(omega).coefficients(n_harmonics) : Eigen::VectorXd::Zero(size);
  }
  Sample load_of(double omega, const Eigen::VectorXd &row) const
  {
    return Sample::from_coefficients(similar ? row + reference(omega) : row, n_rings);
  }
};

Load::Load(Function load, bool is_pressure)
    : source(std::make_shared<Source>(Source{ std::move(load), false, is_pressure }))
{
}

Load::Load(std::shared_ptr<const PhaseSampledLoad> phases)
    : source(std::make_shared<Source>(Source{ {}, false, true, std::move(phases) }))
{
}

Load Load::solved_once(Function solve, const Sample &at_rest)
{
  Load load{ Function() };
  load.source = std::make_shared<Source>(Source{ std::move(solve), true, true, {}, { { 0., at_rest } } });
  return load;
}

Sample Load::at(double omega, const std::optional<Orientation> &marks) const
{
  const auto kept = [&](const Sample &all)
  { return all.n_harmonics() > n_kept ? all.truncated(n_kept) : all; };
  if (curve && curve->rows->covers(omega) && source->samples.count(omega) == 0)
    return kept(curve->load_of(omega, (*curve->rows)(omega)));
  if (const PhaseSampledLoad *phased = phases())
    return kept(marks ? phased->at(omega, *marks) : phased->mean(omega));
  return kept(source->is_costly ? source->solved(omega) : source->load(omega));
}

unsigned int Load::n_harmonics() const
{
  return at(0.).n_harmonics();
}

bool Load::is_costly() const
{
  return source->is_costly && !curve;
}

bool Load::is_pressure() const
{
  return source->is_pressure;
}

const PhaseSampledLoad *Load::phases() const
{
  return source->phases.get();
}

double Load::stability_margin(double omega) const
{
  const auto known = source->samples.find(omega);
  return known == source->samples.end() ? 1. : known->second.stability_margin;
}

std::optional<double> Load::nearest_unbalanced_spin(double omega) const
{
  std::optional<double> first;
  for (const auto &[spin, failure] : source->failures)
    if (failure.tips && spin * omega > 0. && std::abs(spin) < std::abs(first.value_or(omega)))
      first = spin;
  return first;
}

std::optional<double> Load::interpolation_error() const
{
  return curve ? std::optional(curve->rows->error()) : std::nullopt;
}

Load Load::truncated(unsigned int n_harmonics) const
{
  Load fewer = *this;
  fewer.n_kept = std::min(n_kept, n_harmonics);
  return fewer;
}

std::vector<double> Load::lift_offs(double lower, double upper) const
{
  std::vector<std::pair<double, double>> known;
  for (const auto &[omega, sample] : source->samples)
    if (lower <= omega && omega <= upper)
      known.emplace_back(omega, sample.lift_off_margin);
  std::vector<double> spins;
  for (std::size_t i = 0; i + 1 < known.size(); ++i)
  {
    const auto &[left, at_left] = known[i];
    const auto &[right, at_right] = known[i + 1];
    if ((at_left < 0) == (at_right < 0))
      continue;
    const auto margin = [&](double omega) { return at(omega).lift_off_margin; };
    // An error d in the spin at which lift-off begins causes an error of about d^(3/2) in the load.
    const double accuracy = 1e-5 * (upper - lower);
    std::uintmax_t n_most = 7;
    const auto [below, above] = boost::math::tools::toms748_solve(
      margin, left, right, at_left, at_right,
      [=](double one, double other) { return std::abs(other - one) < accuracy; }, n_most);
    spins.push_back((below + above) / 2);
  }
  return spins;
}

Load Load::interpolated(double lower, double upper, const CurveTolerance &tolerance,
                        const Load *similar) const
{
  if (!is_costly() || !(lower < upper))
    return *this;
  const Sample at_rest = at(0.);
  Interpolant interpolant = { at_rest.n_harmonics(), at_rest.rings().size(), {} };
  if (similar && similar->curve && similar->curve->rows->n_pieces() == 1 &&
      similar->curve->rows->covers(lower) && similar->curve->rows->covers(upper) &&
      similar->at(0.).radii() == at_rest.radii())
    interpolant.similar = *similar;
  CurveSource costly = {
    [&](double omega) -> Eigen::VectorXd
    { return at(omega).coefficients(interpolant.n_harmonics) - interpolant.reference(omega); },
    [&](double omega, const Eigen::VectorXd &one, const Eigen::VectorXd &exact)
    { return interpolant.load_of(omega, one).difference(interpolant.load_of(omega, exact)); }
  };
  for (const double end : { lower, upper })
    at(end);
  costly.kinks = lift_offs(lower, upper);
  for (const auto &[omega, sample] : source->samples)
    costly.cached.push_back(omega);
  interpolant.rows.emplace(costly, lower, upper, tolerance);
  Load found = *this;
  found.curve = std::make_shared<Interpolant>(std::move(interpolant));
  return found;
}
} // namespace stemware::ring
