#include "fem/pipeline/analysis/refinement/quantities_of_interest.h"

#include "fem/pipeline/support/numbers.h"
#include "ring_model/coulomb_ring.h"
#include "ring_model/terminal_spin.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace stemware::pipeline
{

namespace
{

void add_load_figures(const RingLoad &load, const FigureNoise &noise, std::vector<FollowedFigure> &figures)
{
  const ring::AngularLoad &at_rest = load.at_rest;
  const double mean = at_rest.a(0);
  for (unsigned int n = 1; n <= n_followed_harmonics; ++n)
  {
    const std::string order = std::to_string(n);
    figures.push_back({ "a" + order, "a_" + order + "/a_0", "1", at_rest.a(n) / mean, noise.relative });
    figures.push_back({ "b" + order, "b_" + order + "/a_0", "1", at_rest.b(n) / mean, noise.relative });
  }
  figures.push_back(
    { "ring_radius", "ring radius", "m", at_rest.radius(), noise.relative * at_rest.radius() });
  // A place where the contact ends is known to one azimuth only.
  const bool ends_somewhere = load.contact_fraction > 0 && load.contact_fraction < 1;
  figures.push_back({ "contact_fraction", "share of the rim in contact", "1", load.contact_fraction,
                      ends_somewhere ? 1. / noise.n_azimuths : 0. });
  figures.push_back({ "minimum", "least load", "N/rad", load.minimum, noise.relative * mean });
}

} // namespace

bool BandedFigure::is_zero() const
{
  return std::abs(figure.value) <= figure.rounding && std::abs(richardson) <= figure.rounding;
}

std::vector<FollowedFigure> followed_figures(const RingLoad &load, const ring::Motion &motion,
                                             const std::vector<double> &spins,
                                             const std::optional<double> &near, const FigureNoise &noise)
{
  std::vector<FollowedFigure> figures;
  add_load_figures(load, noise, figures);

  const ring::CoulombRing friction(motion.friction_coefficient);
  const auto torque = [&](double omega)
  { return friction.wrench(load.at_spin(omega), omega, motion.orbit_speed).torque; };
  const double torque_noise =
    noise.relative * motion.friction_coefficient * load.normal_force * load.at_rest.radius();
  figures.push_back({ "tau_at_rest", "torque at rest", "N m", torque(0), torque_noise });
  for (std::size_t i = 0; i < spins.size(); ++i)
    figures.push_back({ "tau_at_spin_" + std::to_string(i + 1),
                        "torque at " + to_short_text(spins[i]) + " rad/s", "N m", torque(spins[i]),
                        torque_noise });

  const double spin_scale = motion.orbit_speed / load.at_rest.radius();
  const ring::TerminalSpin terminal =
    ring::terminal_spin(torque, motion.yaw_inertia, spin_scale, near.value_or(0));
  figures.push_back(
    { "omega_terminal", "terminal spin", "rad/s", terminal.omega, noise.relative * spin_scale });
  // A slope by finite differences has ten times the noise of its function.
  figures.push_back({ "time_constant", "time constant", "s", terminal.time_constant,
                      10 * noise.relative * terminal.time_constant });
  return figures;
}

std::vector<double> followed_spins(double omega_terminal)
{
  return { 0.5 * omega_terminal, 1.5 * omega_terminal };
}

const FollowedFigure &figure_of(const std::vector<FollowedFigure> &figures, const std::string &key)
{
  const auto found = std::find_if(figures.begin(), figures.end(),
                                  [&](const FollowedFigure &figure) { return figure.key == key; });
  if (found == figures.end())
    throw std::out_of_range("no quantity of a refinement study is called " + key);
  return *found;
}

std::optional<double> band_of(const std::vector<BandedFigure> &figures, const std::string &key)
{
  for (const BandedFigure &banded : figures)
    if (banded.figure.key == key)
      return banded.band;
  return std::nullopt;
}

} // namespace stemware::pipeline
