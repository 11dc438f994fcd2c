#include "fem/pipeline/analysis/comparison.h"

#include "fem/pipeline/analysis/refinement/refinement_study.h"
#include "fem/pipeline/analysis/solve_study.h"
#include "fem/pipeline/support/failures.h"
#include "ring_model/load_model.h"
#include "ring_model/terminal_spin.h"

#include <cmath>
#include <exception>
#include <iterator>

namespace stemware::pipeline
{

namespace
{

/// The word for a failure that is being handled, while a load is looked for.
std::string state_of_failure()
{
  try
  {
    throw;
  }
  catch (const ring::Tipping &)
  {
    return "tips";
  }
  catch (const fem::ContactFailure &failure)
  {
    return failure.outcome == fem::ContactOutcome::tipping ? "tips" : "no balance";
  }
  catch (const BadInput &)
  {
    return "tips"; // required_resultants() refuses nothing else
  }
  catch (const std::exception &)
  {
    return "no balance";
  }
}

/// What the load at the terminal spin is like.
std::string state_of(const ComparisonRow &row)
{
  // A series that ends where the contact ends dips below 0 there by less than its last harmonics.
  if (!row.contact_fraction || (!row.all_harmonics && row.least_load < 0))
    return row.least_load < 0 ? "formal" : "full contact";
  return *row.contact_fraction < 1 ? "lift-off" : "full contact";
}

void solve(const Study &study, const LoadKind &kind, ComparisonRow &row)
{
  const ring::Motion &orbit = study.motion.orbit;
  const ring::CoulombRing friction(orbit.friction_coefficient);
  row.state = "no balance";
  const ComparedLoad load = kind.load(row.closure, row.harmonics);
  const ring::AngularLoad at_rest = load.at_spin(0);
  row.tau_at_rest = friction.wrench(at_rest, 0, orbit.orbit_speed).torque;
  row.moment_ratio = at_rest.moment_ratio();
  bool has_balance = true;
  const auto torque = [&](double omega)
  {
    has_balance = false;
    const ring::AngularLoad balanced = load.at_spin(omega);
    has_balance = true;
    return friction.wrench(balanced, omega, orbit.orbit_speed).torque;
  };
  try
  {
    row.omega_terminal = ring::terminal_omega(torque, orbit.orbit_speed / at_rest.radius());
  }
  catch (const std::exception &failure)
  {
    row.state = has_balance ? "no terminal spin" : state_of_failure();
    row.trouble = failure.what();
    return;
  }
  row.least_load = load.at_spin(*row.omega_terminal).minimum();
  if (load.contact_fraction)
    row.contact_fraction = load.contact_fraction(*row.omega_terminal);
  row.state = state_of(row);
}

ComparisonRow solved_row(const Study &study, const LoadKind &kind, ring::Closure closure, unsigned int n)
{
  ComparisonRow row;
  row.closure = closure;
  row.load = kind.name;
  row.harmonics = n;
  row.all_harmonics = n == kind.orders.back();
  try
  {
    solve(study, kind, row);
  }
  catch (const std::exception &failure)
  {
    row.state = state_of_failure();
    row.trouble = failure.what();
  }
  return row;
}

} // namespace

const ComparisonRow *Comparison::find(ring::Closure closure, const std::string &load, unsigned int n) const
{
  for (const ComparisonRow &row : rows)
    if (row.closure == closure && row.load == load && (n == 0 ? row.all_harmonics : row.harmonics == n))
      return &row;
  return nullptr;
}

void add_error_bands(const Study &study, Comparison &comparison)
{
  for (ComparisonRow &row : comparison.rows)
  {
    if (row.load != balanced_foot || !row.all_harmonics || !row.omega_terminal ||
        row.closure == ring::Closure::hand)
      continue;
    Study own = study;
    own.motion.closure = row.closure;
    own.load.coupling = LoadCoupling::exact;
    if (has_quick_error_bands(own))
      row.band = terminal_spin_band(own, find_load(own).load, *row.omega_terminal);
  }
}

std::size_t n_rows(const std::vector<LoadKind> &kinds)
{
  std::size_t n = 0;
  for (const LoadKind &kind : kinds)
    n += kind.orders.size();
  return n * std::size(compared_closures);
}

Comparison compare_models(const Study &study, const std::vector<LoadKind> &kinds,
                          const std::function<void(std::size_t n_done)> &progress)
{
  Comparison comparison;
  for (const ring::Closure closure : compared_closures)
    for (const LoadKind &kind : kinds)
      for (const unsigned int n : kind.orders)
      {
        comparison.rows.push_back(solved_row(study, kind, closure, n));
        if (progress)
          progress(comparison.rows.size());
      }
  const std::optional<double> paper = comparison.rows.front().omega_terminal;
  for (ComparisonRow &row : comparison.rows)
    if (paper && *paper != 0 && row.omega_terminal)
      row.difference = *row.omega_terminal / *paper - 1;
  return comparison;
}

} // namespace stemware::pipeline
