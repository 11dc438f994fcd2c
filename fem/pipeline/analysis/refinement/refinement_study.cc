#include "fem/pipeline/analysis/refinement/refinement_study.h"

#include "fem/pipeline/analysis/refinement/goal_mesh.h"
#include "fem/pipeline/analysis/spin.h"
#include "fem/pipeline/coupling/study_load.h"
#include "fem/pipeline/support/failures.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

namespace stemware::pipeline
{

namespace
{

constexpr double safety = 1.25;          ///< of three levels that show an order
constexpr double two_level_safety = 1.5; ///< of two levels, taken as first order
constexpr double wide_safety = 3.;       ///< of anything else
constexpr double least_order = 0.5;      ///< plausible orders
constexpr double greatest_order = 8.;
constexpr double trusted_order = 1.; ///< no higher order narrows a band

/// Largest minus least of the last three values.
double range_of_last(const std::vector<double> &values)
{
  const auto first = values.end() - std::min<std::ptrdiff_t>(3, std::distance(values.begin(), values.end()));
  const auto [least, largest] = std::minmax_element(first, values.end());
  return *largest - *least;
}

/// p of the last three values, if they have a plausible one.
std::optional<double> observed_order(const std::vector<double> &values, double rounding)
{
  if (values.size() < 3)
    return std::nullopt;
  const double *const last = &values.back();
  const double coarse_step = *(last - 1) - *(last - 2);
  const double fine_step = *last - *(last - 1);
  if (std::abs(fine_step) <= rounding || coarse_step * fine_step <= 0)
    return std::nullopt;
  const double order = std::log2(coarse_step / fine_step);
  return least_order <= order && order <= greatest_order ? std::optional(order) : std::nullopt;
}

void judge_algebraic(const std::vector<double> &values, double rounding, RefinementSequence &sequence)
{
  const double fine_step = values.size() > 1 ? values.back() - values[values.size() - 2] : 0;
  sequence.order = observed_order(values, rounding);
  if (!sequence.order)
  {
    const double factor = values.size() == 2 ? two_level_safety : wide_safety;
    sequence.uncertainty = factor * range_of_last(values);
    return;
  }
  sequence.limit += fine_step / (std::exp2(*sequence.order) - 1);
  sequence.uncertainty =
    safety * std::abs(fine_step) / (std::exp2(std::min(*sequence.order, trusted_order)) - 1);
}

void judge_spectral(const std::vector<double> &values, RefinementSequence &sequence)
{
  const auto step = [&](std::size_t from_end)
  {
    return values.size() > from_end
             ? std::abs(values[values.size() - from_end] - values[values.size() - from_end - 1])
             : 0;
  };
  sequence.uncertainty = safety * std::max(step(1), step(2) / 4);
}

using Quantities = std::vector<QuantityOfInterest>;

/// A level that has to be solved: not the study itself.
struct OpenLevel : RefinementLevel
{
  std::size_t axis, place; ///< which axis, and which level of it
};

/// Throws what the level has thrown, with the level named in front.
void require_solved(const OpenLevel &level, const Solved<Quantities> &solved)
{
  const std::string where =
    "Level " + std::to_string(level.size) + " of the refinement in " + level.name + ": ";
  try
  {
    solved.value();
  }
  catch (const BadInput &failure)
  {
    throw BadInput(where + failure.what());
  }
  catch (const std::runtime_error &failure) // a contact or a balance that does not exist
  {
    throw ring::NoBalance(where + failure.what());
  }
}

AxisResult judge(const RefinementAxis &axis, const std::vector<Quantities> &levels)
{
  AxisResult result = { axis, {} };
  for (std::size_t f = 0; f < levels[axis.own].size(); ++f)
  {
    QuantitySequence &sequence = result.quantities.emplace_back();
    double rounding = 0;
    bool has_correction = false;
    for (const Quantities &level : levels)
    {
      sequence.values.push_back(level[f].value);
      sequence.corrections.push_back(level[f].mesh_correction);
      rounding = std::max(rounding, level[f].rounding);
      has_correction |= level[f].mesh_correction.has_value();
    }
    sequence.judged = judge_refinement(sequence.values, axis.decay, rounding);
    if (axis.role != AxisRole::space || !has_correction)
      sequence.corrections.clear();
  }
  return result;
}

BandedQuantity combine(const QuantityOfInterest &quantity, std::size_t f, const std::vector<AxisResult> &axes)
{
  BandedQuantity banded = { quantity, quantity.rounding, quantity.value };
  double space = 0, order = 0;
  for (const AxisResult &result : axes)
  {
    const RefinementSequence &judged = result.quantities[f].judged;
    const double band = judged.bands[result.axis.own];
    const bool has_finer = result.axis.own + 1 < result.axis.levels.size();
    if (result.axis.role == AxisRole::space)
      space += band;
    else if (result.axis.role == AxisRole::azimuth)
      banded.band += band;
    else if (has_finer)
      order = band;
    if (result.axis.role != AxisRole::order && has_finer)
      banded.richardson += judged.limit - quantity.value;
  }
  banded.band += std::max(space, order);
  return banded;
}

} // namespace

RefinementSequence judge_refinement(const std::vector<double> &values, Decay decay, double rounding)
{
  if (values.empty())
    throw std::invalid_argument("A refinement study needs at least one value.");
  if (!std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); }))
    throw std::invalid_argument("A refinement study needs finite values.");
  RefinementSequence sequence;
  sequence.limit = values.back();
  if (decay == Decay::algebraic)
    judge_algebraic(values, rounding, sequence);
  else
    judge_spectral(values, sequence);
  sequence.uncertainty += rounding;
  for (const double value : values)
    sequence.bands.push_back(std::abs(value - values.back()) + sequence.uncertainty);
  return sequence;
}

std::optional<double> QuantitySequence::error(std::size_t l) const
{
  if (l + 2 >= values.size())
    return std::nullopt;
  return values[l + 2] + (corrections.empty() ? 0 : corrections[l + 2].value_or(0)) - values[l];
}

std::optional<double> QuantitySequence::effectivity(std::size_t l, double rounding) const
{
  const std::optional<double> against = error(l);
  if (!against || std::abs(*against) <= rounding || corrections.empty() || !corrections[l])
    return std::nullopt;
  return *corrections[l] / *against;
}

RefinementResult refine(const std::vector<QuantityOfInterest> &own, const std::vector<double> &spins,
                        const std::vector<RefinementAxis> &axes, const Executor &executor, Progress &progress)
{
  const double near = quantity_of(own, "omega_terminal").value;
  const auto quantities_at = [&](const OpenLevel &level, const std::shared_ptr<ElasticFoot> &foot)
  {
    // What is estimated is compared with two further levels; the finest are the most costly.
    const RefinementAxis &axis = axes[level.axis];
    const bool has_two_further = level.place + 2 < axis.levels.size();
    const bool is_estimated = axis.role == AxisRole::space && (axis.is_graded || has_two_further);
    return quantities_of_load(level.study, *find_load(level.study, foot), spins, near,
                              is_estimated ? foot.get() : nullptr);
  };
  std::vector<std::vector<Quantities>> quantities; // of every level of every axis
  std::vector<OpenLevel> open;
  for (std::size_t a = 0; a < axes.size(); ++a)
  {
    quantities.emplace_back(axes[a].levels.size(), own);
    for (std::size_t l = 0; l < axes[a].levels.size(); ++l)
      if (l != axes[a].own)
        open.push_back({ axes[a].levels[l], a, l });
  }
  const auto done =
    [&, tell = counted(progress, "levels", open.size())](std::size_t i, const auto &solved) mutable
  {
    require_solved(open[i], solved);
    quantities[open[i].axis][open[i].place] = *solved.answer;
    tell(i, solved);
  };
  solve(open, nullptr, quantities_at, executor, done);

  RefinementResult result;
  for (std::size_t a = 0; a < axes.size(); ++a)
    result.axes.push_back(judge(axes[a], quantities[a]));
  for (std::size_t f = 0; f < own.size(); ++f)
    result.quantities.push_back(combine(own[f], f, result.axes));
  return result;
}

std::vector<QuantityOfInterest> quantities_of_load(const Study &study, const BalancedLoad &load,
                                                   const std::vector<double> &spins,
                                                   const std::optional<double> &near, const ElasticFoot *foot)
{
  const ring::Motion &motion = study.motion.orbit;
  SpinQuestion question = { motion };
  question.expected = near.value_or(0);
  question.with_slope = true;
  question.with_minima = false;
  std::string reason;
  const std::vector<double> torques = friction_torques(load, motion, spins, reason);
  const SpinRow row = spin_row(load, question);
  if (!row.terminal)
    throw ring::NoBalance(row.reason + "; a study of refinement needs a terminal spin");
  constexpr double noise_of_differences = 10; // the slope is one by finite differences
  std::vector<QuantityOfInterest> quantities = quantities_of_interest(
    study, load.report(),
    { row.at_rest->friction.torque, spins, torques, row.terminal->omega, row.terminal->time_constant,
      load.report().rings.radius(), load.spin_scale(motion), noise_of_differences });
  if (!foot)
    return quantities;
  for (QuantityOfInterest &quantity : quantities)
    for (const Goal goal : { Goal::terminal_spin, Goal::a2 })
      if (quantity.key == key_of(goal))
        if (const auto found = goal_error(study, *foot, load, row.terminal->omega, goal))
          quantity.mesh_correction = found->error.correction;
  return quantities;
}

} // namespace stemware::pipeline
