#include "fem/pipeline/output/console_report.h"

#include "fem/pipeline/output/answer.h"
#include "fem/pipeline/study/study.h"
#include "fem/pipeline/support/console.h"
#include "fem/pipeline/support/text_layout.h"

#include <boost/math/constants/constants.hpp>

#include <chrono>
#include <cmath>
#include <memory>
#include <ostream>

namespace stemware::pipeline
{

namespace
{

std::string truncation_text(const std::vector<TruncationRow> &rows)
{
  TextColumn harmonics = { "harmonics", {} }, torque = { "torque at rest\n(N m)", {} },
             spin = { "terminal spin\n(rad/s)", {} }, change = { "change\nof spin", {} },
             bound = { "bound on torque\n(N m)", {} }, least = { "least load\n(N/rad)", {} };
  for (const TruncationRow &row : rows)
  {
    harmonics.cells.push_back(std::to_string(row.harmonics));
    torque.cells.push_back(formatted("%.7g", row.tau_at_rest));
    spin.cells.push_back(formatted("%.8g", row.omega_terminal));
    change.cells.push_back(in_percent(row.relative_change));
    bound.cells.push_back(formatted("%.3e", row.bound));
    least.cells.push_back(formatted("%.4g", row.load_minimum));
  }
  return text_table({ harmonics, torque, spin, change, bound, least });
}

/// Table of contact steps that grows as they come; its header is printed before the first.
class ProgressTable
{
public:
  void add(const fem::ContactIteration &iteration)
  {
    if (!has_header)
      console() << "  step   loaded  changed   imbalance   share taken   CG iterations\n";
    has_header = true;
    console() << formatted("  %4u %8u %8u   %9.2e   %11.3g   %13u", iteration.number, iteration.n_loaded,
                           iteration.n_changed, iteration.residual, iteration.step_fraction,
                           iteration.linear_iterations)
              << std::endl;
  }

private:
  bool has_header = false;
};

/// A line every few seconds on how many spins contact and friction have been brought into balance at.
class BalanceProgress
{
public:
  void add(std::size_t n_states)
  {
    const auto now = std::chrono::steady_clock::now();
    if (now - last_line < std::chrono::seconds(3))
      return;
    last_line = now;
    console() << "  contact and friction in balance at " << n_states << " spins" << std::endl;
  }

private:
  std::chrono::steady_clock::time_point last_line = std::chrono::steady_clock::now();
};

/// Size of the finite-element system, and what is special about a mesh file.
void print_mesh(const FootContact &contact)
{
  console() << "Foot      " << contact.name() << ", ";
  if (contact.n_cells())
    console() << formatted("%u cells, ", *contact.n_cells());
  console() << formatted("%u unknowns, %u contact nodes", contact.n_unknowns(), contact.n_contact_nodes())
            << std::endl;
  if (contact.mesh_report() && !contact.mesh_report()->round_rim)
    console() << formatted("          straight edges: the land's area is %.2g %% too small",
                           100 * contact.mesh_report()->land_area_deficit)
              << std::endl;
}

/// One line: what it is about, in the left column, and what there is to say.
void print_note(const std::string &subject, const std::string &text)
{
  console() << formatted("%-9s ", subject.c_str()) << text << std::endl;
}

} // namespace

void print_load_source(const Study &study)
{
  if (study.load.source == LoadSource::file)
  {
    console() << "Load      " << study.load.file << std::endl;
    return;
  }
  const fem::ContactLoad demand = study.required_resultants();
  const double ratio = moment_ratio(demand, study.glass.profile.contact_radius);
  const double crest =
    std::atan2(demand.moment_x, -demand.moment_y) * 180 / boost::math::constants::pi<double>();
  const std::string origin =
    study.load.is_static() ? "given" : "closure " + ring::to_string(study.motion.closure) + " at rest";
  console() << formatted("Load      N = %.6g N, moment ratio %.6g (%s)", demand.normal_force, ratio,
                         origin.c_str());
  if (ratio > 0)
    console() << formatted(", largest at theta = %.4g deg", crest);
  console() << std::endl;
}

StudyObserver progress_on_console(Stopwatch &stopwatch)
{
  StudyObserver observer;
  observer.foot_made = print_mesh;
  observer.newton_step = [progress = std::make_shared<ProgressTable>()](
                           const fem::ContactIteration &iteration) { progress->add(iteration); };
  observer.balance_found = [progress = std::make_shared<BalanceProgress>()](std::size_t n_states)
  { progress->add(n_states); };
  observer.note = print_note;
  observer.stage_done = [&stopwatch](const std::string &stage) { stopwatch.finish(stage); };
  return observer;
}

void print_answer(const Study &study, const StudyResult &result)
{
  console() << '\n'
            << wrapped(answer(study, result) + " " + lift_off_remark(result.load) + " " +
                       narrow_contact_remark(study, result.contact) + " " +
                       waviness_remark(study, result.phases))
            << "\n\n"
            << truncation_text(result.yaw.truncations) << std::endl;
}

} // namespace stemware::pipeline
