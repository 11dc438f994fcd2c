#include "fem/pipeline/analysis/refinement/refinement_study.h"

#include "fem/pipeline/analysis/solve_study.h"
#include "fem/pipeline/support/failures.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <stdexcept>
#include <thread>

namespace stemware::pipeline
{

namespace
{

/// A level that has to be solved, and where its figures go.
struct Task
{
  const RefinementAxis *axis;
  const RefinementLevel *level;
  std::vector<FollowedFigure> *figures;
};

/// Figures of every level of every axis; the study's own levels are known.
using LevelFigures = std::vector<std::vector<std::vector<FollowedFigure>>>;

std::vector<Task> open_tasks(const std::vector<RefinementAxis> &axes, const std::vector<FollowedFigure> &own,
                             LevelFigures &figures)
{
  std::vector<Task> tasks;
  figures.resize(axes.size());
  for (std::size_t a = 0; a < axes.size(); ++a)
    figures[a].resize(axes[a].levels.size(), own);
  for (std::size_t a = 0; a < axes.size(); ++a)
    for (std::size_t l = 0; l < axes[a].levels.size(); ++l)
      if (l != axes[a].own)
        tasks.push_back({ &axes[a], &axes[a].levels[l], &figures[a][l] });
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
    throw std::runtime_error(where + failure.what());
  }
  catch (const std::runtime_error &failure)
  {
    throw std::runtime_error(where + failure.what());
  }
}

/// Works off the tasks in order, @p n_threads at a time; the first failure ends it.
void solve(const std::vector<Task> &tasks, unsigned int n_threads,
           const std::function<void(const Task &)> &solve_one, const RefinementProgress &progress)
{
  std::atomic<std::size_t> next{ 0 };
  std::size_t n_done = 0;
  std::size_t failed = tasks.size();
  std::exception_ptr error;
  std::mutex mutex;
  const auto work = [&]
  {
    for (std::size_t i = next++; i < tasks.size(); i = next++)
      try
      {
        solve_one(tasks[i]);
        const std::lock_guard<std::mutex> lock(mutex);
        if (progress)
          progress(++n_done, tasks.size());
      }
      catch (...)
      {
        const std::lock_guard<std::mutex> lock(mutex);
        if (i < failed)
        {
          failed = i;
          error = std::current_exception();
        }
        next = tasks.size();
      }
  };
  std::vector<std::thread> threads;
  for (unsigned int t = 1; t < std::min<std::size_t>(n_threads, tasks.size()); ++t)
    threads.emplace_back(work);
  work();
  for (std::thread &thread : threads)
    thread.join();
  if (error)
    fail_at(tasks[failed], error);
}

AxisResult judge(const RefinementAxis &axis, const std::vector<std::vector<FollowedFigure>> &levels)
{
  AxisResult result = { axis, {} };
  for (std::size_t f = 0; f < levels[axis.own].size(); ++f)
  {
    FigureSequence sequence;
    double rounding = 0;
    for (const std::vector<FollowedFigure> &level : levels)
    {
      sequence.values.push_back(level[f].value);
      rounding = std::max(rounding, level[f].rounding);
    }
    sequence.judged = judge_refinement(sequence.values, axis.decay, rounding);
    result.figures.push_back(sequence);
  }
  return result;
}

BandedFigure combine(const FollowedFigure &figure, std::size_t f, const std::vector<AxisResult> &axes)
{
  BandedFigure banded = { figure, figure.rounding, figure.value };
  double space = 0;
  double order = 0;
  for (const AxisResult &result : axes)
  {
    const RefinementSequence &judged = result.figures[f].judged;
    const double band = judged.bands[result.axis.own];
    const bool has_finer = result.axis.own + 1 < result.axis.levels.size();
    if (result.axis.role == AxisRole::space)
      space += band;
    else if (result.axis.role == AxisRole::azimuth)
      banded.band += band;
    else if (has_finer)
      order = band;
    if (result.axis.role != AxisRole::order && has_finer)
      banded.richardson += judged.limit - figure.value;
  }
  banded.band += std::max(space, order);
  return banded;
}

} // namespace

const BandedFigure &RefinementResult::figure(const std::string &key) const
{
  const auto found = std::find_if(figures.begin(), figures.end(),
                                  [&](const BandedFigure &banded) { return banded.figure.key == key; });
  if (found == figures.end())
    throw std::out_of_range("no quantity of a refinement study is called " + key);
  return *found;
}

RefinementResult refine(const Study &study, const std::vector<FollowedFigure> &own,
                        const std::vector<double> &spins, const std::vector<RefinementAxis> &axes,
                        unsigned int n_threads, const RefinementProgress &progress)
{
  const double near = figure_of(own, "omega_terminal").value;
  fem::ComplianceStore store;
  const auto solve_one = [&](const Task &task)
  {
    const Study &refined = task.level->study;
    *task.figures = figures_of_load(refined, find_load(refined, store).load, spins, near);
  };
  LevelFigures figures;
  const std::vector<Task> tasks = open_tasks(axes, own, figures);
  solve(tasks, study.contact.body == BodyKind::revolution ? n_threads : 1, solve_one, progress);

  RefinementResult result;
  for (std::size_t a = 0; a < axes.size(); ++a)
    result.axes.push_back(judge(axes[a], figures[a]));
  for (std::size_t f = 0; f < own.size(); ++f)
    result.figures.push_back(combine(own[f], f, result.axes));
  return result;
}

std::vector<FollowedFigure> figures_of_load(const Study &study, const RingLoad &load,
                                            const std::vector<double> &spins,
                                            const std::optional<double> &near)
{
  FigureNoise noise;
  noise.n_azimuths = n_contact_azimuths(study);
  if (study.load.coupling == LoadCoupling::response)
    noise.relative = std::max(noise.relative, study.load.response_tolerance);
  return followed_figures(load, study.motion.orbit, spins, near, noise);
}

bool has_quick_error_bands(const Study &study)
{
  return study.load.source == LoadSource::contact && study.contact.body == BodyKind::revolution &&
         (study.table.kind == TableKind::mat || study.table.kind == TableKind::rough) &&
         !study.has_waviness();
}

RefinementResult estimate_error_bands(const Study &study, const RingLoad &load, double omega_terminal)
{
  const std::vector<double> spins = followed_spins(omega_terminal);
  const std::vector<FollowedFigure> own = figures_of_load(study, load, spins, omega_terminal);
  return refine(study, own, spins, quick_axes(study), std::max(1u, std::thread::hardware_concurrency()));
}

std::optional<double> terminal_spin_band(const Study &study, const RingLoad &load, double omega_terminal)
{
  if (!has_quick_error_bands(study))
    return std::nullopt;
  return estimate_error_bands(study, load, omega_terminal).figure("omega_terminal").band;
}

} // namespace stemware::pipeline
