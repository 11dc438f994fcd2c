#pragma once

#include "ring_model/load/slip.h"
#include "ring_model/motion.h"
#include "ring_model/spin/leaning_load.h"

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace stemware::ring
{

/// Returns the azimuths of the marks of glass and table in the slip frame at @p time, the glass having yawed
/// by @p yaw_angle since t = 0: theta = chi + psi - phi -/+ pi/2 and theta = chi - phi -/+ pi/2 with the
/// orbit angle phi = +/- v t / rho, upper signs for a counter-clockwise orbit.
Orientation orientation_of_marks(const Motion &motion, double time, double yaw_angle);

/// The periods [rad] with which the load repeats itself when glass or table turn; 0 for a perfect surface.
struct PhasePeriods
{
  double glass = 0;
  double table = 0;

  bool any() const { return glass > 0 || table > 0; }
};

/// Equidistant nodes over one period of an angle, with the trigonometric interpolation between them. One node
/// stands for a function that does not depend on the angle.
class PeriodicGrid
{
public:
  /// @p period > 0 [rad]; @p n_nodes is 1 or even.
  PeriodicGrid(double period, unsigned int n_nodes);

  unsigned int size() const { return n_nodes; }
  double node(unsigned int i) const { return period * i / n_nodes; }
  double step() const { return period / n_nodes; }
  PeriodicGrid refined() const { return PeriodicGrid(period, 2 * n_nodes); }
  /// Returns the grid with half the nodes; one remains one.
  PeriodicGrid halved() const;
  /// Returns the grid with every so many-th node that at most @p max_nodes are left, a power of two.
  PeriodicGrid coarsened(unsigned int max_nodes) const;
  /// Weights of the nodes' values in the interpolant at @p angle. Shape [size()].
  Eigen::VectorXd weights(double angle) const;

private:
  double period;
  unsigned int n_nodes;
  Eigen::ArrayXd cosine, sine; ///< of half the nodes' angles, as parts of a full circle. Shape [size()].
};

/// Chebyshev points on an interval of spins, both ends included, with the polynomial interpolation between
/// them.
class ChebyshevInterval
{
public:
  /// n_steps + 1 points on [lower, upper] [rad/s].
  ChebyshevInterval(double lower, double upper, unsigned int n_steps);

  unsigned int size() const { return n_steps + 1; }
  double node(unsigned int i) const { return at(i); }
  std::vector<double> nodes() const;
  /// Weights of the nodes' values in the interpolant at @p omega. Shape [size()].
  Eigen::VectorXd weights(double omega) const;

  /// The points halfway between the nodes: what refined() adds.
  std::vector<double> between() const;
  ChebyshevInterval refined() const { return ChebyshevInterval(lower, upper, 2 * n_steps); }

private:
  double at(double place) const;

  double lower, upper;
  unsigned int n_steps;
};

/// Phases of glass and table at which a load is sampled: every node of one angle with every node of the
/// other, the table's running fastest.
struct PhaseGrids
{
  using Angle = PeriodicGrid PhaseGrids::*;

  PeriodicGrid glass;
  PeriodicGrid table;

  unsigned int size() const { return glass.size() * table.size(); }
  Orientation phase(unsigned int i) const;
  /// Number of the node of one angle that phase @p i stands on.
  unsigned int node(Angle angle, unsigned int i) const;
  /// The same with every other node of one angle.
  PhaseGrids halved(Angle angle) const;
  /// Weights of the phases in the interpolant at @p phase. Shape [size()].
  Eigen::VectorXd weights(const Orientation &phase) const;
  /// The column at @p phase between @p columns, of which there is one for each phase.
  Eigen::VectorXd interpolated(const Eigen::MatrixXd &columns, const Orientation &phase) const;
};

/// Returns the distance of two loads as friction sees them: the largest difference of tau_z over mu N R among
/// the slip ratios 0, +-1/4 ... +-1, R the ring radius of @p other. Harmonics count as much as they turn the
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
  LeaningLoad at(const Orientation &phase) const { return load_of(grids.interpolated(loads, phase)); }

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

} // namespace stemware::ring
