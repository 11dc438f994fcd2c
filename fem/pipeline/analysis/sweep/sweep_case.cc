#include "fem/pipeline/analysis/sweep/sweep_case.h"

#include "fem/pipeline/analysis/budget.h"
#include "fem/pipeline/analysis/refinement/goal_mesh.h"
#include "fem/pipeline/coupling/study_load.h"

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
                                            { "contact fraction", "1" }, { "least load at rest", "N/rad" },
                                            { "ring radius", "m" },      { "mean radius", "m" },
                                            { "a_0", "N/rad" } };
  for (unsigned int n = 1; n <= n_listed_harmonics; ++n)
    for (const char *coefficient : { "a_", "b_" })
      quantities.push_back({ coefficient + std::to_string(n) + "/a_0", "1" });
  quantities.insert(quantities.end(), { { "torque at rest", "N m" },
                                        { "terminal spin", "rad/s" },
                                        { "terminal spin of the first harmonic alone", "rad/s" },
                                        { "terminal spin of the closure's first harmonic", "rad/s" },
                                        { "moment balance", "rad/s" },
                                        { "grip", "rad/s" },
                                        { "where the foot touches", "rad/s" },
                                        { "tilt", "rad/s" },
                                        { "absolute harmonic effect", "rad/s" },
                                        { "harmonic effect", "%" },
                                        { "closure effect", "%" },
                                        { "held by the grip", "1" },
                                        { "time constant", "s" },
                                        { "contact iterations", "1" },
                                        { spin_of_fall, "rad/s" },
                                        { "moment ratio at which it falls over", "1" } });
  return quantities;
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

void add_load(const LoadReport &load, ValueList &list)
{
  const ring::RingStack &series = load.rings;
  list.add(load.normal_force);
  list.add(load.moment_ratio);
  list.add(load.contact_fraction);
  list.add(load.minimum);
  list.add(series.radius());
  list.add(load.mean_radius);
  list.add(series.a(0));
  for (unsigned int n = 1; n <= n_listed_harmonics; ++n)
  {
    list.add(series.a(n) / series.a(0));
    list.add(series.b(n) / series.a(0));
  }
}

/// The terminal spin of a first harmonic on a ring of the contact radius, nothing where there is none.
std::optional<double> first_harmonic_spin(const Study &study, ring::Closure closure)
{
  return attempt_spin_row(*first_harmonic_load(study, closure), { study.motion.orbit }).omega_terminal();
}

/// What the rows of the budget change that have this name [rad/s]; nothing without such a row.
std::optional<double> difference_by(const std::string &name, const std::vector<BudgetRow> &rows)
{
  for (const BudgetRow &row : rows)
    if (row.name == name || (name == "moment balance" && row.name == "given moment"))
      return row.difference;
  return std::nullopt;
}

/// Where the glass falls over, if it does.
std::optional<Fall> add_spin(const Study &study, const std::shared_ptr<ElasticFoot> &foot,
                             const BalancedLoad &load, const Executor &executor, ValueList &list)
{
  SpinQuestion question = spin_question(study);
  question.with_minima = false;
  const std::vector<LoadedRow> rows =
    rows_by_harmonics(study, foot, load, question, executor, silent_progress(), Depth::answer);
  const SpinRow &all = rows.back().row;
  const std::optional<double> first = rows.front().row.omega_terminal();
  const std::vector<BudgetRow> budget = budget_rows(study, foot, { rows.front().row, all }, executor);
  const double unit = spin_scale(study);
  const HarmonicEffect harmonics = harmonic_effect(first, all.omega_terminal(), unit);
  // With a given moment no balance acts.
  const bool has_balance = !study.load.is_static() && study.load.source != LoadSource::file;
  const auto balanced_spin = [&](ring::Closure closure)
  { return has_balance ? first_harmonic_spin(study, closure) : std::nullopt; };
  const std::optional<double> paper = balanced_spin(ring::Closure::paper),
                              full = balanced_spin(ring::Closure::full);
  list.add(all.at_rest->friction.torque);
  list.add(all.omega_terminal());
  list.add(first);
  list.add(first_harmonic_spin(study, study.motion.closure));
  for (const char *name : { "moment balance", "grip", "where the foot touches", "tilt" })
    list.add(difference_by(name, budget));
  list.add(harmonics.absolute);
  list.add(in_percent(harmonics.relative));
  list.add(in_percent(paper && full ? relative_to(paper, *full - *paper, unit) : std::nullopt));
  list.add(study.motion.grip_torque > 0 && all.terminal ? std::optional<double>(all.terminal->held ? 1 : 0)
                                                        : std::nullopt);
  list.add(all.time_constant());
  return all.fall;
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

bool CaseResult::falls_over() const
{
  return is_solved() && values.at(quantity_index(spin_of_fall)).has_value();
}

CaseResult case_result(const Study &study, const std::shared_ptr<ElasticFoot> &foot, const Executor &executor)
{
  const SharedLoad load = find_load(study, foot);
  ValueList list;
  add_load(load->report(), list);
  const std::optional<Fall> fall = add_spin(study, foot, *load, executor, list);
  CaseResult result;
  if (const std::optional<fem::ContactState> at_rest = load->contact(0))
  {
    list.add(at_rest->solution.n_iterations);
    result.outcome = fem::to_string(at_rest->solution.outcome);
  }
  else
    list.add(std::nullopt);
  list.add(fall ? std::optional(fall->omega) : std::nullopt);
  list.add(fall ? std::optional(fall->state.moment_ratio) : std::nullopt);
  result.values = std::move(list.values);
  return result;
}

CaseResult solve_case(const Study &study, const Executor &executor)
{
  return solve_alone(
    mesh_for_goal(study, executor).study,
    [&](const Variant &variant, const auto &foot) { return case_result(variant.study, foot, executor); },
    executor);
}

} // namespace stemware::pipeline
