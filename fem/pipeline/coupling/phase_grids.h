#pragma once

#include "fem/pipeline/coupling/orientation.h"
#include "fem/pipeline/coupling/periodic_grid.h"

#include <Eigen/Core>

namespace stemware::pipeline
{

/// Phases of glass and table at which a load is sampled.
struct PhaseGrids
{
  PeriodicGrid glass;
  PeriodicGrid table;
  PhasePeriods periods;  ///< with which the load repeats itself
  double error = 0;      ///< of the load at rest between them, torque_difference()
  double mean_error = 0; ///< of the mean of the load at rest

  /// Whether the samples are taken without what turns with the crests (PhaseLoads).
  bool turning = false;

  unsigned int size() const { return glass.size() * table.size(); }
  ring::Orientation phase(unsigned int i) const;

  /// The angle with which the crests turn that a load goes with: the glass's, where it is wavy, else the
  /// table's; its period [rad], 0 where samples are taken as they are; and its number of samples.
  double turning_angle(const ring::Orientation &phase) const;
  double turning_period() const;
  unsigned int n_turning_phases() const;
  PhaseGrids halved() const; ///< with half the phases of each angle
  /// Weights of the phases in the interpolant at @p phase. Shape [size()].
  Eigen::VectorXd weights(const ring::Orientation &phase) const;
};

} // namespace stemware::pipeline
