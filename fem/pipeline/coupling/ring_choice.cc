#include "fem/pipeline/coupling/ring_choice.h"

#include "ring_model/terminal_spin.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stemware::pipeline
{

namespace
{

/// Returns the range of loaded radii in @p state. With nodal contact on a hard table, possibly only one
/// circle of nodes is loaded. Rings within zero width would extrapolate extremely to the neighbouring nodes,
/// and the balance also needs these nodes. The range is then extended by @p cell on both sides.
fem::ContactWidth band_of(const fem::ContactState &state, double cell)
{
  const bool is_wide = state.outer_radius - state.inner_radius > 1e-3 * cell;
  const double margin = is_wide ? 0 : cell;
  return { state.inner_radius - margin, state.outer_radius + margin };
}

/// Returns the number of rings J for which a torque at slip ratio @p eps (at the contact radius) is exact to
/// 1e-10. The error decreases like (w / (2 R |1 - |eps||))^J, where w is the width of @p band. If the slip
/// vanishes within the band, the error decreases only algebraically, and max_rings is returned.
unsigned int rings_for(const fem::ContactWidth &band, double eps, unsigned int least)
{
  const double share = (band.outer - band.inner) / (band.outer + band.inner) / std::abs(1 - std::abs(eps));
  if (share >= 0.5)
    return max_rings;
  const double wanted = std::ceil(std::log(1e-10) / std::log(share));
  return std::max(least, static_cast<unsigned int>(std::min<double>(wanted, max_rings)));
}

/// Returns the number of harmonics that the kernels require: K_n(eps) decreases like |eps|^n. Valid up to 1.5
/// times the spin.
unsigned int harmonics_for(double eps)
{
  constexpr unsigned int least = 24, most = std::numeric_limits<unsigned int>::max();
  const double fastest = 1.5 * std::abs(eps);
  if (fastest >= 0.99)
    return most;
  return std::max(least, static_cast<unsigned int>(std::ceil(std::log(1e-14) / std::log(fastest))));
}

} // namespace

void choose_rings(const ContactSection &contact, const ring::Motion &motion, ElasticFoot &foot,
                  const fem::ContactState &at_rest)
{
  const fem::ContactWidth band = band_of(at_rest, foot.body().description().contact_cell_size);
  const auto set_rings = [&](unsigned int n_rings, unsigned int n_harmonics)
  {
    if (n_rings == 1)
      return foot.set_rings({}, n_harmonics);
    const double margin = 0.1 * (band.outer - band.inner) + 1e-6 * band.outer;
    foot.set_rings(
      chebyshev_radii(std::max(band.inner - margin, 0.01 * band.inner), band.outer + margin, n_rings),
      n_harmonics);
  };
  unsigned int n_rings = contact.rings, n_harmonics = foot.body().n_resolved_harmonics();
  set_rings(n_rings, n_harmonics);
  try
  {
    const double omega = ring::terminal_spin(foot.project_onto_rings(at_rest), motion).omega;
    const double eps = omega * foot.radius() / motion.orbit_speed;
    n_harmonics = harmonics_for(eps);
    if (n_rings > 1)
      n_rings = rings_for(band, eps, n_rings);
  }
  catch (const ring::NoBalance &) // without an expected spin, the rings of the load at rest are kept
  {
  }
  set_rings(n_rings, contact.load_harmonics > 0 ? contact.load_harmonics : n_harmonics);
}

} // namespace stemware::pipeline
