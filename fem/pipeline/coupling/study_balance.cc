#include "fem/pipeline/coupling/study_balance.h"

#include "fem/pipeline/coupling/revolution_setup.h"
#include "ring_model/load/constants.h"

#include <numeric>
#include <vector>

namespace stemware::pipeline
{

namespace
{

double period_of(const std::vector<fem::WavinessHarmonic> &harmonics)
{
  unsigned int divisor = 0;
  for (const fem::WavinessHarmonic &harmonic : harmonics)
    divisor = std::gcd(divisor, harmonic.n);
  return divisor > 0 ? 2 * ring::pi / divisor : 0;
}

} // namespace

ContactBalance moment_balance(const Study &study, unsigned int n_harmonics)
{
  const bool varies = varies_with_spin(study);
  const ring::Motion &motion = study.motion.orbit;
  return { motion, study.motion.closure, ring::orientation_of_marks(motion, 0, 0), study.tilts(),
           varies, n_harmonics };
}

bool varies_with_spin(const Study &study)
{
  return study.load.is_in_balance() && depends_on_spin(study);
}

bool depends_on_spin(const Study &study)
{
  return ring::friction_arm(study.motion.closure, study.motion.orbit) != 0 || study.friction_deforms();
}

ring::PhasePeriods phase_periods(const fem::RimImperfection &imperfection)
{
  return { period_of(imperfection.glass), period_of(imperfection.table) };
}

ring::PhasePeriods phase_periods(const Study &study, const ElasticFoot &foot)
{
  ring::PhasePeriods periods = phase_periods(imperfection_of(study));
  if (const double of_mesh = foot.body().capabilities().glass_period; of_mesh > 0)
    periods.glass = of_mesh;
  return periods;
}

} // namespace stemware::pipeline
