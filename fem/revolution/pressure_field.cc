#include "fem/revolution/pressure_field.h"

#include <utility>

namespace stemware::fem
{

PressureField::PressureField(const BodyOfRevolution &body, const TableLaw &law,
                             const ContactSolution &solution, BodyOfRevolution::Gap gap_given)
    : law(law)
    , compliance(body.contact_compliance())
    , gap(std::move(gap_given))
    , displacement(
        solution.normal_displacement.reshaped(compliance.n_nodes(), body.fourier_basis().n_lines()))
    , normal_force(solution.forces.sum())
{
}

Eigen::VectorXd PressureField::on_circle(double radius, const FourierBasis &azimuths) const
{
  const Eigen::VectorXd &radii = compliance.radii;
  if (radius < radii(0) || radius > radii(radii.size() - 1))
    return Eigen::VectorXd::Zero(azimuths.n_lines()); // outside the contact zone
  const Eigen::VectorXd shape = compliance.shape_at(radius);
  const Eigen::Index n_lines = displacement.cols();
  Eigen::VectorXd on_lines = displacement.transpose() * shape;
  for (Eigen::Index j = 0; j < n_lines; ++j)
  {
    const double theta = FourierBasis::norm(0) * static_cast<double>(j) / static_cast<double>(n_lines);
    on_lines(j) = *law.pressure_at(-gap(radius, theta) - on_lines(j));
  }
  Eigen::VectorXd pressure(azimuths.n_lines());
  for (unsigned int k = 0; k < azimuths.n_lines(); ++k)
  {
    const double place = static_cast<double>(k) * static_cast<double>(n_lines) / azimuths.n_lines();
    const auto before = static_cast<Eigen::Index>(place);
    const double share = place - static_cast<double>(before);
    pressure(k) = (1 - share) * on_lines(before % n_lines) + share * on_lines((before + 1) % n_lines);
  }
  return pressure;
}

} // namespace stemware::fem
