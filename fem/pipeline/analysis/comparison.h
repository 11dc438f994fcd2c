#pragma once

#include "fem/pipeline/analysis/budget.h"
#include "fem/pipeline/variants/variant.h"

#include <memory>
#include <string>
#include <vector>

namespace stemware::pipeline
{

/// Variants of a study, side by side; of `compare` moment balances by loads by truncations.
struct Comparison
{
  std::vector<SpinRow> rows;          ///< of `compare` the paper's is the first
  double spin_scale = 0;              ///< spin_scale() of the study [rad/s]
  std::vector<BudgetRow> budget = {}; ///< of judge_models()

  /// The row of a moment balance on a load (SpinRow::load) with @p n harmonics, 0: all; nothing where there
  /// is none.
  const SpinRow *find(ring::Closure closure, const std::string &load, unsigned int n = 0) const;

  /// All harmonics of a load against its first, under a moment balance.
  HarmonicEffect harmonic_effect(ring::Closure closure, const std::string &load) const;
};

/// The rows of @p variants, in their order, SpinRow::load being Variant::name, with the share of the rim that
/// carries and the difference to the first row. Of each load, those that keep as many harmonics as it has are
/// left out beside that of all. No row's trouble stops the others. @p foot is study_foot().
Comparison compare_variants(const Study &study, const std::vector<Variant> &variants,
                            const std::shared_ptr<ElasticFoot> &foot, const Executor &executor,
                            Progress &progress = silent_progress());

/// Names of the loads that are compared, from the simplest to the study's own.
namespace compared_load
{
inline constexpr char first_harmonic[] = "first harmonic";
inline constexpr char rigid_flat_rim[] = "rigid flat rim";
inline constexpr char rigid_round_rim[] = "rigid round rim";
inline constexpr char rigid_foot[] = "rigid foot";
inline constexpr char foot_at_rest[] = "elastic foot at rest";
inline constexpr char foot_in_balance[] = "elastic foot";
} // namespace compared_load

/// The variants of `compare`: the study's glass under the moment balances paper, hand and full; on the
/// paper's first harmonic; on rigid rims on a mat that only pushes, in closed form; and, where the load comes
/// from a contact, with a rigid foot on the study's table (unless nothing yields there), and with the elastic
/// foot one-way, its load being that of rest, and two-way. Each with 1, 2, 3 and all harmonics.
std::vector<Variant> compared_models(const Study &study);

/// Adds to the comparison of compared_models() the error bands of the elastic foot two-way with all its
/// harmonics, under the moment balances that the answer names, and budget_rows() of the study on the last
/// load, two-way where there is an elastic foot. Throws as estimate_bands().
void judge_models(const Study &study, const std::shared_ptr<ElasticFoot> &foot, const Executor &executor,
                  Comparison &comparison);

} // namespace stemware::pipeline
