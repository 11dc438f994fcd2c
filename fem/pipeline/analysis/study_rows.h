#pragma once

#include "fem/pipeline/analysis/solve.h"
#include "fem/pipeline/coupling/balanced_load.h"
#include "ring_model/spin/answer.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace stemware::pipeline
{

/// Solved variant, with its torques.
struct LoadedRow
{
  Variant variant = {};
  ring::Answer row = {};
  std::optional<ring::Load> load = {}; ///< std::nullopt if the load failed (Answer::reason), in SpinStudy
  /// Torques of a row of the chain at 0, half and all of the study's terminal spin, or at 0 if the glass
  /// tips.
  std::vector<ring::Torques> torques = {};
};

/// Answers of one study.
struct StudyRows
{
  std::vector<LoadedRow> by_harmonics; ///< first harmonic first; all harmonics, the study itself, last
  std::vector<LoadedRow> others;       ///< further variants

  /// Returns the answer with all harmonics.
  const ring::Answer &answer() const { return by_harmonics.back().row; }
  /// Returns the terminal spin with the first harmonic only [rad/s]; std::nullopt without one.
  std::optional<double> omega_first_harmonic() const { return by_harmonics.front().row.omega_terminal(); }
};

/// Returns a sentence if the fingers hold the glass of @p row at rest, else an empty string. @p grip_torque:
/// Motion/Grip torque [N m].
std::string grip_holds_note(double grip_torque, const ring::Answer &row);

/// Results of a study in addition to the answer and its curves.
enum class Depth
{
  answer, ///< rows of all harmonics and of the first only
  rows,   ///< rows by harmonics and other models
  full    ///< also torques, one ring, budget, leave-one-out
};

/// Returns an observer that reports torque evaluations and time to @p progress, at most ten times a second.
ring::TimeObserver motion_observer(Progress &progress);

/// Returns @p asked with motion, grip and contact radius of @p study.
ring::Question spin_question(const Study &study, ring::Question asked = {});

/// Returns the answers of @p variants to @p asked. @p foot as in solve(); @p of_study: load of variants with
/// Shared::load. Rows of the chain have torques at @p torque_spins. Failures of meshes, contacts, balances
/// and spins do not throw: the row has the reason. The progress of @p executor receives the finished models.
std::vector<LoadedRow> solve_rows(const std::vector<Variant> &variants,
                                  const std::shared_ptr<ElasticFoot> &foot, const ring::Question &asked,
                                  const Executor &executor, const std::optional<ring::Load> &of_study = {},
                                  const std::vector<double> &torque_spins = {});

/// Returns the row of a variant whose load failed with @p failure.
ring::Answer failed_row(const std::exception_ptr &failure);

/// Returns the numbers of harmonics of the rows: 1, 2, 3, 4, 6, 8, 12, 16, ... below @p n_all, then @p n_all.
std::vector<unsigned int> truncation_orders(unsigned int n_all);

/// Returns the rows for truncation_orders() of @p load, find_load() of the analysed study; all harmonics
/// last. Fewer harmonics have their own balance if the load is two-way, else the truncated load; each row is
/// compared with the last. Only the rows of one and of all harmonics are solved with Depth::answer, and for
/// slow balances (solid body, waviness). Depth::full adds LoadedRow::torques. @p others are
/// solved with the rows, so that no thread idles. Throws as @p load, and if all harmonics have no answer; if
/// the glass tips during the spin-up, the last row has a `fall`, and no row is compared with it.
StudyRows rows_by_harmonics(const Analysis &analysis, const ring::Load &load, Depth depth = Depth::full,
                            const std::vector<Variant> &others = {});

} // namespace stemware::pipeline
