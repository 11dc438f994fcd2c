#pragma once

#include "ring_model/spin/answer.h"

namespace stemware::ring
{
/// Computes Answer::all_spins under @p load; contains the terminal spin of @p found.
std::vector<TerminalSpin> all_terminal_spins(const LoadAtSpin &load, const Question &question,
                                             const Answer &found);

/// Returns @p torque plus grip_torque() at the spin @p omega [rad/s] [N m].
double torque_with_grip(double torque, double omega, double grip);
} // namespace stemware::ring
