#include "fem/pipeline/coupling/study_balance.h"

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
  const ring::Motion &motion = study.motion.orbit;
  return { motion,        study.motion.closure,     ring::orientation_of_marks(motion, 0, 0),
           study.tilts(), study.varies_with_spin(), n_harmonics };
}

ring::PhasePeriods phase_periods(const fem::RimImperfection &imperfection)
{
  return { period_of(imperfection.glass), period_of(imperfection.table) };
}

ring::PhasePeriods phase_periods(const ElasticFoot &foot)
{
  const auto &[study, discretisation, model] = foot.specification();
  ring::PhasePeriods periods = phase_periods({ study.glass.waviness, study.table.waviness });
  if (const double of_mesh = foot.body().capabilities().glass_period; of_mesh > 0)
    periods.glass = of_mesh;
  return periods;
}

} // namespace stemware::pipeline
