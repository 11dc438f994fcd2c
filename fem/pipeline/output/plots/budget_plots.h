#pragma once

#include "fem/pipeline/analysis/budget.h"
#include "fem/pipeline/output/render/report.h"

#include <optional>

/// The plots of the budget of effects.
namespace stemware::pipeline
{

/// From the paper's terminal spin to the study's: a bar for each named difference, faster and slower in
/// different colours, its size beside it; the rows of the harmonics make one bar. Error bands as whiskers;
/// that of the last row is @p band [rad/s] where it has none of its own.
Plot waterfall_plot(const Budget &budget, const std::optional<double> &band = {});

/// Sizes of all differences on a logarithmic scale: the steps of the chain, and below them what leaving out
/// one thing changes, beside the error band @p band of the terminal spin [rad/s]. What is smaller than
/// @p rounding [rad/s] is not drawn.
Plot effects_plot(const Budget &budget, const std::optional<double> &band, double rounding);

/// tau_z(omega) of all harmonics and of the first alone, and below it what the harmonics beyond the first
/// add.
Plot harmonic_torque_plot(const Budget &budget);

/// @p plot with a remark in it and at the end of its caption: the load is the one of rest at every spin.
Plot one_way(Plot plot);

} // namespace stemware::pipeline
