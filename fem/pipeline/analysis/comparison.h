#pragma once

#include "fem/pipeline/analysis/spin_row.h"
#include "fem/pipeline/coupling/elastic_foot.h"
#include "fem/pipeline/study/study.h"
#include "fem/pipeline/support/progress.h"

#include <memory>
#include <string>
#include <vector>

namespace stemware::pipeline
{

/// Moment balances by loads by truncations, side by side; the paper's is the first row.
struct Comparison
{
  std::vector<SpinRow> rows;

  /// The row of a moment balance on a load (SpinRow::load) with @p n harmonics, 0: all; nothing where there
  /// is none.
  const SpinRow *find(ring::Closure closure, const std::string &load, unsigned int n = 0) const;
};

/// Names of the loads that are compared, from the simplest to the study's own.
namespace compared_load
{
inline constexpr char first_harmonic[] = "first harmonic";
inline constexpr char rigid_flat_rim[] = "rigid flat rim";
inline constexpr char rigid_round_rim[] = "rigid round rim";
inline constexpr char foot_at_rest[] = "elastic foot at rest";
inline constexpr char foot_in_balance[] = "elastic foot";
} // namespace compared_load

/// The study's glass under the moment balances paper, hand and full, on the paper's first harmonic, on rigid
/// rims that only push, and on @p foot, where there is one, at rest and in balance with friction; each with
/// 1, 2, 3 and all harmonics. No row's trouble stops the others. The foot in balance has error bands where
/// they cost little.
Comparison compare_models(const Study &study, const std::shared_ptr<ElasticFoot> &foot, Progress &progress);

} // namespace stemware::pipeline
