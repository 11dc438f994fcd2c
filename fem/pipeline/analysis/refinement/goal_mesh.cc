#include "fem/pipeline/analysis/refinement/goal_mesh.h"

#include "fem/pipeline/analysis/refinement/goal_error.h"
#include "fem/pipeline/analysis/spin.h"
#include "fem/pipeline/coupling/study_load.h"
#include "fem/pipeline/support/failures.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace stemware::pipeline
{

namespace
{

/// Share of the error whose cells are halved at once.
constexpr double marked_share = 0.8;

GoalError error_of(const Study &study, const Executor &executor)
{
  const auto error = [&](const Variant &, const std::shared_ptr<ElasticFoot> &foot)
  {
    require(
      foot->body().capabilities().period_of_glass == 0,
      "Contact/Goal needs a foot whose load does not depend on where the moment points, which that of this "
      "Contact/Mesh file does; set Contact/Goal = none.");
    const SharedLoad load = find_load(study, foot);
    const double omega =
      terminal_spin(*load, study.motion.orbit, 0, false, study.motion.grip_torque).spin.omega;
    return goal_error(study, *foot, *load, omega, study.contact.goal, true);
  };
  const auto found = solve_alone(study, error, executor);
  if (!found)
    throw std::runtime_error(
      "The error of Contact/Goal cannot be estimated in this study: a rim or table is out of flat, or the "
      "contact of a solid foot with a hard table is narrower than two of its cells; set it to none, or take "
      "the foot as a body of revolution.");
  return *found;
}

double sum_of_shares(const fem::MeshError &error)
{
  const double foot = std::accumulate(error.foot_cells.begin(), error.foot_cells.end(), 0.);
  return std::accumulate(error.disc_cells.begin(), error.disc_cells.end(), foot);
}

/// A mesh for a goal has cells that no size of a study foresees. @p before: of the mesh without the last
/// cells that @p meshed halves.
void require_memory(const Study &meshed, const GoalError &before)
{
  if (abilities(meshed.contact.body).is_of_revolution)
    return;
  constexpr double per_unknown = 10e3; // bytes, most of them in the estimate; measured
  const double n_cells =
    static_cast<double>(before.error.foot_cells.size() + 7 * meshed.contact.halved.back().foot.size());
  const double memory = per_unknown * 4.5 * n_cells * std::pow(meshed.contact.degree, 3);
  if (memory > meshed.contact.memory_limit)
    throw std::runtime_error(
      fmt::format(FMT_STRING("The next mesh for the goal, the error being {:.1e} of its value, would have "
                             "{:.2g} cells and take about "
                             "{:.2g} GB of memory; give a larger Contact/Goal tolerance, or allow more with "
                             "Contact/Memory limit = {:.0f} GB."),
                  std::abs(before.error.correction / before.value), n_cells, memory / 1e9,
                  std::ceil(1.1 * memory / 1e9)));
}

} // namespace

MeshForGoal mesh_for_goal(const Study &study, const Executor &executor, Progress &progress)
{
  if (study.contact.goal == Goal::none || !study.load.is_from_contact())
    return { study, std::nullopt };
  constexpr unsigned int most_meshes = 20;
  constexpr double allowed_cancelling = 5;
  Study meshed = study;
  for (unsigned int n_meshes = 1;; ++n_meshes)
  {
    const GoalError found = error_of(meshed, executor);
    const double allowed = study.contact.goal_tolerance * std::abs(found.value);
    progress.pieces_done("meshes for the goal", n_meshes, 0);
    if (std::abs(found.error.correction) <= allowed &&
        sum_of_shares(found.error) <= allowed_cancelling * allowed)
    {
      const std::size_t n_cells = found.error.foot_cells.size() + found.error.disc_cells.size();
      progress.note("Mesh", fmt::format(FMT_STRING("{} cells, mesh {} for the goal; estimated error of the "
                                                   "goal {:.1e} of its value"),
                                        n_cells, n_meshes, std::abs(found.error.correction / found.value)));
      return { std::move(meshed), GoalOutcome{ found.value, found.error.correction, n_meshes, n_cells } };
    }
    if (n_meshes == most_meshes)
      throw std::runtime_error(fmt::format(
        FMT_STRING("The goal's error is still {:.1e} of its value after {} meshes, more than "
                   "Contact/Goal tolerance = {:g}; give a larger tolerance."),
        std::abs(found.error.correction / found.value), most_meshes, study.contact.goal_tolerance));
    meshed.contact.halved.push_back(found.error.mark(marked_share));
    require_memory(meshed, found);
  }
}

RefinementAxis goal_axis(const Study &study, const Executor &executor)
{
  RefinementAxis axis;
  axis.key = "goal_mesh";
  axis.name = "mesh for the goal";
  axis.size = "meshes for the goal";
  axis.is_graded = true;
  const std::size_t n_own = study.contact.halved.size();
  for (std::size_t n = n_own - std::min<std::size_t>(n_own, 2); n <= n_own; ++n)
  {
    axis.levels.push_back({ { axis.key, axis.name, study }, static_cast<unsigned int>(n + 1) });
    axis.levels.back().study.contact.halved.resize(n);
  }
  axis.own = axis.levels.size() - 1;
  for (unsigned int further = 0; further < 2; ++further)
  {
    RefinementLevel next = axis.levels.back();
    ++next.size;
    next.study.contact.halved.push_back(error_of(next.study, executor).error.mark(marked_share));
    axis.levels.push_back(std::move(next));
  }
  return axis;
}

} // namespace stemware::pipeline
