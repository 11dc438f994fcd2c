#pragma once

#include "fem/contact/compliant_body.h"
#include "fem/revolution/elastic_response.h"
#include "fem/revolution/line_newton.h"

#include <functional>
#include <memory>
#include <optional>

namespace stemware::fem
{

/// Elastic foot that is a body of revolution, and the table under it (docs/method/revolution.md). Contact
/// nodes are the crossings of its contact circles with n_lines azimuth lines, node j * n_radii + i on circle
/// i and line j. Copies have their own state and share the contact surface.
class BodyOfRevolution : public CompliantBody
{
public:
  /// Distance of the undeformed contact zone from a plane table at (r, theta) [m].
  using Gap = std::function<double(double radius, double azimuth)>;

  /// @p compliance: of foot and elastic table. @p gap must be quadratic in r, as contact lines are (two per
  /// element of degree 3 or 4). Throws std::invalid_argument if @p n_lines is too small for the harmonics.
  BodyOfRevolution(ContactCompliance compliance, const Gap &gap, unsigned int n_lines = 256);

  /// Sets another gap over the same circles, also for copies (rotating waviness). Keeps the state.
  void set_gap(const Gap &gap);

  /// Sets the friction that deforms the foot; keeps the state. Throws as SlidingTraction::validate().
  void set_sliding(const std::optional<SlidingTraction> &traction);

  const ContactSurface &contact_surface() const override { return *surface; }
  NewtonIncrement solve(const Eigen::SparseMatrix<double> &tangent, const Eigen::VectorXd &forces,
                        const LinearConditions &conditions, const Eigen::Vector3d &motion) override;

  const ElasticResponse &elastic_response() const { return response; }
  const FourierBasis &fourier_basis() const { return response.basis(); }
  const ContactCompliance &contact_compliance() const { return response.compliance(); }

  /// Returns mean and tilts of the displacement of circle @p i under the forces, as a table motion.
  Eigen::Vector3d motion_of_circle(Eigen::Index i) const;

  /// Returns the nodal forces of the state [N], shape [n_radii, n_lines].
  Eigen::MatrixXd forces() const { return on_lines(state); }

private:
  /// Returns the contact surface without gaps.
  std::shared_ptr<ContactSurface> lines() const;
  Eigen::VectorXd response_to(const Eigen::VectorXd &forces) const override;
  /// Returns nodal @p values in the shape [n_radii, n_lines].
  Eigen::MatrixXd on_lines(const Eigen::VectorXd &values) const
  {
    return values.reshaped(response.n_radii(), response.n_lines());
  }

  ElasticResponse response;
  std::shared_ptr<ContactSurface> surface;
  SmoothFunctions functions; ///< functions of the last solve()
};

} // namespace stemware::fem
