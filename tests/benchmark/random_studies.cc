// Does every study end, and how? Random studies over all tables, moment balances, shapes and wavinesses:
// foot, load in balance and terminal spin of each. Build: cmake --preset bench && cmake --build --preset
// bench, run:
//   build/bench/random_studies N SEED [--list] [--only I | --flat | --wavy]   studies 1 ... N of that seed,
//   or a part of them build/bench/random_studies --file STUDY.prm ...          those studies
// Ends with 0 when at least 99.5 % of the studies that do not tip converge, all within 20 s, and at most 5 %
// tip.

#include "fem/pipeline/coupling/balanced_contact.h"
#include "fem/pipeline/coupling/study_load.h"
#include "fem/pipeline/feet/make_foot.h"
#include "fem/pipeline/input/study_file.h"
#include "fem/pipeline/system/ranks.h"
#include "ring_model/spin/answer.h"
#include "tests/benchmark/leaning_rigid_ring.h"
#include "tests/benchmark/random_study.h"

#include <deal.II/base/multithread_info.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <map>
#include <string>
#include <vector>

namespace
{

using namespace stemware;
using namespace stemware::pipeline;

constexpr double slow = 5, too_slow = 20, given_up = 60; // s

/// Processor time of one thread since its making: what others do on the machine does not count.
class Clock
{
public:
  double seconds() const { return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC; }

private:
  const std::clock_t start = std::clock();
};

/// Stops a study that takes for ever, at the next spin in balance.
class Deadline : public Progress
{
public:
  void pieces_done(const std::string &, std::size_t, std::size_t) override
  {
    if (clock.seconds() > given_up)
      throw std::logic_error("not done after " + std::to_string(static_cast<int>(given_up)) + " s");
  }
  const Clock clock;
};

/// How a study has ended.
struct Ending
{
  std::string name; ///< "converged", "tips", "no terminal spin", a contact outcome, "other"
  std::string message;
  double seconds = 0;
  double seconds_of_foot = 0; ///< meshes and compliances
  double omega = 0;           ///< terminal spin [rad/s]
  double uncertainty = 0;     ///< of a mean over phases [rad/s]
  std::size_t n_contacts = 0; ///< solved
  bool is_confirmed = false;  ///< tipping that a check without the contact solver or a fold shows
};

void find_spin(const Study &study, Ending &ending)
{
  fem::ComplianceCache cache;
  Deadline deadline;
  study.required_resultants();
  const auto foot = study_foot(study, cache);
  ending.seconds_of_foot = deadline.clock.seconds();
  const SharedLoad load = find_load(study, foot, deadline);
  ring::Question question = { study.motion.orbit, study.motion.grip_torque };
  question.with_minima = false;
  const ring::Answer found = ring::answer(*load, question).value();
  ending.omega = found.omega_terminal().value();
  ending.uncertainty = found.spin_uncertainty;
  ending.n_contacts = foot ? foot->n_contacts() : 0;
}

Ending attempt(const Study &study)
{
  Ending ending;
  const Clock clock;
  try
  {
    find_spin(study, ending);
    ending.name = "converged";
  }
  catch (const fem::ContactFailure &failure)
  {
    ending.name = failure.outcome == fem::ContactOutcome::tipping ? "tips" : to_string(failure.outcome);
    ending.message = failure.what();
  }
  catch (const ring::Tipping &failure)
  {
    ending.name = "tips";
    ending.message = failure.what();
  }
  catch (const ring::NoTerminalSpin &failure)
  {
    ending.name = "no terminal spin";
    ending.message = failure.what();
  }
  catch (const BadInput &failure) // the moment of rest is more than the foot can carry
  {
    ending.name =
      moment_ratio({ study.motion.orbit.normal_force(),
                     ring::required_moment_at_rest(study.motion.closure, study.motion.orbit).x(),
                     ring::required_moment_at_rest(study.motion.closure, study.motion.orbit).y() },
                   study.glass.profile.contact_radius) >= 2
        ? "tips"
        : "refused";
    ending.message = failure.what();
  }
  catch (const std::exception &failure)
  {
    ending.name = "other";
    ending.message = failure.what();
  }
  ending.seconds = clock.seconds();
  return ending;
}

/// What a rigid rim meets; bodies that yield besides let it lean more, and tip sooner.
LineLaw line_law(const Study &study)
{
  const fem::GlassProfile &profile = study.glass.profile;
  const bool flat = profile.crown_radius == 0;
  const TableSection &table = study.table;
  LineLaw law;
  law.exponent = flat ? 1 : 1.5;
  if (table.interface == TableInterface::winkler)
    law.stiffness =
      table.foundation_modulus * (flat ? profile.land_width : 4. / 3 * std::sqrt(2 * profile.crown_radius));
  if (table.interface == TableInterface::rough)
    law.decay_length = table.roughness.decay_length;
  return law;
}

/// The path to a study from a slow orbit, at one slip ratio: how far it goes.
struct Path
{
  double reached = 0;        ///< largest v^2 over that of the study
  double moment_ratio = 0;   ///< there
  double last_steepness = 0; ///< change of m with v^2 at the end of the path, over that of its first half
};

/// Follows the contact in balance in v, omega R / v being @p slip; v^2 is bisected where a step fails.
Path follow_in_speed(const Study &study, double slip)
{
  fem::ComplianceCache cache;
  const double radius = study.glass.profile.contact_radius;
  std::map<double, double> ratios; // m by the share of v^2
  const auto solve = [&](double share)
  {
    Study slower = study;
    ring::Motion &motion = slower.motion.orbit;
    motion.orbit_speed *= std::sqrt(share);
    const auto foot = study_foot(slower, cache);
    find_load(slower, foot);
    BalancedContact contact(foot, moment_balance(slower));
    const fem::ContactLoad load = contact.contact(slip * motion.orbit_speed / radius).load;
    ratios[share] = load.moment_ratio(radius);
  };
  double reached = 0, step = 0.125;
  while (step > 1e-4 && reached < 1)
    try
    {
      solve(std::min(1., reached + step));
      reached = std::min(1., reached + step);
    }
    catch (const std::exception &)
    {
      step /= 2;
    }
  Path path;
  path.reached = reached;
  if (ratios.size() < 4)
    return path;
  const auto last = std::prev(ratios.end()), before = std::prev(last);
  const auto middle = ratios.lower_bound(reached / 2), first = ratios.begin();
  path.moment_ratio = last->second;
  if (middle != first && middle != last)
    path.last_steepness = (last->second - before->second) / (last->first - before->first) /
                          ((middle->second - first->second) / (middle->first - first->first));
  return path;
}

/// Whether @p study tips for another reason than that the contact solver says so; puts it in @p ending.
void confirm_tipping(const Study &study, Ending &ending)
{
  const ring::Motion &motion = study.motion.orbit;
  const Eigen::Vector2d at_rest = ring::required_moment_at_rest(study.motion.closure, motion);
  const double radius = study.glass.profile.contact_radius;
  const double reach =
    study.glass.profile.crown_radius > 0 ? radius : study.glass.profile.land_outer_radius();
  char text[200] = "";
  ending.is_confirmed = true;
  if (at_rest.norm() >= motion.normal_force() * reach)
  {
    ending.message = "by the moment of rest";
    return;
  }
  const LeaningRigidRing rigid(line_law(study), reach, study.motion.closure, motion, study.tilts());
  if (const auto slip = rigid.tips_at())
  {
    std::snprintf(text, sizeof text, "a rigid ring tips at omega R / v = %.3f, too", *slip);
    ending.message = text;
    return;
  }
  // The sense of the spin-up is that of the moment of rest.
  const double sense = at_rest.x() > 0 ? 1 : -1;
  Path path;
  for (double slip = 0; slip <= 1.5 && path.reached < 1; slip += 0.25)
  {
    path = follow_in_speed(study, sense * slip);
    if (path.reached == 1)
      continue;
    std::snprintf(text, sizeof text,
                  "omega R / v = %.2f: path in v ends at %.4f v, m = %.4f, %.1f times as steep as at first",
                  sense * slip, std::sqrt(path.reached), path.moment_ratio, path.last_steepness);
    ending.message = text;
    ending.is_confirmed = path.moment_ratio > 1.97 || path.last_steepness > 4;
    return;
  }
  ending.is_confirmed = false;
  ending.message += " (the path in v goes on to the study's)";
}

/// All studies of one kind of table.
struct Tally
{
  unsigned int n = 0, n_converged = 0, n_tips = 0, n_unconfirmed = 0, n_failed = 0, n_slow = 0,
               n_too_slow = 0;
  std::vector<double> seconds;

  void add(const Ending &ending)
  {
    ++n;
    seconds.push_back(ending.seconds);
    n_slow += ending.seconds > slow;
    n_too_slow += ending.seconds > too_slow;
    if (ending.name == "converged")
      ++n_converged;
    else if (ending.name == "tips")
      ++(ending.is_confirmed ? n_tips : n_unconfirmed);
    else
      ++n_failed;
  }

  void print(const std::string &name)
  {
    std::sort(seconds.begin(), seconds.end());
    std::printf("%-18s %5u %10u %6u %10u %7u %5u %6u %8.2f %8.2f\n", name.c_str(), n, n_converged, n_tips,
                n_unconfirmed, n_failed, n_slow, n_too_slow, seconds[seconds.size() / 2], seconds.back());
  }
};

class Campaign
{
public:
  explicit Campaign(bool lists_all)
      : lists_all(lists_all)
  {
  }

  void answer(const std::string &name, const Study &study)
  {
    Ending ending = attempt(study);
    if (ending.name == "tips")
      confirm_tipping(study, ending);
    by_table[table_name(study.table)].add(ending);
    all.add(ending);
    if (!lists_all && ending.name == "converged" && ending.seconds <= slow)
      return;
    std::printf("%s: %s, crown %.2g mm, %s, friction %s, %u rings%s: %s, %.2f s (foot %.2f s), %zu contacts, "
                "%.9g +- %.1e rad/s",
                name.c_str(), table_name(study.table).c_str(), 1000 * study.glass.profile.crown_radius,
                balance_name(study).c_str(), study.friction_deforms() ? "elastic" : "none",
                study.contact.rings, study.has_waviness() ? ", wavy" : "", ending.name.c_str(),
                ending.seconds, ending.seconds_of_foot, ending.n_contacts, ending.omega, ending.uncertainty);
    std::printf("%s%s\n", ending.message.empty() ? "" : "\n    ", ending.message.c_str());
    std::fflush(stdout);
  }

  /// Prints the table; returns whether all is as it should be.
  bool end()
  {
    std::printf("%-18s %5s %10s %6s %10s %7s %5s %6s %8s %8s\n", "table", "n", "converged", "tips",
                "tips, open", "failed", "> 5 s", "> 20 s", "median s", "worst s");
    for (auto &[name, tally] : by_table)
      tally.print(name);
    all.print("all");
    return all.n_converged >= 0.995 * (all.n - all.n_tips) && all.n_too_slow == 0 &&
           all.n_tips <= 0.05 * all.n;
  }

private:
  const bool lists_all;
  std::map<std::string, Tally> by_table;
  Tally all;
};

int help()
{
  std::printf(
    "random_studies N SEED [--list] [--only I | --flat | --wavy]\nrandom_studies --file STUDY.prm ...\n");
  return 2;
}

} // namespace

int main(int argc, char *argv[])
{
  const MpiSession mpi;
  dealii::MultithreadInfo::set_thread_limit(1);
  if (argc < 3)
    return help();
  if (std::strcmp(argv[1], "--file") == 0)
  {
    Campaign campaign(true);
    for (int i = 2; i < argc; ++i)
      campaign.answer(argv[i], read_study(argv[i]));
    return campaign.end() ? 0 : 1;
  }
  const int n_studies = std::atoi(argv[1]);
  const auto seed = static_cast<unsigned int>(std::atoi(argv[2]));
  bool lists_all = false;
  bool with_flat = true, with_wavy = true;
  int only = 0;
  for (int i = 3; i < argc; ++i)
    if (std::strcmp(argv[i], "--list") == 0)
      lists_all = true;
    else if (std::strcmp(argv[i], "--flat") == 0)
      with_wavy = false;
    else if (std::strcmp(argv[i], "--wavy") == 0)
      with_flat = false;
    else if (std::strcmp(argv[i], "--only") == 0 && i + 1 < argc)
      only = std::atoi(argv[++i]);
    else
      return help();
  RandomStudies studies(seed);
  Campaign campaign(lists_all || only > 0);
  for (int i = 1; i <= n_studies; ++i)
  {
    const Study study = studies.next();
    if (only > 0 ? only == i : study.has_waviness() ? with_wavy : with_flat)
      campaign.answer(std::to_string(seed) + "/" + std::to_string(i), study);
  }
  return campaign.end() ? 0 : 1;
}
