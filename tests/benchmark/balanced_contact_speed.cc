// What a contact in balance costs on one core, beyond starting the program and the compliances: the load of
// a spin from that of its neighbour, and the terminal spin from nothing. Default study, friction deforms.
// Build: cmake --preset bench && cmake --build --preset bench, run: OPENBLAS_NUM_THREADS=1
// build/bench/balanced_contact_speed

#include "fem/pipeline/analysis/spin.h"
#include "fem/pipeline/coupling/balanced_contact.h"
#include "fem/pipeline/coupling/study_load.h"
#include "fem/pipeline/support/ranks.h"

#include <deal.II/base/multithread_info.h>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <string>
#include <vector>

namespace
{

using namespace stemware;
using namespace stemware::pipeline;

struct Case
{
  std::string name;
  Study study;
  double load_limit, spin_limit; ///< what is allowed [ms]
};

std::vector<Case> cases()
{
  constexpr double on_mat[] = { 2, 15 }, on_hard[] = { 30, 300 };
  Study mat;
  Study rigid = mat;
  rigid.table.interface = TableInterface::hard;
  Study hardwood = rigid;
  hardwood.table.substrate = TableSubstrate::elastic;
  hardwood.table.disc_material = { 10e9, 0.3 };
  Study glass = hardwood;
  glass.table.disc_material = { 70e9, 0.22 };
  Study rough = mat;
  rough.table.interface = TableInterface::rough;
  Study rough_hardwood = hardwood;
  rough_hardwood.table.interface = TableInterface::rough;
  return { { "Winkler 1e10, rigid", mat, on_mat[0], on_mat[1] },
           { "rough, rigid", rough, on_mat[0], on_mat[1] },
           { "hard, hardwood", hardwood, on_hard[0], on_hard[1] },
           { "hard, glass disc", glass, on_hard[0], on_hard[1] },
           { "hard, rigid", rigid, on_hard[0], on_hard[1] },
           { "rough, hardwood", rough_hardwood, on_hard[0], on_hard[1] } };
}

/// Processor time of one thread: what others do on the machine does not count.
double milliseconds_since(std::clock_t start)
{
  return 1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

double median(std::vector<double> values)
{
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2),
                   values.end());
  return values[values.size() / 2];
}

/// Prints one row; returns whether both times are allowed.
bool measure(const Case &one)
{
  constexpr unsigned int n_neighbours = 21, n_repetitions = 5;
  const Study &study = one.study;
  const ring::Motion &motion = study.motion.orbit;
  fem::ComplianceCache cache;
  double omega = 0;
  std::vector<double> times_of_spin;
  std::size_t n_contacts = 0;
  fem::FootDescription foot_of_study;
  for (unsigned int i = 0; i < n_repetitions; ++i)
  {
    const auto foot = study_foot(study, cache); // compliances and mesh are not part of what is timed
    foot_of_study = foot->body().description();
    const auto start = std::clock();
    const SharedLoad load = find_load(study, foot);
    omega = terminal_spin(*load, motion, 0, false, study.motion.grip_torque).spin.omega;
    times_of_spin.push_back(milliseconds_since(start));
    n_contacts = load->statistics() ? load->statistics()->n_contact_solutions : 1;
  }

  const auto foot = study_foot(study, cache);
  find_load(study, foot); // chooses the rings
  BalancedContact contact(foot, moment_balance(study));
  const double step = 1e-3 * motion.orbit_speed / study.glass.profile.contact_radius;
  std::vector<double> times_of_load, steps_of_load;
  contact.contact(omega / 2);
  for (unsigned int i = 1; i <= n_neighbours; ++i)
  {
    const auto start = std::clock();
    const fem::ContactState state = contact.contact(omega / 2 + i * step);
    times_of_load.push_back(milliseconds_since(start));
    steps_of_load.push_back(state.solution.n_iterations);
  }
  const double load = median(times_of_load), spin = median(times_of_spin);
  const bool is_fast = load <= one.load_limit && spin <= one.spin_limit;
  std::printf("%-20s %6u %6u %6.0f %9.2f %9.0f %9.1f %9.0f %9zu  %.9g%s\n", one.name.c_str(),
              foot_of_study.n_contact_nodes / study.contact.azimuth_lines, study.contact.azimuth_lines,
              median(steps_of_load), load, one.load_limit, spin, one.spin_limit, n_contacts, omega,
              is_fast ? "" : "  TOO SLOW");
  std::fflush(stdout);
  return is_fast;
}

} // namespace

int main()
{
  const MpiSession mpi;
  dealii::MultithreadInfo::set_thread_limit(1);
  std::printf("%-20s %6s %6s %6s %9s %9s %9s %9s %9s  %s\n", "table", "nodes", "lines", "steps", "load, ms",
              "allowed", "spin, ms", "allowed", "contacts", "terminal spin, rad/s");
  bool all_are_fast = true;
  for (const Case &one : cases())
    all_are_fast = measure(one) && all_are_fast;
  return all_are_fast ? 0 : 1;
}
