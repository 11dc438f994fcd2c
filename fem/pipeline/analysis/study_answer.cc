#include "fem/pipeline/analysis/study_answer.h"

#include "fem/pipeline/coupling/study_load.h"
#include "ring_model/spin/curves.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <utility>

namespace stemware::pipeline
{

namespace
{

std::string size_text(const fem::FootDescription &foot)
{
  const std::string cells = foot.n_cells ? fmt::format(FMT_STRING("{} cells, "), *foot.n_cells) : "";
  std::string text = fmt::format(FMT_STRING("{}, {}{} unknowns, {} contact nodes"), foot.body, cells,
                                 foot.n_unknowns, foot.n_contact_nodes);
  if (foot.mesh_report) // moment ratios are over Glass/Contact radius
    text += foot.mesh_report->round_rim
              ? fmt::format(FMT_STRING("\n          the mesh's rim has a radius of {:.6g} m"),
                            foot.mesh_report->rim_radius)
              : fmt::format(
                  FMT_STRING("\n          the land is not round; its contact radius is {:.6g} m, the "
                             "mean of the\n          border's smallest and largest distance from the axis"),
                  foot.mesh_report->rim_radius);
  if (foot.mesh_report && foot.mesh_report->land_area_deficit > 0)
    text += fmt::format(FMT_STRING("\n          straight edges: the land's area is {:.2g} % too small"),
                        100 * foot.mesh_report->land_area_deficit);
  return text;
}

/// Returns study_foot(), nullptr if the load does not come from a contact; reports its size, and notes on
/// friction and coupling, to @p progress.
std::shared_ptr<ElasticFoot> announced_foot(const Study &study, const Executor &executor, Progress &progress,
                                            const Discretisation &discretisation = {},
                                            const ElasticFoot *similar = nullptr)
{
  std::shared_ptr<ElasticFoot> foot;
  executor.for_each(
    1, [&](std::size_t) { foot = study_foot(study, executor.make_foot, progress, similar, discretisation); },
    is_collective(study));
  if (!foot)
    return foot;
  progress.note("Foot", size_text(foot->body().description()));
  if (const std::string note = friction_note(study); !note.empty())
    progress.note("Friction", note);
  if (const std::string note = frozen_note(study); !note.empty())
    progress.note("Coupling", note);
  return foot;
}

} // namespace

StudyAnswer answer_study(const Study &study, Depth depth, const Executor &executor, Progress &progress,
                         bool with_fields, std::shared_ptr<ElasticFoot> *start)
{
  // 1. The load on the table, and the spin.
  const MeshForGoal mesh = mesh_for_goal(study, executor, progress);
  const std::shared_ptr<ElasticFoot> foot =
    announced_foot(study, executor, progress, mesh.discretisation, start ? start->get() : nullptr);
  const BalancedLoad load = find_load(study, foot, progress);
  StudyAnswer answer = { mesh.outcome };
  answer.spin = study_spin(study, foot, load, executor, progress, depth);
  progress.stage_done("ring");
  answer.contact = describe(study, foot, load, answer.spin.all().last_spin().value());
  progress.stage_done("report_of_contact");

  // 2. Fields and, in parallel, error bands.
  const std::shared_ptr<const ElasticFoot> of_fields = foot && with_fields ? foot->clone() : nullptr;
  const auto find = [&](std::size_t i)
  {
    if (i == 0 && of_fields && answer.contact.foot)
      add_fields(study, *of_fields, *answer.contact.foot);
    if (i == 1)
      answer.bands =
        estimate_bands(study, foot, answer.spin.all(), answer.spin.rows.front().omega_terminal(), executor,
                       progress, reported_quantities(answer.contact.load, answer.spin.budget));
  };
  executor.for_each(depth == Depth::full ? 2 : 1, find, is_collective(study));
  if (depth == Depth::full)
    add_bands(band_of(answer.bands, "omega_terminal"), band_of(answer.bands, "omega_first_harmonic"),
              answer.spin.budget.rows);
  progress.stage_done("bands_and_fields");
  if (start)
    *start = foot;
  return answer;
}

TruncatedStudy truncate_study(const Study &study, const Executor &executor, Progress &progress)
{
  const MeshForGoal mesh = mesh_for_goal(study, executor, progress);
  const std::shared_ptr<ElasticFoot> foot = announced_foot(study, executor, progress, mesh.discretisation);
  const BalancedLoad load = find_load(study, foot, progress);
  const ring::Question question = spin_question(study);
  TruncatedStudy truncated;
  for (const LoadedRow &answer :
       rows_by_harmonics(study, foot, load, question, executor, progress, Depth::rows).by_harmonics)
    truncated.rows.push_back(answer.row);
  const double last = truncated.rows.back().last_spin().value_or(0);
  const ring::Load curve =
    ring::interpolated_for_curves(load, truncated.rows.back(), std::min(last, 0.), std::max(last, 0.));
  truncated.torque_effects = ring::torque_effects(load, study.motion.orbit, truncated.rows.back(),
                                                  truncation_orders(load.n_harmonics()), &curve);
  truncated.load = load.report();
  progress.stage_done("truncations");
  return truncated;
}

ErrorBands converge_study(const Study &study, std::vector<RefinementAxis> &axes, const Executor &executor,
                          Progress &progress)
{
  const std::shared_ptr<ElasticFoot> foot = announced_foot(study, executor, progress);
  const BalancedLoad load = find_load(study, foot);
  const std::vector<QuantityOfInterest> own = quantities_of_load(study, load);
  progress.stage_done("study");
  ErrorBands bands = refine(own, axes, executor, progress);
  progress.stage_done("levels");
  return bands;
}

} // namespace stemware::pipeline
