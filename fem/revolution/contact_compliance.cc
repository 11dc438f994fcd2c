#include "fem/revolution/contact_compliance.h"

#include "ring_model/load/lagrange.h"

#include <stdexcept>

namespace stemware::fem
{

std::pair<Eigen::Index, Eigen::Index> nodes_between(const Eigen::VectorXd &radii, Eigen::Index degree,
                                                    double inner, double outer)
{
  Eigen::Index first = 0, last = radii.size() - 1;
  while (first + degree < last && radii(first + degree) < inner)
    first += degree;
  while (last - degree > first && radii(last - degree) > outer)
    last -= degree;
  return { first, last - first + 1 };
}

Eigen::MatrixXd ContactCompliance::extended_to_land(const Eigen::MatrixXd &values) const
{
  if (values.size() == 0)
    return values;
  Eigen::MatrixXd extended = Eigen::MatrixXd::Zero(n_inside + radii.size() + n_outside, values.cols());
  extended.middleRows(n_inside, radii.size()) = values;
  return extended;
}

Eigen::VectorXd ContactCompliance::shape_at(double radius) const
{
  unsigned int first = 0;
  while (first + degree + 1 < n_nodes() && radius > radii(first + degree))
    first += degree;
  Eigen::VectorXd shape = Eigen::VectorXd::Zero(n_nodes());
  shape.segment(first, degree + 1) = ring::lagrange_values(radii.segment(first, degree + 1), radius);
  return shape;
}

ContactCompliance ContactCompliance::part(Eigen::Index first, Eigen::Index size) const
{
  ContactCompliance result;
  result.radii = radii.segment(first, size);
  result.degree = degree;
  for (const HarmonicCompliance &harmonic : harmonics)
    result.harmonics.push_back(harmonic.part(first, size));
  result.tail = tail.part(first, size);
  result.n_meridian_unknowns = n_meridian_unknowns;
  result.n_inside = n_inside + first;
  result.n_outside = n_outside + radii.size() - first - size;
  return result;
}

ContactCompliance ContactCompliance::times(double of_normal, double of_friction) const
{
  ContactCompliance result = *this;
  const auto scale = [&](HarmonicCompliance &harmonic)
  {
    harmonic.normal *= of_normal;
    harmonic.radial *= of_friction;
    harmonic.azimuthal *= of_friction;
  };
  for (HarmonicCompliance &harmonic : result.harmonics)
    scale(harmonic);
  scale(result.tail);
  return result;
}

ContactCompliance &ContactCompliance::operator+=(const ContactCompliance &other)
{
  if (other.n_nodes() != n_nodes() || other.degree != degree || !other.radii.isApprox(radii, 1e-9))
    throw std::invalid_argument("The two bodies do not share their contact nodes; mesh both with the same "
                                "land, resolution and degree.");
  if (other.n_harmonics() != n_harmonics())
    throw std::invalid_argument(
      "The two bodies do not have the same number of harmonics; give both the same.");
  for (std::size_t n = 0; n < harmonics.size(); ++n)
    harmonics[n] += other.harmonics[n];
  tail += other.tail;
  n_meridian_unknowns += other.n_meridian_unknowns;
  return *this;
}

} // namespace stemware::fem
