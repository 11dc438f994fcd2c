#pragma once

#include "fem/geometry/elastic_material.h"

#include <Eigen/Core>

#include <array>

namespace stemware::fem
{

/// Element stiffness of the displacement harmonics u_r cos(n theta), u_theta sin(n theta), u_z cos(n theta)
/// (docs/method/revolution.md, "Harmonics").
///
/// The strains are combinations of three fields of a shape function N: dN/dr, dN/dz and N/r. The stiffness of
/// every harmonic therefore follows from the integrals of products of these fields.
class HarmonicStiffness
{
public:
  static constexpr Eigen::Index n_fields = 3;

  explicit HarmonicStiffness(const ElasticMaterial &material);

  /// Returns K_0, K_1 and K_2 of K_n = K_0 + n K_1 + n^2 K_2 for m shape functions: row 3 i + c is
  /// component c (r, theta, z) of function i. @p products: integrals of field p of function i times field q
  /// of function j in row p m + i, column q m + j, shape [3 m, 3 m].
  std::array<Eigen::MatrixXd, 3> parts(const Eigen::MatrixXd &products) const;

private:
  /// Stiffness between components c and d for each product of fields p and q: [part][c][d](p, q).
  std::array<std::array<std::array<Eigen::Matrix3d, 3>, 3>, 3> coefficients;
};

} // namespace stemware::fem
