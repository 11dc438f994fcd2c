#include "fem/pipeline/coupling/ring_load.h"

#include "fem/pipeline/coupling/load_file.h"
#include "fem/pipeline/study/study.h"
#include "fem/pipeline/support/failures.h"
#include "fem/pipeline/support/numbers.h"
#include "ring_model/first_harmonic_ring.h"

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>

namespace stemware::pipeline
{

namespace
{

/// Share of the azimuth where a load that is known as a function is positive.
double positive_share(const ring::AngularLoad &load)
{
  constexpr unsigned int n_azimuths = 3600;
  unsigned int n_loaded = 0;
  for (unsigned int i = 0; i < n_azimuths; ++i)
    n_loaded += load(boost::math::constants::two_pi<double>() * (i + 0.5) / n_azimuths) > 0 ? 1 : 0;
  return static_cast<double>(n_loaded) / n_azimuths;
}

/// The same with azimuths in [0, 2 pi), sorted.
std::vector<fem::AzimuthLoad> by_azimuth(std::vector<fem::AzimuthLoad> pointwise)
{
  constexpr double turn = boost::math::constants::two_pi<double>();
  for (fem::AzimuthLoad &place : pointwise)
    place.azimuth -= turn * std::floor(place.azimuth / turn);
  std::sort(pointwise.begin(), pointwise.end(),
            [](const auto &one, const auto &other) { return one.azimuth < other.azimuth; });
  return pointwise;
}

RingLoad load_of_thin_ring(const LoadAtSpin &at_spin)
{
  const ring::AngularLoad at_rest = at_spin(0);
  RingLoad load = { at_spin, at_rest };
  load.normal_force = at_rest.normal_force();
  load.moment = at_rest.moment();
  load.moment_ratio = at_rest.moment_ratio();
  load.mean_radius = at_rest.radius();
  load.contact_fraction = positive_share(at_rest);
  load.minimum = at_rest.minimum();
  return load;
}

} // namespace

RingLoad frozen_contact_load(const fem::LoadHarmonics &contact, double contact_radius)
{
  const ring::AngularLoad frozen(contact.a, contact.b, contact.ring_radius);
  RingLoad load = { [frozen](double) { return frozen; }, frozen };
  load.normal_force = contact.normal_force;
  load.moment = { contact.moment_x, contact.moment_y };
  load.moment_ratio =
    moment_ratio({ contact.normal_force, contact.moment_x, contact.moment_y }, contact_radius);
  load.mean_radius = contact.mean_radius;
  load.contact_fraction = contact.contact_fraction;
  load.minimum = contact.minimum;
  load.pointwise = by_azimuth(contact.pointwise);
  return load;
}

RingLoad first_harmonic_load(const Study &study)
{
  const double radius = study.glass.profile.contact_radius;
  if (study.load.is_static())
  {
    const fem::ContactLoad demand = study.required_resultants();
    const auto frozen =
      ring::AngularLoad::first_harmonic(demand.normal_force, { demand.moment_x, demand.moment_y }, radius);
    return load_of_thin_ring([frozen](double) { return frozen; });
  }
  const ring::FirstHarmonicRing ring(study.motion.closure, study.motion.orbit, radius);
  return load_of_thin_ring([ring](double omega) { return ring.load(omega); });
}

RingLoad load_from_file(const Study &study)
{
  const ring::AngularLoad frozen = read_load_file(study.load.file);
  if (!(frozen.moment_ratio() < 2))
    throw BadInput("The load of " + study.load.file + " has a moment ratio sqrt(a_1^2 + b_1^2) / a_0 of " +
                   to_short_text(frozen.moment_ratio()) + ", but a ring tips at 2; give smaller a_1, b_1.");
  return load_of_thin_ring([frozen](double) { return frozen; });
}

} // namespace stemware::pipeline
