#pragma once

#include "fem/pipeline/analysis/study_rows.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace stemware::pipeline
{

/// The place of a model in the chain from the paper's to the study's.
struct ChainStep
{
  unsigned int number = 1;  ///< 1 the paper, 2 the study's moment, 3 its contact, 4 ... more harmonics
  bool is_addition = false; ///< to the model of that number: 1a, 2a, 3a

  /// True if its terminal spin is that of the study's contact, and not of a closed form.
  bool is_of_contact() const { return number >= 3; }
  bool operator==(const ChainStep &other) const
  {
    return number == other.number && is_addition == other.is_addition;
  }
};

/// One model of the chain from the paper's to the study's.
struct BudgetRow
{
  ChainStep step;
  /// Name of the difference to the row above: "paper" in the first one, then "friction law" (where friction
  /// depends on the slip), "moment balance" or "given moment", "grip", "where the foot touches", "tilt",
  /// "harmonics".
  std::string name;
  std::optional<unsigned int> harmonics = {}; ///< that act on the ring; nothing: all
  std::optional<double> omega_terminal = {};  ///< [rad/s]
  std::optional<double> difference = {};      ///< of the terminal spin to that of the row above [rad/s]
  std::optional<double> band = {};            ///< half-width, of the terminal spin: add_bands() [rad/s]
  std::array<std::optional<double>, 3> torques = {}; ///< friction's tau_z at Budget::shown_spins [N m]
  ring::Status status = ring::Status::no_balance;    ///< formal where lambda < 0 somewhere
  std::string reason = {};                           ///< why something is missing; empty where nothing is
};

/// The complete model with one of its effects left out.
struct WithoutRow
{
  std::string name;                          ///< "friction in the foot", "tilt", ...: Variant::name
  std::optional<double> omega_terminal = {}; ///< [rad/s]
  std::optional<double> difference = {};     ///< of the terminal spin to that of the complete model [rad/s]
  std::string reason = {};                   ///< why there is none: "not defined" without any compliance, ...
};

/// Effect of the harmonics beyond the first on the terminal spin: all of them against the first alone, each
/// in its own balance of contact, friction and moments. The one definition of every verb.
struct HarmonicEffect
{
  std::optional<double> absolute = {}; ///< [rad/s]; nothing where one of the two has no terminal spin
  std::optional<double> relative = {}; ///< to the first alone, relative_to()
};

/// Effect on the terminal spin of each step from the paper's model to the study's.
///
/// Rows 1, 1a, 2 and 2a are first harmonics on a ring of the contact radius, in closed form. In rows 3 and on
/// the contact is solved with its whole pressure; the friction force and the torque, also in the balance of
/// moments, are those of the rings' harmonics up to BudgetRow::harmonics. A study without a contact ends
/// where its load does: a first harmonic with row 2 or 2a; one from a file has no row 2, and no "without".
struct Budget
{
  std::vector<BudgetRow> rows; ///< the last one is the study itself
  std::vector<WithoutRow> without;
  HarmonicEffect harmonics;

  /// 0, half and all of the study's terminal spin [rad/s]; 0 alone where the glass falls over on the way.
  std::vector<double> shown_spins = {};

  /// Friction's tau_z of all harmonics and of the first alone over the spin, from 0 to 1.2 times the terminal
  /// spin, or to that of the fall [rad/s, N m]; NaN where there is no balance.
  std::vector<double> omega, torque_all, torque_first;
};

/// @p difference relative to @p reference, 0 where it is rounding; nothing where one is missing, or where the
/// reference and the spin that differs from it by so much are not two spins in one sense. Below 1e-9
/// @p spin_scale (spin_scale() of the study, all in rad/s) a spin is rounding.
std::optional<double> relative_to(const std::optional<double> &reference,
                                  const std::optional<double> &difference, double spin_scale);

/// The effect from the terminal spins of the first harmonic alone and of all harmonics [rad/s].
HarmonicEffect harmonic_effect(const std::optional<double> &first, const std::optional<double> &all,
                               double spin_scale);

/// Variants whose answers find_budget() takes: the models of the chain in front of the study's own rows, and
/// the study without one effect at a time, whose load @p depends_on_phase.
std::vector<Variant> budget_variants(const Study &study, bool depends_on_phase);

/// The chain of models: the rows of model_chain() among @p rows.others, then those by harmonics, with the
/// torques that their answers have.
std::vector<BudgetRow> assess_chain(const Study &study, const StudyRows &rows);

/// The budget from what is known: @p rows are rows_by_harmonics() with the answers to budget_variants()
/// beside them. Torques are asked of their loads. A row that failed says why.
Budget find_budget(const Study &study, StudyRows rows, const Executor &executor);

} // namespace stemware::pipeline
