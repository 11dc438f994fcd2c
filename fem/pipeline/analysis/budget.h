#pragma once

#include "fem/pipeline/analysis/study_rows.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace stemware::pipeline
{

/// One model of the chain from the paper's to the study's.
struct BudgetRow
{
  ChainStep step;
  /// Name of the difference to the row above: "paper" in the first row, then "friction law" (if friction
  /// depends on the slip), "moment balance" or "given moment", "grip", "where the foot touches", "tilt",
  /// "harmonics".
  std::string name;
  std::optional<unsigned int> harmonics = {}; ///< harmonics that act on the ring; std::nullopt: all
  std::optional<double> omega_terminal = {};  ///< [rad/s]
  std::optional<double> difference = {};      ///< change of the terminal spin from the row above [rad/s]
  std::optional<double> band = {};            ///< half-width, of the terminal spin: add_bands() [rad/s]
  std::array<std::optional<double>, 3> torques = {}; ///< friction's tau_z at Budget::shown_spins [N m]
  ring::Status status = ring::Status::no_balance;    ///< formal if lambda < 0 somewhere
  std::string reason = {};                           ///< cause of missing values; empty if none is missing
};

/// The complete model with one of its effects left out.
struct WithoutRow
{
  std::string name;                          ///< "friction in the foot", "tilt", ...: Variant::name
  std::optional<double> omega_terminal = {}; ///< [rad/s]
  std::optional<double> difference = {};     ///< change of the terminal spin from the complete model [rad/s]
  std::string reason = {}; ///< cause of a missing value: "not defined" without any compliance, ...
};

/// One input changed, on a rigid ring with a first-harmonic load.
struct InputRow
{
  std::string name;      ///< "0.05 more friction", ...: Variant::name
  double difference = 0; ///< change of the terminal spin [rad/s]
};

/// Effect of the harmonics beyond the first on the terminal spin: spin with all harmonics minus spin with the
/// first harmonic only, each with its own balance of contact, friction and moments. All verbs use this
/// definition.
struct HarmonicEffect
{
  std::optional<double> absolute = {}; ///< [rad/s]; std::nullopt if one of the two has no terminal spin
  std::optional<double> relative = {}; ///< relative to the first harmonic only, relative_to()
};

/// Effect on the terminal spin of each step from the paper's model to the study's.
///
/// Rows 1, 1a, 2 and 2a: first harmonics on a ring of the contact radius. From row 3 on the
/// contact is solved with its whole pressure; friction force and torque, also in the moment balance, use the
/// rings' harmonics up to BudgetRow::harmonics. Without a contact the chain ends early: a first harmonic with
/// row 2 or 2a; a load file without row 2 and without "without" rows.
struct Budget
{
  std::vector<BudgetRow> rows; ///< the last one is the study itself
  std::vector<WithoutRow> without;
  std::vector<InputRow> inputs; ///< inputs with an effect, see input_variants()
  HarmonicEffect harmonics;

  /// Spins of BudgetRow::torques: 0, half and all of the study's terminal spin [rad/s]; only 0 if the glass
  /// tips on the way.
  std::vector<double> shown_spins = {};
};

/// Returns @p difference over @p reference; 0 if the difference is rounding. Returns std::nullopt if one of
/// the two is missing, or if the reference or the sum of both is rounding (below 1e-9 @p spin_scale [rad/s])
/// or they have opposite signs.
std::optional<double> relative_to(const std::optional<double> &reference,
                                  const std::optional<double> &difference, double spin_scale);

/// Returns the effect from the terminal spins of the first harmonic only and of all harmonics [rad/s].
HarmonicEffect harmonic_effect(const std::optional<double> &first, const std::optional<double> &all,
                               double spin_scale);

/// Returns the variants that find_budget() needs: the models of the chain before the study's own rows,
/// the study without one effect at a time, and changed inputs; @p own: the study itself. @p depends_on_phase:
/// whether the study's load does.
std::vector<Variant> budget_variants(const Variant &own, bool depends_on_phase);

/// Returns the chain of models: the rows of model_chain() among @p rows.others, then the rows by harmonics,
/// with torques if their answers have some.
std::vector<BudgetRow> assess_chain(const Study &study, const StudyRows &rows);

/// Returns the budget from @p rows, rows_by_harmonics() with the answers to budget_variants() among the
/// others. A failed row has its reason.
Budget find_budget(const Study &study, const StudyRows &rows);

} // namespace stemware::pipeline
