#pragma once

#include "ring_model/spin/answer.h"

namespace stemware::ring
{
/// Answer::all_spins under @p load, `terminal` of @p found among them.
std::vector<TerminalSpin> all_terminal_spins(const LoadAtSpin &load, const Question &question,
                                             const Answer &found);

/// Sum of @p torque, the spin @p omega [rad/s] and grip_torque() [N m].
double torque_with_grip(double torque, double omega, double grip);
} // namespace stemware::ring
