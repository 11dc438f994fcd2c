#include "fem/contact_compliance.h"

#include <stdexcept>

namespace stemware::fem
{

ContactCompliance &ContactCompliance::operator+=(const ContactCompliance &other)
{
  if (other.n_nodes() != n_nodes() || other.degree != degree || !other.radii.isApprox(radii, 1e-9))
    throw std::invalid_argument("The two bodies do not share their contact nodes; mesh both with the same "
                                "land, resolution and degree.");
  if (other.n_harmonics() != n_harmonics())
    throw std::invalid_argument(
      "The two bodies do not have the same number of harmonics; give both the same.");
  for (std::size_t n = 0; n < harmonics.size(); ++n)
  {
    harmonics[n].normal += other.harmonics[n].normal;
    harmonics[n].radial += other.harmonics[n].radial;
    harmonics[n].azimuthal += other.harmonics[n].azimuthal;
  }
  n_meridian_unknowns += other.n_meridian_unknowns;
  return *this;
}

} // namespace stemware::fem
