#pragma once

#include "ring_model/load/ring_stack.h"

#include <Eigen/Core>

#include <cstddef>
#include <utility>
#include <vector>

namespace stemware::ring
{
/// The load on the rings at one spin, and how the glass leans under it.
struct LeaningLoad : RingStack
{
  LeaningLoad(RingStack rings, const Eigen::Vector2d &tilt = Eigen::Vector2d::Zero()) // NOLINT
      : RingStack(std::move(rings))
      , tilt(tilt)
  {
  }

  /// (q1, q2): the table's tilts in the frame of the glass, whose axis leans by (-q1, -q2) [rad]; 0 where the
  /// tilt is left out of the moment balance.
  Eigen::Vector2d tilt;

  /// Moment of the normal forces about the leaning axis, -q1 M_Nx - q2 M_Ny [N m]: it turns the glass as
  /// tau_z does (docs/theory/closures.md).
  double lean_torque() const { return -tilt.dot(moment()); }

  /// All numbers in a row, RingStack::coefficients() and the tilt: rows of equally many rings and harmonics
  /// may be added and interpolated.
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
