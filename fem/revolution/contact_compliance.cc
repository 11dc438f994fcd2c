#include "fem/revolution/contact_compliance.h"

#include <stdexcept>

namespace stemware::fem
{

Eigen::VectorXd lagrange_values(const Eigen::VectorXd &nodes, double x)
{
  Eigen::VectorXd values = Eigen::VectorXd::Ones(nodes.size());
  for (Eigen::Index i = 0; i < nodes.size(); ++i)
    for (Eigen::Index k = 0; k < nodes.size(); ++k)
      if (k != i)
        values(i) *= (x - nodes(k)) / (nodes(i) - nodes(k));
  return values;
}

Eigen::VectorXd ContactCompliance::shape_at(double radius) const
{
  unsigned int first = 0; // node of the element
  while (first + degree + 1 < n_nodes() && radius > radii(first + degree))
    first += degree;
  Eigen::VectorXd shape = Eigen::VectorXd::Zero(n_nodes());
  shape.segment(first, degree + 1) = lagrange_values(radii.segment(first, degree + 1), radius);
  return shape;
}

ContactCompliance ContactCompliance::part(Eigen::Index first, Eigen::Index size) const
{
  const auto part_of = [&](const HarmonicCompliance &whole) -> HarmonicCompliance
  {
    return { whole.normal.block(first, first, size, size), whole.radial.block(first, first, size, size),
             whole.azimuthal.block(first, first, size, size) };
  };
  ContactCompliance result;
  result.radii = radii.segment(first, size);
  result.degree = degree;
  for (const HarmonicCompliance &harmonic : harmonics)
    result.harmonics.push_back(part_of(harmonic));
  result.beyond = part_of(beyond);
  result.n_meridian_unknowns = n_meridian_unknowns;
  result.is_cut_inside = is_cut_inside || first > 0;
  result.is_cut_outside = is_cut_outside || first + size < radii.size();
  return result;
}

ContactCompliance ContactCompliance::without_friction() const
{
  ContactCompliance result = *this;
  const auto drop = [](HarmonicCompliance &harmonic)
  {
    harmonic.radial.setZero();
    harmonic.azimuthal.setZero();
  };
  for (HarmonicCompliance &harmonic : result.harmonics)
    drop(harmonic);
  drop(result.beyond);
  return result;
}

ContactCompliance ContactCompliance::scaled(double factor) const
{
  ContactCompliance result = *this;
  const auto scale = [&](HarmonicCompliance &harmonic)
  {
    harmonic.normal *= factor;
    harmonic.radial *= factor;
    harmonic.azimuthal *= factor;
  };
  for (HarmonicCompliance &harmonic : result.harmonics)
    scale(harmonic);
  scale(result.beyond);
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
  beyond += other.beyond;
  n_meridian_unknowns += other.n_meridian_unknowns;
  return *this;
}

} // namespace stemware::fem
