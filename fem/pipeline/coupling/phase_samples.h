#pragma once

#include "fem/pipeline/coupling/leaning_load.h"
#include "fem/pipeline/coupling/orientation.h"
#include "fem/pipeline/coupling/periodic_grid.h"

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace stemware::pipeline
{

/// Phases of glass and table at which a load is sampled: every node of one angle with every node of the
/// other, the table's running fastest.
struct PhaseGrids
{
  using Angle = PeriodicGrid PhaseGrids::*;

  PeriodicGrid glass;
  PeriodicGrid table;

  unsigned int size() const { return glass.size() * table.size(); }
  ring::Orientation phase(unsigned int i) const;
  /// Number of the node of one angle that phase @p i stands on.
  unsigned int node(Angle angle, unsigned int i) const;
  /// The same with every other node of one angle.
  PhaseGrids halved(Angle angle) const;
  /// Weights of the phases in the interpolant at @p phase. Shape [size()].
  Eigen::VectorXd weights(const ring::Orientation &phase) const;
};

/// How far apart two loads are as friction sees them: the largest difference of tau_z over mu N R among the
/// slip ratios 0, +-1/4 ... +-1, R the ring radius of @p other. Harmonics count as much as they turn the
/// glass: those of a load that is gathered at crests reach far up, where the kernels have vanished.
double torque_difference(const LeaningLoad &one, const LeaningLoad &other);

/// Errors of a load that is sampled, torque_difference().
struct SampleError
{
  double mean = 0;    ///< of its mean
  double between = 0; ///< largest between samples
};

/// The load at one spin, or a sum of such, sampled at phases.
class PhaseSamples
{
public:
  /// @p columns has one column per phase of @p grids: LeaningLoad::coefficients() of @p n_rings rings.
  PhaseSamples(const PhaseGrids &grids, const Eigen::MatrixXd &columns, std::size_t n_rings);

  const PhaseGrids &phases() const { return grids; }
  const Eigen::MatrixXd &columns() const { return loads; }
  std::size_t n_rings() const { return rings_per_load; }

  /// The load at phase @p i, and by trigonometric interpolation at any.
  LeaningLoad sample(unsigned int i) const { return load_of(loads.col(i)); }
  LeaningLoad at(const ring::Orientation &phase) const { return load_of(loads * grids.weights(phase)); }

  /// Mean over all phases, the trapezoidal rule. It carries the mean moment.
  LeaningLoad mean() const;

  /// Error in one angle, as the samples tell it. Of the mean: what half of the phases say otherwise; between:
  /// what half and a quarter of them leave at the others, extrapolated to all.
  SampleError error(PhaseGrids::Angle angle) const;
  /// Error in both angles: the sum of those of the mean, the larger of those between.
  SampleError error() const;

private:
  LeaningLoad load_of(const Eigen::VectorXd &column) const;
  PhaseSamples halved(PhaseGrids::Angle angle) const;
  /// Largest torque_difference() that half of the phases of an angle leave at the others.
  double error_of_half(PhaseGrids::Angle angle) const;

  PhaseGrids grids;
  Eigen::MatrixXd loads;
  std::size_t rings_per_load;
};

} // namespace stemware::pipeline
