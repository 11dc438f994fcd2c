#pragma once

#include "fem/contact/contact_newton.h"
#include "fem/revolution/body_of_revolution.h"

namespace stemware::fem
{

/// Contact pressure of a body of revolution: by the table law on the azimuth lines, linear between the lines.
class PressureField
{
public:
  /// Evaluates @p body, with its @p gap, and @p solution; keeps a reference to @p law, which must be local.
  PressureField(const BodyOfRevolution &body, const TableLaw &law, const ContactSolution &solution,
                BodyOfRevolution::Gap gap);

  /// Returns the normal force [N].
  double force() const { return normal_force; }

  /// Returns the pressure [Pa] at @p radius [m] and the azimuths of @p azimuths.
  Eigen::VectorXd on_circle(double radius, const FourierBasis &azimuths) const;

private:
  const TableLaw &law;
  const ContactCompliance compliance;
  const BodyOfRevolution::Gap gap;
  const Eigen::MatrixXd displacement; ///< relative to the table [m], shape [n_radii, n_lines]
  const double normal_force;
};

} // namespace stemware::fem
