#include "fem/pipeline/analysis/refinement/refinement_study.h"

#include "fem/pipeline/analysis/refinement/goal_error.h"
#include "fem/pipeline/coupling/study_load.h"
#include "fem/pipeline/support/failures.h"
#include "fem/pipeline/support/parallel.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <functional>
#include <mutex>
#include <stdexcept>
#include <thread>

namespace stemware::pipeline
{

namespace
{

/// A level that has to be solved, and where its quantities go.
struct Task
{
  const RefinementAxis *axis;
  const RefinementLevel *level;
  std::vector<QuantityOfInterest> *quantities;
};

/// Quantities of every level of every axis; the study's own levels are known.
using LevelQuantities = std::vector<std::vector<std::vector<QuantityOfInterest>>>;

std::vector<Task> open_tasks(const std::vector<RefinementAxis> &axes,
                             const std::vector<QuantityOfInterest> &own, LevelQuantities &quantities)
{
  std::vector<Task> tasks;
  quantities.resize(axes.size());
  for (std::size_t a = 0; a < axes.size(); ++a)
    quantities[a].resize(axes[a].levels.size(), own);
  for (std::size_t a = 0; a < axes.size(); ++a)
    for (std::size_t l = 0; l < axes[a].levels.size(); ++l)
      if (l != axes[a].own)
        tasks.push_back({ &axes[a], &axes[a].levels[l], &quantities[a][l] });
  // The finest first: the longest work should not be begun last.
  std::stable_sort(tasks.begin(), tasks.end(),
                   [](const Task &one, const Task &other) { return one.axis->role < other.axis->role; });
  return tasks;
}

[[noreturn]] void fail_at(const Task &task, const std::exception_ptr &error)
{
  const std::string where =
    "Level " + std::to_string(task.level->size) + " of the refinement in " + task.axis->name + ": ";
  try
  {
    std::rethrow_exception(error);
  }
  catch (const BadInput &failure)
  {
    throw BadInput(where + failure.what());
  }
  catch (const fem::ContactFailure &failure)
  {
    throw ring::NoBalance(where + failure.what());
  }
  catch (const ring::NoBalance &failure)
  {
    throw ring::NoBalance(where + failure.what());
  }
}

/// Solves all tasks, @p n_threads at a time; throws what one that failed has thrown.
void solve(const std::vector<Task> &tasks, unsigned int n_threads,
           const std::function<void(const Task &)> &solve_one, Progress &progress)
{
  std::mutex mutex;
  std::size_t n_done = 0;
  parallel_for_each(tasks.size(), n_threads,
                    [&](std::size_t i)
                    {
                      try
                      {
                        solve_one(tasks[i]);
                      }
                      catch (...)
                      {
                        fail_at(tasks[i], std::current_exception());
                      }
                      const std::lock_guard<std::mutex> lock(mutex);
                      progress.pieces_done("levels", ++n_done, tasks.size());
                    });
}

AxisResult judge(const RefinementAxis &axis, const std::vector<std::vector<QuantityOfInterest>> &levels)
{
  AxisResult result = { axis, {} };
  for (std::size_t f = 0; f < levels[axis.own].size(); ++f)
  {
    QuantitySequence sequence;
    double rounding = 0;
    for (const std::vector<QuantityOfInterest> &level : levels)
    {
      sequence.values.push_back(level[f].value);
      rounding = std::max(rounding, level[f].rounding);
    }
    sequence.judged = judge_refinement(sequence.values, axis.decay, rounding);
    bool has_correction = false;
    for (const std::vector<QuantityOfInterest> &level : levels)
    {
      sequence.corrections.push_back(level[f].mesh_correction);
      has_correction |= level[f].mesh_correction.has_value();
    }
    if (axis.role != AxisRole::space || !has_correction)
      sequence.corrections.clear();
    result.quantities.push_back(sequence);
  }
  return result;
}

BandedQuantity combine(const QuantityOfInterest &quantity, std::size_t f, const std::vector<AxisResult> &axes)
{
  BandedQuantity banded = { quantity, quantity.rounding, quantity.value };
  double space = 0;
  double order = 0;
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

const BandedQuantity &RefinementResult::quantity(const std::string &key) const
{
  return quantities[index_of(quantities, key)];
}

RefinementResult refine(const Study &study, const std::vector<QuantityOfInterest> &own,
                        const std::vector<double> &spins, const std::vector<RefinementAxis> &axes,
                        fem::ComplianceCache &cache, Progress &progress)
{
  const double near = quantity_of(own, "omega_terminal").value;
  const auto solve_one = [&](const Task &task)
  {
    const Study &refined = task.level->study;
    const std::shared_ptr<ElasticFoot> foot = study_foot(refined, cache);
    const SharedLoad load = find_load(refined, foot);
    // What is estimated is compared with two further levels; the finest are the most costly.
    const std::size_t n_further = task.axis->levels.size() - 1 - (task.level - task.axis->levels.data());
    const bool is_of_mesh = task.axis->role == AxisRole::space && (task.axis->is_graded || n_further >= 2);
    *task.quantities = quantities_of_load(refined, *load, spins, near, is_of_mesh ? foot.get() : nullptr);
  };
  LevelQuantities quantities;
  const std::vector<Task> tasks = open_tasks(axes, own, quantities);
  const bool one_by_one = abilities(study.contact.body).is_collective;
  solve(tasks, one_by_one ? 1 : std::max(1u, std::thread::hardware_concurrency()), solve_one, progress);

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
  QuantityNoise noise;
  noise.n_azimuths = n_contact_azimuths(study);
  std::vector<QuantityOfInterest> quantities =
    quantities_of_interest(load, study.motion.orbit, spins, near, noise);
  if (!foot)
    return quantities;
  const double omega = quantity_of(quantities, "omega_terminal").value;
  for (QuantityOfInterest &quantity : quantities)
    for (const Goal goal : { Goal::terminal_spin, Goal::a2 })
      if (quantity.key == key_of(goal))
        if (const auto found = goal_error(study, *foot, load, omega, goal))
          quantity.mesh_correction = found->error.correction;
  return quantities;
}

} // namespace stemware::pipeline
