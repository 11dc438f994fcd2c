#pragma once

#include "fem/contact/elastic_body.h"
#include "fem/contact/sliding_traction.h"
#include "fem/revolution/contact_compliance.h"
#include "fem/revolution/fourier_basis.h"
#include "fem/revolution/harmonic_newton.h"
#include "fem/revolution/line_tangents.h"

#include <functional>
#include <optional>

namespace stemware::fem
{

/// Modes of the normal, radial and azimuthal forces on the contact circles, sum_j f_j mode(theta_j) [N], each
/// of shape [n_radii, n_modes].
struct ForceModes
{
  Eigen::MatrixXd normal;
  Eigen::MatrixXd radial;    ///< empty without friction, `azimuthal` too
  Eigen::MatrixXd azimuthal; ///< against the conjugates of the modes
};

/// Elastic foot that is a body of revolution, displacement harmonics as unknowns (docs/method/revolution.md).
///
/// Contact nodes are the crossings of its contact circles with n_lines azimuth lines, node j * n_radii + i on
/// circle i and line j. Its displacement has harmonics up to those of the compliance; the table law, and with
/// it the load, is resolved on the lines.
class BodyOfRevolution : public ElasticBody
{
public:
  /// Distance of the undeformed contact zone from a plane table at (r, theta) [m].
  using Gap = std::function<double(double radius, double azimuth)>;

  /// @p compliance of the foot, with that of an elastic table added if there is one. The penetration is
  /// integrated in closed form where it is a quadratic in r: the gap has to be one, and elements of degree 3
  /// and 4 are cut into two pieces of degree 2. Throws std::invalid_argument when @p n_lines is too small for
  /// the harmonics.
  BodyOfRevolution(ContactCompliance compliance, const Gap &gap, unsigned int n_lines = 256);

  /// Another gap over the same circles: imperfections that turn with the glass or with the ground. Keeps the
  /// state.
  void set_gap(const Gap &gap);

  /// Friction that deforms the foot, or none. Keeps the state as a start for the next contact solution.
  /// Throws as SlidingTraction::validate.
  void set_sliding(const std::optional<SlidingTraction> &traction);

  const ContactSurface &contact_surface() const override { return surface; }
  Eigen::VectorXd contact_displacement() const override;
  NewtonIncrement solve(const Eigen::SparseMatrix<double> &tangent, const Eigen::VectorXd &forces,
                        const LinearConditions &conditions) override;
  void update(double step_length) override;
  void reset() override;
  double equilibrium_residual(const Eigen::VectorXd &forces) const override;
  unsigned int n_unknowns() const override;

  const FourierBasis &fourier_basis() const { return basis; }
  const ContactCompliance &contact_compliance() const { return compliance; }

  /// contact_displacement() as amplitudes of the modes on the contact circles [m], shape [n_radii, n_modes].
  Eigen::MatrixXd contact_displacement_modes() const { return displacement_modes(state); }
  /// The forces whose elastic response is the present displacement.
  const ForceModes &force_modes() const { return state; }

private:
  const ForceModes &modes_of(const Eigen::VectorXd &forces) const;
  ForceModes residual(const Eigen::VectorXd &forces) const;
  Eigen::MatrixXd displacement_modes(const ForceModes &forces) const;
  Eigen::MatrixXd on_circles(const Eigen::MatrixXd &whole, const LineTangents &tangents,
                             const std::vector<unsigned int> &modes) const;
  bool is_even(const LineTangents &tangents, const Eigen::VectorXd &forces,
               const LinearConditions &conditions) const;
  NewtonConditions in_modes(const LinearConditions &conditions, const Eigen::SparseMatrix<double> &tangent,
                            const Eigen::VectorXd &forces, const LineTangents &tangents,
                            const std::vector<unsigned int> &modes) const;
  bool has_sliding() const { return slide_radial.size() > 0; }
  void make_lines();

  ContactCompliance compliance;
  FourierBasis basis;
  ContactSurface surface;
  /// Radial traction per pressure, shape [n_radii, n_lines]; empty without friction.
  Eigen::MatrixXd slide_radial;
  Eigen::MatrixXd slide_azimuthal;
  ForceModes state; ///< forces whose elastic response is the displacement
  ForceModes increment;
  mutable Eigen::VectorXd projected_forces; ///< whose modes are in `projection`
  mutable ForceModes projection;
};

} // namespace stemware::fem
