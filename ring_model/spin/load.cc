#include "ring_model/spin/load.h"

#include "ring_model/no_balance.h"
#include "ring_model/spin/phase_loads.h"
#include "ring_model/spin/spin_curve.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <map>
#include <utility>

namespace stemware::ring
{
/// Origin of a load, with everything solved so far.
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
  if (curve && curve->lower() <= omega && omega <= curve->upper())
    return kept((*curve)(omega));
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
  return curve ? std::optional(curve->error()) : std::nullopt;
}

Load Load::truncated(unsigned int n_harmonics) const
{
  Load fewer = *this;
  fewer.n_kept = std::min(n_kept, n_harmonics);
  return fewer;
}

Load Load::interpolated(double lower, double upper, double enough, const Load *like) const
{
  if (!is_costly() || !(lower < upper))
    return *this;
  CurveSource costly = { [this](double omega) { return at(omega); } };
  for (const auto &[omega, sample] : source->samples)
    costly.known.emplace(omega, at(omega));
  if (like && like->curve && like->curve->n_pieces() == 1 && like->curve->lower() <= lower &&
      upper <= like->curve->upper() && like->at(0.).radii() == at(0.).radii())
    costly.reference = *like->curve;
  CurveTolerance tolerance;
  tolerance.enough = enough;
  Load found = *this;
  found.curve = std::make_shared<SpinCurve>(costly, lower, upper, tolerance);
  return found.curve->error() > tolerance.coarsest ? *this : found;
}
} // namespace stemware::ring
