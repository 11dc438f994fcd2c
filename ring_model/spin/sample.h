#pragma once

#include "ring_model/load/ring_stack.h"

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace stemware::ring
{
/// Load on the rings at one spin, the tilt of the glass, and the margins of the balance.
struct Sample : RingStack
{
  Sample(RingStack rings, const Eigen::Vector2d &tilt = Eigen::Vector2d::Zero()) // NOLINT
      : RingStack(std::move(rings))
      , tilt(tilt)
  {
  }

  /// (q1, q2): tilts of the table in the frame of the glass, whose axis tilts by (-q1, -q2) [rad]; 0 if the
  /// moment balance neglects the tilt.
  Eigen::Vector2d tilt;
  /// Margin to lift-off: minimum of the pointwise load over a_0; after lift-off negative, estimated from the
  /// free arc by the first harmonic. 1 if unknown.
  double lift_off_margin = 1.;
  double stability_margin = 1.; ///< SpinSearch::stability_margin; 1 if unknown

  /// Returns the moment of the normal forces about the tilted axis, -q1 M_Nx - q2 M_Ny [N m], which adds to
  /// tau_z (docs/theory/closures.md).
  double lean_torque() const { return -tilt.dot(moment()); }

  /// Returns the tilt and, ring by ring, r_j, a_{j,0}...a_{j,n}, b_{j,0}...b_{j,n} with n = @p n_harmonics,
  /// padded with zeros. Rows of equal length may be added and interpolated.
  Eigen::VectorXd coefficients(unsigned int n_harmonics) const
  {
    const Eigen::Index n_a = n_harmonics + 1, n_kept = std::min<Eigen::Index>(n_a, this->n_harmonics() + 1),
                       width = 2 * n_a + 1;
    Eigen::VectorXd row = Eigen::VectorXd::Zero(2 + width * static_cast<Eigen::Index>(rings().size()));
    row.head<2>() = tilt;
    Eigen::Index begin = 2;
    for (const Ring &ring : rings())
    {
      row(begin) = ring.radius;
      row.segment(begin + 1, n_kept) = Eigen::Map<const Eigen::VectorXd>(ring.a.data(), n_kept);
      row.segment(begin + 1 + n_a, n_kept) = Eigen::Map<const Eigen::VectorXd>(ring.b.data(), n_kept);
      begin += width;
    }
    return row;
  }
  /// Returns the load of @p n_rings rings whose coefficients() are @p row, with unknown margins.
  static Sample from_coefficients(const Eigen::VectorXd &row, std::size_t n_rings)
  {
    const Eigen::Index width = (row.size() - 2) / static_cast<Eigen::Index>(n_rings), n_a = width / 2;
    std::vector<Ring> rings;
    for (const double *ring = row.data() + 2; ring != row.data() + row.size(); ring += width)
      rings.push_back({ *ring, { ring + 1, ring + 1 + n_a }, { ring + 1 + n_a, ring + width } });
    return { RingStack(std::move(rings)), row.head<2>() };
  }

  /// Returns the load without its harmonics above @p n_harmonics, with the same tilt and margins.
  Sample truncated(unsigned int n_harmonics) const
  {
    Sample kept = *this;
    static_cast<RingStack &>(kept) = RingStack::truncated(n_harmonics);
    return kept;
  }
};
} // namespace stemware::ring
