#pragma once

#include "fem/pipeline/analysis/spin_study.h"

#include <optional>
#include <vector>

namespace stemware::pipeline
{

/// The terminal spin of the study's glass beside those of simpler models of the same glass [rad/s].
struct SpinComparison
{
  double all_harmonics = 0;               ///< the study's own
  double first_harmonic = 0;              ///< of the first harmonic alone, in the same moment balance
  std::optional<double> paper_closure;    ///< first harmonic, the paper's moment balance
  std::optional<double> complete_closure; ///< first harmonic, moment balance `full`
  bool is_formal = false; ///< whether the last two, or one of them, would have to pull on the table

  /// What the harmonics beyond the first add to the spin, relative to the first alone; nothing where that
  /// does not spin.
  std::optional<double> harmonic_effect() const;
  /// What the moment balance `full` adds to the spin, relative to `paper`.
  std::optional<double> closure_effect() const;
};

/// The terminal spin of @p to relative to that of @p from, less 1; nothing where one does not exist or the
/// first is 0.
std::optional<double> relative_effect(const SpinRow *from, const SpinRow *to);

/// The row of a moment balance; null where there is none.
const SpinRow *row_of(const std::vector<SpinRow> &rows, ring::Closure closure);

/// For a load in balance with friction at every spin, the first harmonic is in such a balance too; for a
/// frozen load it is the first harmonic of that load.
SpinComparison compare_spins(const Study &study, const SpinStudy &spin);

/// SpinComparison from its parts: SpinStudy::closures, and the terminal spin under all harmonics and under
/// the load cut off after the first.
SpinComparison compare_spins(const Study &study, const std::vector<SpinRow> &closures, double all_harmonics,
                             double truncated);

} // namespace stemware::pipeline
