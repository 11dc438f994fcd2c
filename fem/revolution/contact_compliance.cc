#include "fem/revolution/contact_compliance.h"

#include "fem/revolution/meridian_space.h"

#include <algorithm>
#include <array>
#include <memory>
#include <stdexcept>
#include <string>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

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

ContactCompliance compute_compliance(const dealii::Triangulation<2> &triangulation,
                                     const ElasticMaterial &material, const MeridianOptions &options)
{
  material.validate();
  if (options.degree < 1 || options.degree > 4)
    throw std::invalid_argument("Degree = " + std::to_string(options.degree) +
                                " is not allowed for a body of revolution; give 1, 2, 3 or 4.");
  const MeridianSpace space(triangulation, material, options.degree);
  ContactCompliance result;
  result.degree = options.degree;
  result.n_meridian_unknowns = space.n_dofs();
  result.radii.resize(space.n_contact_nodes());
  for (unsigned int i = 0; i < space.n_contact_nodes(); ++i)
    result.radii(i) = space.contact_radius(i);
  result.harmonics.resize(options.n_harmonics + 1);
  // Isolated: a thread that waits here for its last harmonic must not begin another study, which may wait for
  // this very compliance.
  tbb::this_task_arena::isolate(
    [&]
    {
      std::array<std::unique_ptr<const MeridianSpace::Compliances>, 3> of; // harmonics 0, 1, and from 2 on
      tbb::parallel_for(0u, 3u,
                        [&](unsigned int n)
                        { of[n] = std::make_unique<const MeridianSpace::Compliances>(space, n); });
      tbb::parallel_for(0u, options.n_harmonics + 2,
                        [&](unsigned int n)
                        {
                          const bool is_beyond = n > options.n_harmonics;
                          const unsigned int harmonic = is_beyond ? options.beyond() : n;
                          (is_beyond ? result.beyond : result.harmonics[n]) =
                            (*of[std::min(harmonic, 2u)])(harmonic);
                        });
    });
  return result;
}

} // namespace stemware::fem
