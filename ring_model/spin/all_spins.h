#pragma once

#include "ring_model/spin/answer.h"

namespace stemware::ring
{
/// Computes Answer::all_spins under @p load; contains the terminal spin of @p found.
std::vector<TerminalSpin> all_terminal_spins(const LoadAtSpin &load, const Question &question,
                                             const Answer &found);
} // namespace stemware::ring
