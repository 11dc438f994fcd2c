#pragma once

#include "ring_model/load/load_functional.h"

#include <Eigen/Core>

#include <vector>

namespace stemware::fem
{

/// Quantity of interest of a contact, linearised: dJ = of_load(d load) + of_moment' (dM_Nx, dM_Ny) +
/// of_motion' dq. [J] stands for the unit of J.
struct ContactGoal
{
  std::vector<double> ring_radii;                      ///< radii of the projected load, ascending [m]
  ring::LoadFunctional of_load;                        ///< [J rad/N]
  Eigen::Vector2d of_moment = Eigen::Vector2d::Zero(); ///< [J/(N m)]
  /// Derivative by the table motions [J/m, J/rad, J/rad].
  Eigen::Vector3d of_motion = Eigen::Vector3d::Zero();
};

/// Discretisation error of a quantity of interest of a solved contact, to first order.
struct MeshError
{
  double correction = 0; ///< estimate of exact minus computed value [J]
  /// Shares of the active cells in the error, >= 0: refinement indicators.
  std::vector<double> cells;

  /// Returns the smallest set of cells with @p share of the total error, with all cells of equal share.
  std::vector<unsigned int> mark(double share) const;
};

} // namespace stemware::fem
