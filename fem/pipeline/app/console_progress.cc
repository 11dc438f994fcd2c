#include "fem/pipeline/app/console_progress.h"

#include "fem/contact/contact_newton.h"
#include "fem/pipeline/coupling/study_load.h"
#include "fem/pipeline/study/study_size.h"

#include <boost/math/constants/constants.hpp>

#include <cmath>
#include <fmt/format.h>
#include <ostream>

namespace stemware::pipeline
{

namespace
{

std::string size_of(const fem::FootDescription &foot)
{
  const std::string cells = foot.n_cells ? fmt::format(FMT_STRING("{} cells, "), *foot.n_cells) : "";
  std::string text = fmt::format(FMT_STRING("{}, {}{} unknowns, {} contact nodes"), foot.body, cells,
                                 foot.n_unknowns, foot.n_contact_nodes);
  if (foot.mesh_report) // moment ratios are over Glass/Contact radius
    text += fmt::format(FMT_STRING("\n          the mesh's rim has a radius of {:.6g} m"),
                        foot.mesh_report->rim_radius);
  if (foot.mesh_report && foot.mesh_report->land_area_deficit > 0)
    text += fmt::format(FMT_STRING("\n          straight edges: the land's area is {:.2g} % too small"),
                        100 * foot.mesh_report->land_area_deficit);
  return text;
}

} // namespace

ConsoleProgress::ConsoleProgress(Stopwatch &stopwatch)
    : stopwatch(stopwatch)
{
}

void ConsoleProgress::stage_done(const std::string &stage)
{
  stopwatch.finish(stage);
}

void ConsoleProgress::pieces_done(const std::string &what, std::size_t n_done, std::size_t n_all)
{
  if (n_all > 0)
  {
    if (!bar)
      bar.emplace(n_all, 0, what);
    bar->show(n_done);
    if (n_done == n_all)
      bar.reset();
    return;
  }
  const auto now = std::chrono::steady_clock::now();
  if (bar || now - last_line < std::chrono::seconds(3))
    return; // the bar shows how far it is
  last_line = now;
  console() << fmt::format(FMT_STRING("  {} {}"), n_done, what) << std::endl;
}

void ConsoleProgress::iteration(const fem::ContactIteration &step)
{
  if (!has_header)
    console() << "  step   active  changed    residual   step length   CG iterations\n";
  has_header = true;
  console() << fmt::format(FMT_STRING("  {:4} {:8} {:8}   {:9.2e}   {:11.3g}   {:13}"), step.number,
                           step.n_loaded, step.n_changed, step.residual, step.step_length,
                           step.linear_iterations)
            << std::endl;
}

void ConsoleProgress::note(const std::string &subject, const std::string &text)
{
  console() << fmt::format(FMT_STRING("{:<9} {}"), subject, text) << std::endl;
}

void note_load_source(const Study &study, Progress &progress)
{
  if (study.load.source == LoadSource::file)
  {
    progress.note("Load", study.load.file);
    return;
  }
  const fem::Resultants demand = study.required_resultants();
  const double ratio = moment_ratio(demand, study.glass.profile.contact_radius);
  const double crest = std::atan2(demand.moment_x, -demand.moment_y) / boost::math::double_constants::degree;
  const std::string origin =
    study.load.is_static() ? "given" : "closure " + ring::to_string(study.motion.closure) + " at rest";
  std::string text =
    fmt::format(FMT_STRING("N = {:.6g} N, moment ratio {:.6g} ({})"), demand.normal_force, ratio, origin);
  if (ratio > 0)
    text += fmt::format(FMT_STRING(", largest at theta = {:.4g} deg"), crest);
  progress.note("Load", text);
}

std::shared_ptr<ElasticFoot> announced_foot(const Study &study, const Executor &executor, Progress &progress)
{
  constexpr double worth_saying = 1e9;
  if (const StudySize size = size_of(study); size.memory > worth_saying)
    progress.note("Memory",
                  fmt::format(FMT_STRING("about {:.2g} GB for {:.0f} cells"), size.memory / 1e9, size.cells));
  std::shared_ptr<ElasticFoot> foot;
  executor.for_each(
    1, [&](std::size_t) { foot = study_foot(study, executor.make_foot, progress); }, is_collective(study));
  if (!foot)
    return foot;
  progress.note("Foot", size_of(foot->body().description()));
  if (const std::string note = friction_note(study); !note.empty())
    progress.note("Friction", note);
  if (const std::string note = frozen_note(study); !note.empty())
    progress.note("Coupling", note);
  return foot;
}

} // namespace stemware::pipeline
