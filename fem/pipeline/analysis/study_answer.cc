#include "fem/pipeline/analysis/study_answer.h"

#include "fem/pipeline/analysis/ring_quantities.h"
#include "fem/pipeline/coupling/study_load.h"
#include "ring_model/spin/answer.h"

#include <fmt/format.h>
#include <utility>

namespace stemware::pipeline
{

namespace
{

using Number = std::optional<double>;

std::string size_text(const fem::FootDescription &foot)
{
  const std::string cells = foot.n_cells ? fmt::format(FMT_STRING("{} cells, "), *foot.n_cells) : "";
  std::string text = fmt::format(FMT_STRING("{}, {}{} unknowns, {} contact nodes"), foot.body, cells,
                                 foot.n_unknowns, foot.n_contact_nodes);
  if (foot.mesh_report) // its radius may differ from Glass/Contact radius, to which moment ratios refer
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

/// Returns study_foot(); nullptr if the load has no contact. Reports the size of the foot.
std::shared_ptr<ElasticFoot> announced_foot(const FootSpecification &specification, const Executor &executor,
                                            const ElasticFoot *similar = nullptr)
{
  std::shared_ptr<ElasticFoot> foot;
  Progress &progress = executor.progress;
  executor.for_each(
    1, [&](std::size_t) { foot = study_foot(specification, executor.make_foot, progress, similar); },
    specification.study.is_collective());
  if (!foot)
    return foot;
  progress.note("Foot", size_text(foot->body().description()));
  progress.note("Friction", specification.study.friction_note());
  if (const std::string note = specification.study.frozen_note(); !note.empty())
    progress.note("Coupling", note);
  return foot;
}

/// Returns the terminal spin of a load that has only the first harmonic, on a ring of the contact radius.
Number omega_on_ring(const ring::Motion &motion, ring::Closure closure, double contact_radius)
{
  return ring::answer(first_harmonic_load(motion, closure, contact_radius), { motion }).omega_terminal();
}

} // namespace

const Fields<StudyAnswer> &study_quantities()
{
  using Found = StudyAnswer;
  using AtSpin = ring::TorqueEffect::AtSpin;
  const auto if_falls = [](auto read)
  {
    return [=](const Found &found)
    {
      const auto &fall = found.spin.answer().fall;
      return fall ? Number(read(*fall)) : std::nullopt;
    };
  };
  const auto torque_change = [](std::optional<AtSpin> ring::TorqueEffect::*spin, bool is_relative)
  {
    return [=](const Found &found)
    {
      const auto &[torque_at_rest, spins, rows] = found.spin.torque_effects;
      const auto &at_spin = rows.back().*spin;
      const double unit = is_relative ? torque_at_rest : 1;
      return at_spin && unit != 0 ? Number(at_spin->change / unit) : std::nullopt;
    };
  };
  static const auto fields = Fields<Found>{
    { "omega_first_harmonic", "rad/s", "",
      [](const Found &found) { return found.spin.rows.omega_first_harmonic(); },
      in_column("terminal spin, first harmonic only"), on_page("terminal spin, first harmonic only"),
      in_bands() },
    { "omega_on_ring", "rad/s", "",
      [](const Found &found)
      {
        const MotionSection &motion = found.study.motion;
        return omega_on_ring(motion.orbit, motion.closure, found.study.glass.profile.contact_radius);
      },
      in_column("terminal spin, first harmonic on a ring of the contact radius"),
      on_page("terminal spin, first harmonic on a ring of the contact radius") },
    { "omega_paper", "rad/s", "",
      [](const Found &found)
      {
        return omega_on_ring(found.study.motion.orbit, ring::Closure::paper,
                             found.study.glass.profile.contact_radius);
      },
      in_column("terminal spin, the paper's model") },
    { "harmonic_effect", "rad/s", "",
      [](const Found &found) { return harmonic_effect(found.spin.rows).absolute; },
      in_column("effect of the higher harmonics"), on_page("effect of the higher harmonics"), in_bands() },
    { "harmonic_effect_relative", "1", "",
      [](const Found &found) { return harmonic_effect(found.spin.rows).relative; },
      in_column("relative effect of the higher harmonics") },
    { "torque_change_half", "N m", "", torque_change(&ring::TorqueEffect::half, false),
      in_column("effect of the higher harmonics on the torque of friction at half the terminal spin") },
    { "torque_change_half_relative", "1", "", torque_change(&ring::TorqueEffect::half, true),
      in_column("the same over the torque at rest") },
    { "torque_change_terminal", "N m", "", torque_change(&ring::TorqueEffect::terminal, false),
      in_column("effect of the higher harmonics on the torque of friction at the terminal spin") },
    { "torque_change_terminal_relative", "1", "", torque_change(&ring::TorqueEffect::terminal, true),
      in_column("the same over the torque at rest") },
    { "torque_change_largest", "N m", "",
      [](const Found &found) { return found.spin.torque_effects.rows.back().largest; },
      in_column(
        "largest effect of the higher harmonics on the torque of friction, from rest to the terminal spin") },
    { "held", "1", "",
      [](const Found &found)
      {
        const auto &terminal = found.spin.answer().terminal;
        return found.study.motion.grip_torque > 0 && terminal ? Number(terminal->held ? 1 : 0) : std::nullopt;
      },
      in_column("1: the fingers hold the glass at rest") },
    { "omega_fall", "rad/s", "", if_falls([](const ring::RingState &fall) { return fall.omega; }),
      in_column("spin at which the glass tips"), on_page("spin at which the glass tips") },
    { "moment_ratio_at_fall", "1", "",
      if_falls([](const ring::RingState &fall) { return fall.moment_ratio; }),
      in_column("moment ratio at which the glass tips") },
    { "contact_iterations", "1", "",
      [](const Found &found)
      {
        const auto &foot = found.contact.foot;
        return foot ? std::optional(foot->at_rest.solution.n_iterations) : std::nullopt;
      },
      in_column("Newton steps of the contact at rest") }
  }.include(answer_fields(), [](const Found &found) -> const ring::Answer & { return found.spin.answer(); });
  return fields;
}

const Fields<StudyAnswer> &all_quantities()
{
  static const auto fields =
    Fields<StudyAnswer>{}
      .include(load_fields(),
               [](const StudyAnswer &found) -> const LoadReport & { return found.contact.load; })
      .include(study_quantities(), [](const StudyAnswer &found) -> const StudyAnswer & { return found; });
  return fields;
}

StudyAnswer answer_study(const Study &study, Depth depth, const Executor &executor, bool with_fields,
                         std::shared_ptr<ElasticFoot> *start)
{
  const GoalOutcome mesh = mesh_for_goal(study, executor);
  const std::shared_ptr<ElasticFoot> foot =
    announced_foot({ study, mesh.discretisation }, executor, start ? start->get() : nullptr);
  StudyAnswer answer = answer_study({ study, foot, executor }, depth, with_fields,
                                    mesh.n_meshes > 0 ? std::optional(mesh) : std::nullopt);
  if (start)
    *start = foot;
  return answer;
}

StudyAnswer answer_study(const Analysis &analysis, Depth depth, bool with_fields,
                         const std::optional<GoalOutcome> &goal)
{
  const auto &[study, foot, executor] = analysis;
  Progress &progress = executor.progress;
  const BalancedLoad load = find_load(study, foot, progress);
  SpinStudy spin = study_spin(analysis, load, depth);
  progress.stage_done("ring");
  ContactReport contact = describe(foot, load, spin.answer().last_spin().value());
  progress.stage_done("report_of_contact");

  FieldReport fields;
  ErrorBands bands;
  const std::shared_ptr<const ElasticFoot> of_fields = foot && with_fields ? foot->clone(study) : nullptr;
  const auto find = [&](std::size_t i)
  {
    if (i == 0 && of_fields && contact.foot)
      fields = find_fields(*of_fields, *contact.foot);
    if (i == 1)
      bands = estimate_bands(analysis, spin.answer(), spin.rows.omega_first_harmonic(),
                             reported_quantities(contact.load, spin.rows));
  };
  const bool is_full = depth == Depth::full;
  executor.for_each(is_full ? 2 : 1, find, study.is_collective());
  progress.stage_done("bands_and_fields");
  const SpinBands of_spins = { band_of(bands, "omega_terminal"), band_of(bands, "omega_first_harmonic") };
  std::optional<Budget> budget = is_full ? std::optional(find_budget(spin.rows, of_spins)) : std::nullopt;
  return {
    study, goal, std::move(contact), std::move(spin), std::move(bands), std::move(budget), std::move(fields)
  };
}

ErrorBands converge_study(const Study &study, std::vector<RefinementAxis> &axes, const Executor &executor)
{
  const std::shared_ptr<ElasticFoot> foot = announced_foot(study, executor);
  const std::vector<QuantityOfInterest> own = quantities_of_load(study, find_load(study, foot));
  executor.progress.stage_done("study");
  ErrorBands bands = refine(own, axes, executor);
  executor.progress.stage_done("levels");
  return bands;
}

} // namespace stemware::pipeline
