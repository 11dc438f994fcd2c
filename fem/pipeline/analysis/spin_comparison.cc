#include "fem/pipeline/analysis/spin_comparison.h"

#include <algorithm>

namespace stemware::pipeline
{

namespace
{

std::optional<double> relative_change(const std::optional<double> &from, const std::optional<double> &to)
{
  if (!from || !to || *from == 0)
    return std::nullopt;
  return *to / *from - 1;
}

} // namespace

std::optional<double> SpinComparison::harmonic_effect() const
{
  return relative_change(first_harmonic, all_harmonics);
}

std::optional<double> SpinComparison::closure_effect() const
{
  return relative_change(paper_closure, complete_closure);
}

std::optional<double> relative_effect(const SpinRow *from, const SpinRow *to)
{
  return from && to ? relative_change(from->omega_terminal(), to->omega_terminal()) : std::nullopt;
}

const SpinRow *row_of(const std::vector<SpinRow> &rows, ring::Closure closure)
{
  const auto row =
    std::find_if(rows.begin(), rows.end(), [=](const SpinRow &each) { return each.closure == closure; });
  return row == rows.end() ? nullptr : &*row;
}

SpinComparison compare_spins(const Study &study, const SpinStudy &spin)
{
  SpinComparison spins =
    compare_spins(study, spin.closures, spin.all().terminal->omega, spin.rows.front().terminal->omega);
  if (!spin.spins_up())
    spins.all_harmonics = spins.first_harmonic = 0;
  return spins;
}

SpinComparison compare_spins(const Study &study, const std::vector<SpinRow> &closures, double all_harmonics,
                             double truncated)
{
  const SpinRow &paper = *row_of(closures, ring::Closure::paper);
  const SpinRow &full = *row_of(closures, ring::Closure::full);
  const SpinRow &own = *row_of(closures, study.motion.closure);
  SpinComparison spins;
  spins.all_harmonics = all_harmonics;
  spins.first_harmonic = study.load.is_in_balance() && own.terminal ? own.terminal->omega : truncated;
  spins.paper_closure = paper.omega_terminal();
  spins.complete_closure = full.omega_terminal();
  spins.is_formal = paper.pulls() || full.pulls();
  return spins;
}

} // namespace stemware::pipeline
