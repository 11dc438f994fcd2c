#pragma once

#include "fem/contact/sliding_traction.h"
#include "fem/revolution/contact_compliance.h"
#include "fem/revolution/fourier_basis.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace stemware::fem
{

/// Modes of forces on the contact circles, sum_j f_j mode(theta_j) [N], each of shape [n_radii, n_modes].
struct ForceModes
{
  Eigen::MatrixXd normal;
  Eigen::MatrixXd radial;    ///< empty without friction, `azimuthal` too
  Eigen::MatrixXd azimuthal; ///< projected onto the conjugates of the modes
};

/// Displacement of the contact circles of foot and table under normal forces on the azimuth lines and the
/// friction of these forces (docs/method/revolution.md, "Harmonics and lines").
///
/// Harmonic n has the compliance C_n up to n_harmonics(). Higher harmonics, resolved by the lines only, share
/// ContactCompliance::tail, the compliance of line contact, in which a line responds to its own force only:
///
///   u_j = D f_j + sum_{n <= n_max} (C_n - C_tail) f_n cos n(theta - theta_n) ...,  D = C_tail n_lines /
///   2 pi,
///
/// positive definite on every line for any number of lines. Friction tractions t = s f with the sliding
/// direction s(r, theta) add C^zr and, up to n_max, C^ztheta. Shapes on lines: [n_radii, n_lines].
class ElasticResponse
{
public:
  /// @p compliance: of foot and table. Throws std::invalid_argument if @p n_lines is too small.
  ElasticResponse(ContactCompliance compliance, unsigned int n_lines);

  /// Sets the friction that deforms the bodies, or none. Throws as SlidingTraction::validate.
  void set_sliding(const std::optional<SlidingTraction> &traction);
  bool has_sliding() const { return slide_radial.size() > 0; }

  const FourierBasis &basis() const { return modes; }
  const ContactCompliance &compliance() const { return circles; }
  unsigned int n_radii() const { return circles.n_nodes(); }
  unsigned int n_lines() const { return modes.n_lines(); }

  /// Returns the radial and azimuthal force per normal force. Empty without friction.
  const Eigen::MatrixXd &radial_traction() const { return slide_radial; }
  const Eigen::MatrixXd &azimuthal_traction() const { return slide_azimuthal; }

  /// Returns u_z under the normal @p forces [N] and their friction [m].
  Eigen::MatrixXd displacement(const Eigen::MatrixXd &forces) const;

  /// Returns the harmonics up to n_max of the forces on the circles from @p first on.
  ForceModes force_modes(const Eigen::MatrixXd &forces, Eigen::Index first = 0) const;

  /// Returns n_lines / 2 pi, the factor of C_tail in D.
  double lines_per_radian() const { return n_lines() / FourierBasis::norm(0); }

  /// Returns C_n - C_tail on a range of circles; the azimuthal part is C_n itself.
  HarmonicCompliance difference(unsigned int harmonic, Eigen::Index first, Eigen::Index size) const
  {
    return differences[harmonic].part(first, size);
  }

private:
  ContactCompliance circles;
  std::vector<HarmonicCompliance> differences; ///< C_n - C_tail; the azimuthal part is C_n itself
  FourierBasis modes;
  Eigen::MatrixXd slide_radial; ///< shape [n_radii, n_lines]
  Eigen::MatrixXd slide_azimuthal;
};

} // namespace stemware::fem
