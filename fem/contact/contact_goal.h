#pragma once

#include "ring_model/load/load_functional.h"

#include <Eigen/Core>

#include <vector>

namespace stemware::fem
{

/// A number that is asked of a contact, to first order in what changes it: dJ = of_load(d load) + of_moment'
/// (dM_Nx, dM_Ny) + of_motion' dq. J has any unit [J].
struct ContactGoal
{
  std::vector<double> ring_radii;                      ///< on which the load is gathered, ascending [m]
  ring::LoadFunctional of_load;                        ///< [J rad/N]
  Eigen::Vector2d of_moment = Eigen::Vector2d::Zero(); ///< [J/(N m)]
  Eigen::Vector3d of_motion = Eigen::Vector3d::Zero(); ///< of the table motions [J/m, J/rad, J/rad]
};

/// Error of a number asked of a solved contact that is due to the mesh, to first order.
struct MeshError
{
  double correction = 0; ///< added to the number it gives that of the exact displacement, as estimated
  /// Shares of the mesh's cells in it, all >= 0, by active cell: what to halve first.
  std::vector<double> cells;

  /// Numbers of the fewest cells that have @p share of the sum of all shares, and of those with as much as
  /// the last of them: rings of equal cells stay whole.
  std::vector<unsigned int> mark(double share) const;
};

} // namespace stemware::fem
