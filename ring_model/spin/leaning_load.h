#pragma once

#include "ring_model/load/ring_stack.h"

#include <Eigen/Core>

#include <cstddef>
#include <utility>
#include <vector>

namespace stemware::ring
{
/// Load on the rings at one spin, and the tilt of the glass under that load.
struct LeaningLoad : RingStack
{
  LeaningLoad(RingStack rings, const Eigen::Vector2d &tilt = Eigen::Vector2d::Zero()) // NOLINT
      : RingStack(std::move(rings))
      , tilt(tilt)
  {
  }

  /// (q1, q2): tilts of the table in the frame of the glass, whose axis tilts by (-q1, -q2) [rad]; 0 if the
  /// moment balance neglects the tilt.
  Eigen::Vector2d tilt;

  /// Returns the moment of the normal forces about the tilted axis, -q1 M_Nx - q2 M_Ny [N m]; it turns the
  /// glass like tau_z (docs/theory/closures.md).
  double lean_torque() const { return -tilt.dot(moment()); }

  /// Returns RingStack::coefficients() followed by the tilt. Rows of equally many rings and harmonics may be
  /// added and interpolated.
  Eigen::VectorXd coefficients(unsigned int n_harmonics) const
  {
    const std::vector<double> of_rings = RingStack::coefficients(n_harmonics);
    Eigen::VectorXd row(of_rings.size() + 2);
    row << Eigen::Map<const Eigen::VectorXd>(of_rings.data(), row.size() - 2), tilt;
    return row;
  }
  static LeaningLoad from_coefficients(const Eigen::VectorXd &row, std::size_t n_rings)
  {
    return { RingStack::from_coefficients({ row.begin(), row.end() - 2 }, n_rings), row.tail<2>() };
  }

  LeaningLoad truncated(unsigned int n_harmonics) const
  {
    return { RingStack::truncated(n_harmonics), tilt };
  }
};
} // namespace stemware::ring
