#include "fem/pipeline/analysis/spin_comparison.h"

#include <algorithm>

namespace stemware::pipeline
{

namespace
{

const ClosureRow &row_of(const std::vector<ClosureRow> &rows, ring::Closure closure)
{
  return *std::find_if(rows.begin(), rows.end(),
                       [=](const ClosureRow &row) { return row.closure == closure; });
}

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

SpinComparison compare_spins(const Study &study, const StudyResult &result)
{
  SpinComparison spins = compare_spins(study, result.closures, result.yaw.terminal.omega,
                                       result.yaw.truncations.front().omega_terminal);
  if (!result.yaw.spins_up())
    spins.all_harmonics = spins.first_harmonic = 0;
  return spins;
}

SpinComparison compare_spins(const Study &study, const std::vector<ClosureRow> &closures,
                             double all_harmonics, double truncated)
{
  const ClosureRow &paper = row_of(closures, ring::Closure::paper);
  const ClosureRow &full = row_of(closures, ring::Closure::full);
  const ClosureRow &own = row_of(closures, study.motion.closure);
  const bool in_balance = study.load.source == LoadSource::contact && !study.load.is_static() &&
                          study.load.coupling != LoadCoupling::frozen;
  SpinComparison spins;
  spins.all_harmonics = all_harmonics;
  spins.first_harmonic = in_balance && own.omega_terminal ? *own.omega_terminal : truncated;
  spins.paper_closure = paper.omega_terminal;
  spins.complete_closure = full.omega_terminal;
  spins.is_formal = paper.is_formal() || full.is_formal();
  return spins;
}

} // namespace stemware::pipeline
