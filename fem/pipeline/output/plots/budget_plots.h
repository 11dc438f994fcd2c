#pragma once

#include "fem/pipeline/analysis/budget.h"
#include "fem/pipeline/output/render/report.h"

/// The plots of the budget of effects.
namespace stemware::pipeline
{

/// From the paper's terminal spin to the study's: a bar for each named difference, faster and slower in
/// different colours, its size beside it; the rows of the harmonics make one bar. Error bands as whiskers.
/// Numbers below @p rounding [rad/s] are 0.
Plot waterfall_plot(const Budget &budget, double rounding);

/// Sizes of all differences on a logarithmic scale: the steps of the chain, and below them what leaving out
/// one thing changes, beside the error band of the last row. What is smaller than @p rounding [rad/s] is 0,
/// and not drawn. The budget must have a row.
Plot effects_plot(const Budget &budget, double rounding);

/// tau_z(omega) of all harmonics and of the first alone, and below it what the harmonics beyond the first
/// add.
Plot harmonic_torque_plot(const Budget &budget);

/// @p plot with a remark in it and at the end of its caption: the load is the one of rest at every spin.
Plot one_way(Plot plot);

} // namespace stemware::pipeline
