#include "fem/pipeline/coupling/foot_response_curve.h"

#include "fem/pipeline/coupling/load_curve.h"
#include "ring_model/first_harmonic_ring.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

namespace stemware::pipeline
{

namespace
{

/// Where the curve ends: the largest moment ratio of the first harmonic in balance, at any spin up to 4 v /
/// R, and some more for what the other harmonics do to it, short of tipping.
double largest_moment_ratio(const Study &study)
{
  constexpr int n_half = 160;
  const ring::Motion &orbit = study.motion.orbit;
  const double radius = study.glass.profile.contact_radius;
  const ring::FirstHarmonicRing ring(study.motion.closure, orbit, radius);
  double largest = 0;
  for (int i = -n_half; i <= n_half; ++i)
    largest = std::max(largest, ring.load(4. * i / n_half * orbit.orbit_speed / radius).moment_ratio());
  return std::min(1.05 * largest + 0.02, 1.98);
}

} // namespace

FootResponseCurve measure_response(const Study &study, const ElasticFoot &foot)
{
  const double radius = study.glass.profile.contact_radius;
  const double weight = study.motion.orbit.normal_force();
  const std::size_t n_before = foot.n_solutions();
  const auto moment_at = [=](double ratio) { return Eigen::Vector2d(0, -ratio * weight * radius / 2); };

  FootResponseCurve response;
  double lift_off = std::numeric_limits<double>::infinity();
  const auto exact = [&](double ratio)
  {
    if (ratio == 0)
    {
      // No harmonics, and any radius will do; the curve is smooth with the one that a vanishing moment tends
      // to.
      const ring::RingStack nearly = foot.rings(weight, moment_at(1e-4));
      return ring::RingStack({ nearly.a(0), 0 }, { 0, 0 }, nearly.radius());
    }
    const fem::ContactState state = foot.solve(weight, moment_at(ratio));
    if (state.load.contact_fraction < 1)
      lift_off = std::min(lift_off, ratio);
    return ring_stack(state.load);
  };
  try
  {
    const LoadCurve curve =
      sample_load_curve(exact, 0, largest_moment_ratio(study), study.load.response_tolerance, 3000);
    std::vector<std::vector<ring::RingStack>> pieces(curve.pieces.size());
    for (std::size_t i = 0; i < pieces.size(); ++i)
      for (const auto &[ratio, load] : curve.pieces[i])
        pieces[i].push_back(load);
    response.curve = std::make_shared<ring::ResponseCurve>(pieces, radius, lift_off, 1e-8, true);
    response.error = curve.error;
  }
  catch (const ToleranceMissed &failure)
  {
    throw std::runtime_error(
      std::string("Load/Coupling = response does not reach Load/Response tolerance: ") + failure.what() +
      "; give a larger tolerance, or set Coupling = exact.");
  }
  response.n_solutions = foot.n_solutions() - n_before;
  return response;
}

} // namespace stemware::pipeline
