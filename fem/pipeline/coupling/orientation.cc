#include "fem/pipeline/coupling/orientation.h"

#include <boost/math/constants/constants.hpp>

#include <numeric>

namespace stemware::pipeline
{

namespace
{

double period_of(const std::vector<fem::WavinessHarmonic> &harmonics)
{
  unsigned int divisor = 0;
  for (const fem::WavinessHarmonic &harmonic : harmonics)
    divisor = std::gcd(divisor, harmonic.n);
  return divisor > 0 ? boost::math::double_constants::two_pi / divisor : 0;
}

} // namespace

ring::Orientation orientation_of_marks(const ring::Motion &motion, double time, double yaw_angle)
{
  const double behind =
    motion.orbit_rate() * time + motion.sense_sign() * boost::math::double_constants::half_pi;
  return { yaw_angle - behind, -behind };
}

fem::RimImperfection imperfection_of(const Study &study)
{
  return study.model.waviness ? fem::RimImperfection{ study.glass.waviness, study.table.waviness }
                              : fem::RimImperfection();
}

PhasePeriods phase_periods(const fem::RimImperfection &imperfection)
{
  return { period_of(imperfection.glass), period_of(imperfection.table) };
}

} // namespace stemware::pipeline
