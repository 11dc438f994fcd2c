#pragma once

#include "fem/pipeline/coupling/balanced_load.h"
#include "ring_model/terminal_spin.h"

#include <vector>

namespace stemware::pipeline
{

/// All spins within 1.5 v / R of rest at which the torques on the glass balance, lowest first, each with its
/// stability; those where the fingers hold the glass at rest included (TerminalSpin::held). Two that lie
/// closer together than v / 32 R may be missed. The search ends on either side where the load has no balance,
/// and at 1.05 v / R where friction brakes under any load from there on. Nothing where the load depends on
/// the phase.
std::vector<ring::TerminalSpin> all_terminal_spins(const BalancedLoad &load, const ring::Motion &motion,
                                                   double grip_torque = 0);

} // namespace stemware::pipeline
