#pragma once

#include "fem/pipeline/analysis/spin.h"
#include "fem/pipeline/coupling/balanced_load.h"
#include "fem/pipeline/variants/solve.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace stemware::pipeline
{

/// A row with the load that it is the answer to.
struct LoadedRow
{
  SpinRow row;
  SharedLoad load = {}; ///< nothing where the study has none; SpinRow::reason says why
};

/// v / R with the contact radius of the study's glass [rad/s].
double spin_unit(const Study &study);

/// The spin that the moment M_Nx at rest leads to in first order, 2 |M_Nx| / (N R) times spin_unit(), from
/// 1e-6 to all of that [rad/s]; all of it where there is no such moment, or a file has the load. Spins below
/// 1e-9 of it, and differences of spins, are rounding.
double spin_scale(const Study &study);

/// A spin to show the torque of @p row up to [rad/s]: @p fastest, or, of a glass that hardly spins up, a
/// tenth of spin_unit() in the direction in which it is turned.
double shown_spin(const Study &study, const SpinRow &row, double fastest);

/// A sentence where the fingers hold the glass of @p row at rest; empty elsewhere.
std::string held_by_the_grip(const Study &study, const SpinRow &row);

/// Depth of a study: which findings it adds to the answer and its curves.
enum class Depth
{
  answer, ///< nothing: all harmonics and the first alone
  full    ///< rows by harmonics, one ring, budget, leave-one-out
};

/// Question of a row about the spin of a study, its motion, grip and contact radius added to what is @p
/// asked.
SpinQuestion spin_question(const Study &study, SpinQuestion asked = {});

/// The rows of @p variants, each asked @p asked with its own motion, grip and contact radius; solve() says
/// whose @p foot is. Does not throw for what meshes that cannot be made, contacts, balances and spins throw:
/// a row has what there is, and the reason for what is missing. @p progress is told of @p pieces.
std::vector<LoadedRow> solve_rows(const std::vector<Variant> &variants,
                                  const std::shared_ptr<ElasticFoot> &foot, const SpinQuestion &asked,
                                  const Executor &executor, Progress &progress = silent_progress(),
                                  const std::string &pieces = "");

/// Numbers of harmonics at which loads are cut off: 1, 2, 3, 4, 6, 8, 12, 16, ... below @p n_all, then @p
/// n_all.
std::vector<unsigned int> truncation_orders(unsigned int n_all);

/// The terminal spin of @p row as a start for those of models that differ little; nothing where it has none,
/// or one without a slope.
std::optional<ring::KnownZero> known_zero(const SpinRow &row);

/// Variants that are solved beside the rows by harmonics, so that no thread waits for the slowest row: what
/// to solve, once the answer of all harmonics is known, and the answers, in the same order.
struct RowsBeside
{
  std::function<std::vector<Variant>(const SpinRow &all)> variants;
  std::vector<LoadedRow> answers = {};
};

/// The answer by the number of harmonics: 1, 2, 3, 4, 6, 8, 12, ... and all, which is the last, the answer of
/// @p load, find_load() of @p foot; the others each in a balance of its own where loads are two-way, else of
/// that load cut off; related to the last one by what changes. A solid body in balance has 1 and all: each
/// of its balances takes minutes; so has any study of which the answer alone is asked. Throws as @p load and
/// spin_row() where all harmonics have no answer; where the glass falls over on the way, the last row has a
/// SpinRow::fall and nothing is related to it. What is asked for @p beside them is asked the same question.
std::vector<LoadedRow> rows_by_harmonics(const Study &study, const std::shared_ptr<ElasticFoot> &foot,
                                         const BalancedLoad &load, SpinQuestion question,
                                         const Executor &executor, Progress &progress = silent_progress(),
                                         Depth depth = Depth::full, RowsBeside *beside = nullptr);

/// Interpolates the loads of the last one of @p rows, and of those in front of it with up to @p n_most
/// harmonics, in the spin, for curves of thousands of values: from @p lower to @p upper [rad/s], or, where
/// there is no balance all the way, from rest to the terminal spin; exact where that fails too.
void interpolate_loads(double lower, double upper, unsigned int n_most, const Executor &executor,
                       std::vector<LoadedRow> &rows);

} // namespace stemware::pipeline
