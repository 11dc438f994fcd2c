#pragma once

#include "ring_model/motion.h"
#include "ring_model/spin/load.h"
#include "ring_model/spin/phase_loads.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace stemware::ring
{

/// Torque of friction and lean for a load that depends on the phase, tabulated for integrators, which
/// evaluate it some hundred thousand times near one spin. At each sampled phase the torque is a polynomial in
/// the spin; between phases it is interpolated like the load, on which it depends linearly.
class PhaseTorque
{
public:
  /// Tabulates the torque of @p load, which has phases(), for spins within @p reach [rad/s] of @p middle,
  /// limited to the load's PhaseSampledLoad::polynomial_range(). If the polynomials are less accurate than @p
  /// tolerance [N m], as across the kink of the torque at the spin v / R of a ring, half and then a quarter
  /// of @p reach is tried; if both fail there is no table. Keeps references to @p load and @p motion.
  PhaseTorque(const Load &load, const Motion &motion, double middle, double reach, double tolerance);

  /// Returns the torque [N m] at a time [s], yaw angle [rad] and spin [rad/s]: from the table if it covers
  /// the spin, else from the load itself.
  double operator()(double time, double yaw_angle, double omega) const;

  /// Returns whether the torque was tabulated.
  bool is_tabulated() const { return spins.has_value(); }

private:
  /// Makes the table from `lower` to `upper`, unless the polynomials are less accurate than @p tolerance [N
  /// m].
  void tabulate(double tolerance);
  /// Torques at all phases. Shape [number of phases, number of spins].
  Eigen::MatrixXd at_phases(const std::vector<double> &omegas) const;

  const Load &load;
  const Motion &motion;
  const PhaseGrids &grids;
  double lower = 0., upper = 0.; ///< spins of the table
  std::optional<ChebyshevInterval> spins;
  Eigen::MatrixXd table; ///< [number of phases, number of spins]
};

} // namespace stemware::ring
