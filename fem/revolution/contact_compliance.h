#pragma once

#include "fem/geometry/elastic_material.h"

#include <Eigen/Core>

#include <limits>
#include <utility>
#include <vector>

namespace stemware::fem
{

/// Returns first index and number of the nodes of the elements that overlap the band from @p inner to @p
/// outer; at least one element. @p radii: of all nodes [m]; @p degree: of the elements.
std::pair<Eigen::Index, Eigen::Index> nodes_between(const Eigen::VectorXd &radii, Eigen::Index degree,
                                                    double inner, double outer);

/// Vertical displacement of the contact nodes of a body of revolution under line forces of one harmonic n:
/// f_z cos(n theta), f_r cos(n theta), f_theta sin(n theta) [N/rad] give u_z cos(n theta) with u_z = normal
/// f_z + radial f_r + azimuthal f_theta [m]; likewise (sin, sin, -cos). Shapes [n_nodes, n_nodes], m rad/N.
struct HarmonicCompliance
{
  Eigen::MatrixXd normal;
  Eigen::MatrixXd radial;
  Eigen::MatrixXd azimuthal;

  HarmonicCompliance &operator+=(const HarmonicCompliance &other)
  {
    normal += other.normal;
    radial += other.radial;
    azimuthal += other.azimuthal;
    return *this;
  }

  /// Returns the compliance for forces on nodes @p first ... @p first + @p size - 1 only.
  HarmonicCompliance part(Eigen::Index first, Eigen::Index size) const
  {
    const auto block = [&](const auto &matrix) { return matrix.block(first, first, size, size); };
    return { block(normal), block(radial), block(azimuthal) };
  }
};

/// Response of the contact circles of a body of revolution to forces on them, harmonic by harmonic.
struct ContactCompliance
{
  Eigen::VectorXd radii;                     ///< radii of the contact nodes, ascending [m]
  unsigned int degree = 0;                   ///< degree of the displacement along r within an element
  std::vector<HarmonicCompliance> harmonics; ///< n = 0 ... n_harmonics()
  HarmonicCompliance tail;                   ///< of all higher harmonics, MeridianOptions::tail_harmonic()
  unsigned int n_meridian_unknowns = 0;      ///< degrees of freedom of one meridional problem
  Eigen::Index n_inside = 0;  ///< for a part(): number of the land's contact nodes inside the first node
  Eigen::Index n_outside = 0; ///< likewise outside the last one

  unsigned int n_nodes() const { return static_cast<unsigned int>(radii.size()); }
  unsigned int n_harmonics() const { return static_cast<unsigned int>(harmonics.size()) - 1; }

  /// Returns the nodes' shape functions at @p radius, extrapolated outside the contact zone. Shape [n_nodes].
  Eigen::VectorXd shape_at(double radius) const;

  /// Returns @p values (one row per node) extended by zeros to all nodes of the land.
  Eigen::MatrixXd extended_to_land(const Eigen::MatrixXd &values) const;

  /// Returns the compliance for forces on nodes @p first ... @p first + @p size - 1 only, whole elements.
  ContactCompliance part(Eigen::Index first, Eigen::Index size) const;

  /// Returns the compliance without the response to friction tractions.
  ContactCompliance without_friction() const { return times(1, 0); }

  /// Returns all compliances times @p factor: a body with 1 / @p factor of the Young modulus.
  ContactCompliance scaled(double factor) const { return times(factor, factor); }

  /// Returns the compliance of a similar body, @p ratio times as large.
  ContactCompliance similar(double ratio) const
  {
    ContactCompliance result = scaled(1 / ratio);
    result.radii *= ratio;
    return result;
  }

  /// Adds the compliances of @p other, the body below (z upward in both). Throws std::invalid_argument unless
  /// nodes, degree and number of harmonics agree.
  ContactCompliance &operator+=(const ContactCompliance &other);

private:
  /// Returns the compliances scaled by one factor for normal forces and by another for tractions.
  ContactCompliance times(double of_normal, double of_friction) const;
};

/// Numerical parameters of the meridional problems.
struct MeridianOptions
{
  unsigned int degree = 2;       ///< degree of the elements, 1 to 4
  unsigned int n_harmonics = 16; ///< highest harmonic of the elastic response
  /// Radii between which whole elements of the land are kept [m]; no forces outside.
  double inner_radius = 0;
  double outer_radius = std::numeric_limits<double>::infinity();

  /// Returns the harmonic that represents all harmonics above n_harmonics: half an octave higher.
  unsigned int tail_harmonic() const { return n_harmonics + (n_harmonics + 1) / 2; }
};

} // namespace stemware::fem
