#pragma once

#include "fem/contact/contact_newton.h"
#include "fem/revolution/body_of_revolution.h"

namespace stemware::fem
{

/// Contact pressure of a pressed body of revolution, anywhere on its contact zone: on the azimuth lines the
/// table law gives it, between them it is interpolated linearly.
class PressureField
{
public:
  /// Takes what it needs of @p body and @p solution; keeps a reference to @p law, whose pressure depends on
  /// the penetration alone. @p gap as the body's.
  PressureField(const BodyOfRevolution &body, const TableLaw &law, const ContactSolution &solution,
                BodyOfRevolution::Gap gap);

  /// Normal force [N].
  double force() const { return normal_force; }

  /// Pressure [Pa] at @p radius [m] and the azimuths of @p azimuths.
  Eigen::VectorXd on_circle(double radius, const FourierBasis &azimuths) const;

private:
  const TableLaw &law;
  const ContactCompliance compliance;
  const BodyOfRevolution::Gap gap;
  const Eigen::MatrixXd displacement; ///< relative to the table [m], shape [n_radii, n_lines]
  const double normal_force;
};

} // namespace stemware::fem
