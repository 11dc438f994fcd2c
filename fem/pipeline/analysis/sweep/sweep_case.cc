#include "fem/pipeline/analysis/sweep/sweep_case.h"

#include "fem/pipeline/analysis/solve_study.h"
#include "fem/pipeline/analysis/spin_comparison.h"
#include "ring_model/coulomb_ring.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace stemware::pipeline
{

namespace
{

/// Harmonics of the load that are listed.
constexpr unsigned int n_listed_harmonics = 8;

std::vector<SweepQuantity> make_quantities()
{
  std::vector<SweepQuantity> quantities = { { "normal force", "N" },     { "moment ratio", "1" },
                                            { "contact fraction", "1" }, { "least load", "N/rad" },
                                            { "ring radius", "m" },      { "mean radius", "m" },
                                            { "a_0", "N/rad" } };
  for (unsigned int n = 1; n <= n_listed_harmonics; ++n)
    for (const char *coefficient : { "a_", "b_" })
      quantities.push_back({ coefficient + std::to_string(n) + "/a_0", "1" });
  quantities.insert(quantities.end(), { { "torque at rest", "N m" },
                                        { "terminal spin", "rad/s" },
                                        { "terminal spin of the first harmonic alone", "rad/s" },
                                        { "terminal spin of the closure's first harmonic", "rad/s" },
                                        { "harmonic effect", "%" },
                                        { "closure effect", "%" },
                                        { "time constant", "s" },
                                        { "contact iterations", "1" } });
  return quantities;
}

/// Terminal spin of the paper's ansatz; nothing where there is none: a formal load can push for ever.
std::optional<double> formal_terminal_spin(const std::vector<ClosureRow> &closures, ring::Closure closure)
{
  const auto row = std::find_if(closures.begin(), closures.end(),
                                [=](const ClosureRow &candidate) { return candidate.closure == closure; });
  return row == closures.end() ? std::nullopt : row->omega_terminal;
}

std::optional<double> in_percent(const std::optional<double> &share)
{
  return share ? std::optional(100 * *share) : std::nullopt;
}

/// Collects values in the order of the quantities.
class ValueList
{
public:
  void add(const std::optional<double> &value)
  {
    const std::string &name = sweep_quantities().at(values.size()).name;
    if (value && !std::isfinite(*value))
      throw std::runtime_error("The result " + name + " is not a finite number; please report this study.");
    values.push_back(value ? std::optional(*value + 0.) : std::nullopt); // no -0
  }

  std::vector<std::optional<double>> values;
};

void add_load(const RingLoad &load, ValueList &list)
{
  const ring::RingStack &series = load.at_rest;
  list.add(load.normal_force);
  list.add(load.moment_ratio);
  list.add(load.contact_fraction);
  list.add(load.minimum);
  list.add(series.radius());
  list.add(load.mean_radius);
  list.add(series.a(0));
  for (unsigned int n = 1; n <= n_listed_harmonics; ++n)
  {
    const bool is_there = n <= series.n_harmonics();
    list.add(is_there ? series.a(n) / series.a(0) : 0);
    list.add(is_there ? series.b(n) / series.a(0) : 0);
  }
}

void add_spin(const Study &study, const RingLoad &load, ValueList &list)
{
  const ring::Motion &motion = study.motion.orbit;
  const ring::CoulombRing friction(motion.friction_coefficient);
  const ring::TerminalSpin terminal =
    truncated_terminal_spin(load.at_spin, motion, load.at_rest.n_harmonics());
  const double truncated = truncated_terminal_spin(load.at_spin, motion, 1).omega;
  const auto closures = compare_closures(motion, study.glass.profile.contact_radius);
  const SpinComparison spins = compare_spins(study, closures, terminal.omega, truncated);
  list.add(friction.wrench(load.at_rest, 0, motion.orbit_speed).torque);
  list.add(terminal.omega);
  list.add(truncated);
  list.add(formal_terminal_spin(closures, study.motion.closure));
  // A glass that does not spin up has a spin of rounding, to which nothing can be related.
  const bool is_spinning =
    std::abs(spins.first_harmonic) > 1e-12 * motion.orbit_speed / load.at_rest.radius();
  list.add(is_spinning ? in_percent(spins.harmonic_effect()) : std::nullopt);
  list.add(in_percent(spins.closure_effect()));
  list.add(std::isfinite(terminal.time_constant) ? std::optional(terminal.time_constant) : std::nullopt);
}

} // namespace

const std::vector<SweepQuantity> &sweep_quantities()
{
  static const std::vector<SweepQuantity> quantities = make_quantities();
  return quantities;
}

std::size_t quantity_index(const std::string &name)
{
  for (std::size_t i = 0; i < sweep_quantities().size(); ++i)
    if (sweep_quantities()[i].name == name)
      return i;
  throw std::logic_error("a sweep has no quantity " + name);
}

CaseResult solve_case(const Study &study, fem::ComplianceStore &store)
{
  const StudyLoad found = find_load(study, store);
  ValueList list;
  add_load(found.load, list);
  add_spin(study, found.load, list);
  CaseResult result;
  if (found.contact)
  {
    list.add(found.contact->result.solution.n_iterations);
    result.outcome = fem::to_string(found.contact->result.solution.outcome);
  }
  else
    list.add(std::nullopt);
  result.values = std::move(list.values);
  return result;
}

} // namespace stemware::pipeline
