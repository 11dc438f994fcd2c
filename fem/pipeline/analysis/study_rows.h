#pragma once

#include "fem/pipeline/coupling/balanced_load.h"
#include "fem/pipeline/variants/solve.h"
#include "ring_model/spin/answer.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace stemware::pipeline
{

/// A solved variant: the answer about its load.
struct LoadedRow
{
  Variant variant = {};
  ring::Answer row = {};
  ring::SharedLoad load = {}; ///< nullptr if the variant has none; Answer::reason says why
};

/// Answers of one study.
struct StudyRows
{
  std::vector<LoadedRow> by_harmonics; ///< all harmonics last
  std::vector<LoadedRow> others;       ///< variants that were solved beside them
};

/// v / R with the contact radius of the study's glass [rad/s].
double spin_unit(const Study &study);

/// The spin that the moment M_Nx at rest leads to in first order, 2 |M_Nx| / (N R) times spin_unit(), from
/// 1e-6 to all of that [rad/s]; all of it where there is no such moment, or a file has the load. Spins below
/// 1e-9 of it, and differences of spins, are rounding.
double spin_scale(const Study &study);

/// A spin to show the torque of @p row up to [rad/s]: @p fastest, or, of a glass that hardly spins up, a
/// tenth of spin_unit() in the direction in which it is turned.
double shown_spin(const Study &study, const ring::Answer &row, double fastest);

/// A sentence where the fingers hold the glass of @p row at rest; empty elsewhere.
std::string grip_holds_note(const Study &study, const ring::Answer &row);

/// Depth of a study: which findings it adds to the answer and its curves.
enum class Depth
{
  answer, ///< nothing: all harmonics and the first alone
  full    ///< rows by harmonics, one ring, budget, leave-one-out
};

/// Question of a row about the spin of a study, its motion, grip and contact radius added to what is @p
/// asked.
ring::Question spin_question(const Study &study, ring::Question asked = {});

/// The rows of @p variants, each asked @p asked with its own motion, grip and contact radius; solve() says
/// whose @p foot is. Does not throw for what meshes that cannot be made, contacts, balances and spins throw:
/// a row has what there is, and the reason for what is missing. @p progress receives @p pieces.
std::vector<LoadedRow> solve_rows(const std::vector<Variant> &variants,
                                  const std::shared_ptr<ElasticFoot> &foot, const ring::Question &asked,
                                  const Executor &executor, Progress &progress = silent_progress(),
                                  const std::string &pieces = "");

/// The row of a variant without a load because of @p failure.
ring::Answer failed_row(const std::exception_ptr &failure);

/// Numbers of harmonics at which loads are cut off: 1, 2, 3, 4, 6, 8, 12, 16, ... below @p n_all, then @p
/// n_all.
std::vector<unsigned int> truncation_orders(unsigned int n_all);

/// The answer by the number of harmonics: 1, 2, 3, 4, 6, 8, 12, ... and all, which is the last, the answer of
/// @p load, find_load() of @p foot; the others each in a balance of its own if loads are two-way, else of
/// that load cut off; related to the last one by what changes. A solid body in balance has 1 and all: each
/// of its balances takes minutes; so has any study of which the answer alone is asked. Throws as @p load, and
/// if all harmonics have no answer; if the glass falls over on the way, the last row has a fall and nothing
/// is related to it. @p others are asked the same question beside them, so that no thread waits for the
/// slowest row.
StudyRows rows_by_harmonics(const Study &study, const std::shared_ptr<ElasticFoot> &foot,
                            const ring::LoadAtSpin &load, ring::Question question, const Executor &executor,
                            Progress &progress = silent_progress(), Depth depth = Depth::full,
                            const std::vector<Variant> &others = {});

/// Returns @p row with its load interpolated in the spin, for curves of thousands of values: from @p lower to
/// @p upper [rad/s], or to where its glass falls over; if there is no balance all the way, from rest to the
/// terminal spin; exact if that fails too. @p like is ring::interpolated()'s.
LoadedRow with_interpolated_load(LoadedRow row, double lower, double upper,
                                 const ring::LoadAtSpin *like = nullptr);

} // namespace stemware::pipeline
