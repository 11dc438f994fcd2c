#pragma once

#include "ring_model/closures.h"
#include "ring_model/motion.h"

#include <optional>
#include <vector>

namespace stemware::pipeline
{

/// The paper's first-harmonic load under one closure, in balance at every spin: what the choice of moments
/// does to the spin.
struct ClosureRow
{
  ring::Closure closure = ring::Closure::full;
  double tau_at_rest = 0;                         ///< [N m]
  double moment_ratio_at_rest = 0;                ///< above 1 the load is formal: it pulls somewhere
  std::optional<double> omega_terminal;           ///< [rad/s]; nothing where the torque keeps its sign
  std::optional<double> moment_ratio_at_terminal; ///< at omega_terminal

  /// Whether the load is negative somewhere, so that the foot would lift off.
  bool is_formal() const { return moment_ratio_at_rest > 1 || moment_ratio_at_terminal.value_or(0) > 1; }
};

/// The closures paper, hand and full on a ring of radius @p radius [m].
std::vector<ClosureRow> compare_closures(const ring::Motion &motion, double radius);

} // namespace stemware::pipeline
