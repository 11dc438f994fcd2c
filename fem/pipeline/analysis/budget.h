#pragma once

#include "fem/pipeline/analysis/study_rows.h"

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace stemware::pipeline
{

/// One model of the chain from the paper's to the study's.
struct BudgetRow
{
  ChainStep step;
  /// Difference from the row above: "paper" in the first row, then "friction law" (if friction depends on the
  /// slip), "moment balance" or "given moment", "grip", "where the foot touches", "tilt", "harmonics".
  std::string name;
  std::optional<unsigned int> harmonics = {}; ///< harmonics that act on the ring; std::nullopt: all
  std::optional<double> omega_terminal = {};  ///< [rad/s]
  std::optional<double> difference = {};      ///< change of the terminal spin from the row above [rad/s]
  std::optional<double> band = {};            ///< half-width for the terminal spin, model_band() [rad/s]
  std::array<std::optional<double>, 3> torques = {}; ///< friction's tau_z at LoadedRow::torques [N m]
  ring::Status status = ring::Status::no_balance;    ///< `formal` if lambda < 0 somewhere
  std::string reason = {};                           ///< cause of missing values, or empty
};

/// The complete model with one of its effects left out.
struct WithoutRow
{
  std::string name;                          ///< "friction in the foot", "tilt", ...: Variant::name
  std::optional<double> omega_terminal = {}; ///< [rad/s]
  std::optional<double> difference = {};     ///< change of the terminal spin from the complete model [rad/s]
  std::string reason = {};                   ///< cause of a missing value, or empty
};

/// Effect of the harmonics beyond the first on the terminal spin: spin with all harmonics minus spin with the
/// first only, each with its own balance of contact, friction and moments.
struct HarmonicEffect
{
  std::optional<double> absolute = {}; ///< [rad/s]; std::nullopt if one spin is missing
  std::optional<double> relative = {}; ///< relative_to() the spin of the first harmonic
};

/// Effect on the terminal spin of each step from the paper's model to the study's (docs/theory/budget.md).
/// Rows 1, 1a, 2 and 2a: first harmonic on a ring of the contact radius. From row 3 on the contact is solved
/// with its whole pressure; friction uses the rings' harmonics up to BudgetRow::harmonics. Without a contact,
/// the rows of a first-harmonic load end with row 2 or 2a; a load file has no row 2 and no "without" rows.
struct Budget
{
  std::vector<BudgetRow> rows; ///< the last one is the study itself
  std::vector<WithoutRow> without;
  /// Name of each input_variants() with an effect, and its change of the terminal spin [rad/s].
  std::vector<std::pair<std::string, double>> inputs;
};

/// Returns @p difference over @p reference; 0 if |difference| is below the rounding error 1e-9 @p spin_scale
/// [rad/s]. Returns std::nullopt if an argument is missing, if the reference or its sum with the difference
/// is below the rounding error, or if these two have different signs.
std::optional<double> relative_to(const std::optional<double> &reference,
                                  const std::optional<double> &difference, double spin_scale);

/// Returns the effect from the terminal spins of the first harmonic and of all harmonics [rad/s].
HarmonicEffect harmonic_effect(const std::optional<double> &first, const std::optional<double> &all,
                               double spin_scale);

/// Returns the effect from the first and the last of the @p rows by harmonics.
HarmonicEffect harmonic_effect(const StudyRows &rows);

/// Returns model_chain(), variants_without() and input_variants() of @p own, the study itself, for
/// find_budget(). @p depends_on_phase: true if the load does.
std::vector<Variant> budget_variants(const Variant &own, bool depends_on_phase);

/// Half-widths of the error bands of the terminal spins of all harmonics and of the first [rad/s].
using SpinBands = std::pair<std::optional<double>, std::optional<double>>;

/// Returns the half-width of the error band of the terminal spin @p omega of a model with a contact, from the
/// spins of all harmonics and of the first, and their @p bands [rad/s]: the wider of the two bands, but at
/// most either band plus the difference of the spins, because discretisation changes small differences only
/// by a fraction. Without band or spin of the first harmonic, a spin has a band only if its difference to all
/// harmonics is at most their band; without those of all harmonics, std::nullopt.
std::optional<double> model_band(double omega, const std::optional<double> &omega_all,
                                 const std::optional<double> &omega_first, const SpinBands &bands);

/// Returns the chain: the rows of model_chain() among @p rows.others, then the rows by harmonics. Rows with
/// a contact have the model_band() of @p bands.
std::vector<BudgetRow> assess_chain(const StudyRows &rows, const SpinBands &bands = {});

/// Returns the budget from @p rows, rows_by_harmonics() with budget_variants(); failed rows have a reason.
Budget find_budget(const StudyRows &rows, const SpinBands &bands = {});

} // namespace stemware::pipeline
