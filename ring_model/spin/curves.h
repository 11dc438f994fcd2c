#pragma once

#include "ring_model/spin/answer.h"
#include "ring_model/spin/load_at_spin.h"

#include <vector>

namespace stemware::ring
{
/// Adds Answer::torques to @p found. A spin without a balance has NaN, and the reason of @p found says why.
void add_torques(const LoadAtSpin &load, const Question &question, Answer &found);

/// Adds all spins, spin-up, instants and torques by phase to @p found, as far as @p question asks for them.
/// Throws as @p load.
void add_curves(const LoadAtSpin &load, const Question &question, Answer &found);

/// Computes Answer::all_spins under @p load; contains the terminal spin of @p found.
std::vector<TerminalSpin> all_terminal_spins(const LoadAtSpin &load, const Question &question,
                                             const Answer &found);

/// Returns @p load, to which @p found is the answer, interpolated in the spin from @p lower to @p upper
/// [rad/s], or to the fall, for curves of thousands of values. If some spins have no balance: from rest to
/// the terminal spin; exact if that fails too. @p like as in interpolated().
SharedLoad interpolated_for_curves(const SharedLoad &load, const Answer &found, double lower, double upper,
                                   const LoadAtSpin *like = nullptr);

/// Returns 201 equally spaced times from 0 to @p end [s].
std::vector<double> output_times(double end);
} // namespace stemware::ring
