#include "fem/revolution/pressure_field.h"

#include <cmath>
#include <stdexcept>
#include <string>

namespace stemware::fem
{

PressureField::PressureField(const BodyOfRevolution &body, const TableLaw &law,
                             const ContactSolution &solution, BodyOfRevolution::Gap gap_given)
    : law(law)
    , compliance(body.contact_compliance())
    , gap(std::move(gap_given))
    , displacement(body.contact_displacement_modes())
    , motion(solution.motion)
    , normal_force(solution.forces.sum())
    , lines(body.fourier_basis().n_lines())
{
  if (!law.pressure_at(0))
    nodal = law.nodal_pressure(solution).reshaped(compliance.n_nodes(), lines);
}

Eigen::VectorXd PressureField::on_circle(double radius, const FourierBasis &azimuths) const
{
  const Eigen::VectorXd shape = compliance.shape_at(radius);
  if (is_nodal())
    return between_lines(nodal.transpose() * shape, azimuths.n_lines());
  Eigen::VectorXd pressure = azimuths.values() * (displacement.transpose() * shape);
  for (unsigned int k = 0; k < azimuths.n_lines(); ++k)
  {
    const double theta = azimuths.azimuth(k);
    const Eigen::Vector3d motion_modes(1, radius * std::cos(theta), radius * std::sin(theta));
    pressure(k) = *law.pressure_at(-gap(radius, theta) - pressure(k) - motion.dot(motion_modes));
  }
  return pressure;
}

Eigen::VectorXd PressureField::between_lines(const Eigen::VectorXd &on_lines, unsigned int n_azimuths) const
{
  if (n_azimuths % lines != 0)
    throw std::invalid_argument("A pressure known on " + std::to_string(lines) + " lines is asked for at " +
                                std::to_string(n_azimuths) + " azimuths; ask at a multiple of the lines.");
  const unsigned int n_between = n_azimuths / lines;
  Eigen::VectorXd values(n_azimuths);
  for (unsigned int k = 0; k < n_azimuths; ++k)
  {
    const double share = static_cast<double>(k % n_between) / n_between;
    values(k) = (1 - share) * on_lines(k / n_between) + share * on_lines((k / n_between + 1) % lines);
  }
  return values;
}

} // namespace stemware::fem
