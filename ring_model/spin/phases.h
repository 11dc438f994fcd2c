#pragma once

#include "ring_model/load/slip.h"
#include "ring_model/motion.h"
#include "ring_model/spin/sample.h"

#include <Eigen/Core>

#include <cstddef>

namespace stemware::ring
{

/// Returns the azimuths of the marks of glass and table in the slip frame at @p time t [s] and @p yaw_angle
/// psi [rad]: theta = chi + psi - phi -/+ pi/2 and theta = chi - phi -/+ pi/2 with the orbit angle phi = +/-
/// v t / rho; upper signs: counter-clockwise orbit.
Orientation orientation_of_marks(const Motion &motion, double time, double yaw_angle);

/// Periods [rad] of the load in the angles of glass and table; 0 for a perfect surface.
struct PhasePeriods
{
  double glass = 0;
  double table = 0;

  bool any() const { return glass > 0 || table > 0; }
};

/// Trigonometric interpolation on equidistant nodes over one period of an angle; one node: a constant.
class PeriodicGrid
{
public:
  /// @p period > 0 [rad]; @p n_nodes is 1 or even.
  PeriodicGrid(double period, unsigned int n_nodes);

  unsigned int size() const { return n_nodes; }
  double node(unsigned int i) const { return period * i / n_nodes; }
  PeriodicGrid refined() const { return PeriodicGrid(period, 2 * n_nodes); }
  /// Returns the grid with half the nodes, at least one.
  PeriodicGrid halved() const;
  /// Returns the weights of the nodes' values in the interpolant at @p angle. Shape [size()].
  Eigen::VectorXd weights(double angle) const;

private:
  double period;
  unsigned int n_nodes;
  /// Cosine and sine of half the nodes' angles, scaled to a full circle; shape [size()].
  Eigen::ArrayXd cosine, sine;
};

/// Grid of phases at which a load is sampled: all pairs of nodes of both angles, the table's running fastest.
struct PhaseGrids
{
  using Angle = PeriodicGrid PhaseGrids::*;

  PeriodicGrid glass;
  PeriodicGrid table;

  unsigned int size() const { return glass.size() * table.size(); }
  Orientation phase(unsigned int i) const;
  /// Returns the index of the node of one angle at phase @p i.
  unsigned int node(Angle angle, unsigned int i) const;
  /// Returns the weights of the phases in the interpolant at @p phase. Shape [size()].
  Eigen::VectorXd weights(const Orientation &phase) const;
};

/// Returns the distance of two loads: largest difference of tau_z over mu N R (R: ring radius of @p other) at
/// the slip ratios 0, +-1/4 ... +-1. High harmonics count only by their effect on the torque.
double torque_difference(const Sample &one, const Sample &other);

/// Errors of a sampled load, measured by torque_difference().
struct SampleError
{
  double mean = 0;    ///< error of the mean load
  double between = 0; ///< largest error between samples
};

/// Load at one spin, or a sum of loads, sampled at phases.
class PhaseSamples
{
public:
  /// @p columns: Sample::coefficients() of @p n_rings rings, one column per phase of @p grids.
  PhaseSamples(const PhaseGrids &grids, const Eigen::MatrixXd &columns, std::size_t n_rings);

  const PhaseGrids &phases() const { return grids; }
  const Eigen::MatrixXd &columns() const { return loads; }
  std::size_t n_rings() const { return rings_per_load; }

  /// Returns the load at phase @p i, or at any phase by trigonometric interpolation.
  Sample sample(unsigned int i) const { return load_of(loads.col(i)); }
  Sample at(const Orientation &phase) const;

  /// Returns the mean over all phases (trapezoidal rule), which has the mean moment.
  Sample mean() const;

  /// Estimates the errors in one angle from the means over half and a quarter of the phases, and from the
  /// interpolation between them, extrapolated to all phases.
  SampleError error(PhaseGrids::Angle angle) const;
  /// Returns the error in both angles: the sum of errors of the mean, the larger error between phases.
  SampleError error() const;

private:
  Sample load_of(const Eigen::VectorXd &column) const
  {
    return Sample::from_coefficients(column, rings_per_load);
  }
  /// Returns the samples at every other node of one angle.
  PhaseSamples halved(PhaseGrids::Angle angle) const;
  /// Returns the largest torque_difference() of every other phase of an angle to its interpolation.
  double error_of_half(PhaseGrids::Angle angle) const;

  PhaseGrids grids;
  Eigen::MatrixXd loads;
  std::size_t rings_per_load;
};

} // namespace stemware::ring
