#pragma once

#include "fem/contact/contact_newton.h"
#include "fem/revolution/body_of_revolution.h"

namespace stemware::fem
{

/// Contact pressure of a pressed body of revolution, anywhere on its contact zone.
///
/// On a mat or a rough table the table law gives it at every point; on rigid and elastic tables forces are
/// known at the contact nodes alone, and pressures in between are interpolated: by the elements along r,
/// linearly between the azimuth lines.
class PressureField
{
public:
  /// Takes what it needs of @p body and @p solution; keeps a reference to @p law. @p gap as the body's.
  PressureField(const BodyOfRevolution &body, const TableLaw &law, const ContactSolution &solution,
                BodyOfRevolution::Gap gap);

  /// Whether pressures are known at the contact nodes alone.
  bool is_nodal() const { return nodal.size() > 0; }
  /// Azimuth lines of the contact nodes.
  unsigned int n_lines() const { return lines; }
  /// Normal force [N].
  double force() const { return normal_force; }

  /// Pressure [Pa] at @p radius [m] and the azimuths of @p azimuths, whose modes are the body's. Where
  /// is_nodal(), their number has to be a multiple of n_lines(), or std::invalid_argument is thrown.
  Eigen::VectorXd on_circle(double radius, const FourierBasis &azimuths) const;

private:
  Eigen::VectorXd between_lines(const Eigen::VectorXd &on_lines, unsigned int n_azimuths) const;

  const TableLaw &law;
  const ContactCompliance compliance;
  const BodyOfRevolution::Gap gap;
  const Eigen::MatrixXd displacement; ///< modes on the contact circles [m]
  const Eigen::Vector3d motion;
  const double normal_force;
  const unsigned int lines;
  Eigen::MatrixXd
    nodal; ///< pressure at the contact nodes, shape [n_radii, n_lines]; empty where the law gives it
};

} // namespace stemware::fem
