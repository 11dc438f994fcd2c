#pragma once

#include "ring_model/motion.h"
#include "ring_model/spin/load_at_spin.h"
#include "ring_model/spin/phase_loads.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace stemware::ring
{

/// Torque of friction and lean on a glass whose load depends on the phase, for integrators, which ask some
/// hundred thousand times next to one spin. The torque at each sampled phase is a polynomial in the spin;
/// between phases it is interpolated as the load is, on which it depends linearly.
class PhaseTorque
{
public:
  /// Tabulates the torque of @p load, which has phases(), at spins up to @p reach [rad/s] from @p middle, as
  /// far as the load is known around it (PhaseSampledLoad::polynomial_range()).
  /// If polynomials leave more than @p tolerance [N m], as across the spin v / R of a ring, at which the
  /// torque has a kink, half of @p reach is tried, and a quarter; then there is no table. @p load and @p
  /// motion are kept by reference.
  PhaseTorque(const LoadAtSpin &load, const Motion &motion, double middle, double reach, double tolerance);

  /// Returns the torque [N m] at a time [s], yaw angle [rad] and spin [rad/s]: from the table if it covers
  /// the spin, else from the load itself.
  double operator()(double time, double yaw_angle, double omega) const;

  /// Returns whether the torque was tabulated.
  bool is_tabulated() const { return spins.has_value(); }

private:
  /// Makes the table from `lower` to `upper`, unless polynomials leave more than @p tolerance [N m].
  void tabulate(double tolerance);
  /// Torques at all phases. Shape [number of phases, number of spins].
  Eigen::MatrixXd at_phases(const std::vector<double> &omegas) const;

  const LoadAtSpin &load;
  const Motion &motion;
  const PhaseGrids &grids;
  double lower = 0., upper = 0.; ///< spins of the table
  std::optional<ChebyshevInterval> spins;
  Eigen::MatrixXd table; ///< [number of phases, number of spins]
};

} // namespace stemware::ring
