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

/// Cells of a mesh that are halved, by their numbers among the active ones.
struct MarkedCells
{
  std::vector<unsigned int> foot;
  std::vector<unsigned int> disc; ///< of an elastic table
};

/// Error of a number asked of a solved contact that is due to the mesh, to first order.
struct MeshError
{
  double correction = 0; ///< added to the number it gives that of the exact displacement, as estimated
  /// Shares of the mesh's cells in it, all >= 0, by active cell: what to halve first. Of the foot, and of the
  /// disc under it where there is one.
  std::vector<double> foot_cells;
  std::vector<double> disc_cells;

  /// The fewest cells that have @p share of the sum of all shares, and those with as much as the last of
  /// them: rings of equal cells stay whole.
  MarkedCells mark(double share) const;
};

} // namespace stemware::fem
