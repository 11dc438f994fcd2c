#include "fem/pipeline/analysis/prepared_run.h"

#include "fem/pipeline/study/study.h"
#include "fem/pipeline/support/failures.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace stemware::pipeline
{

namespace
{

/// Noise of a smooth curve by its second differences.
double rough_noise(const MeasuredRun &data)
{
  double sum = 0, largest = 0;
  for (std::size_t i = 1; i + 1 < data.values.size(); ++i)
    sum += std::pow(data.values[i - 1] - 2 * data.values[i] + data.values[i + 1], 2);
  for (const double value : data.values)
    largest = std::max(largest, std::abs(value));
  return std::max(std::sqrt(sum / 6 / static_cast<double>(data.values.size())), 1e-6 * largest);
}

/// Throws BadInput for a run that cannot be fitted.
void require_fittable(const RunToFit &run)
{
  constexpr std::size_t min_points = 5;
  ensure(run.data.times.size() >= min_points,
         "--data " + run.name + " has " + std::to_string(run.data.times.size()) +
           " points; measure at least " + std::to_string(min_points) + ".");
  ensure(run.data.times.back() > run.data.times.front(), "--data " + run.name + ": all times are equal.");
  const auto [least, most] = std::minmax_element(run.data.values.begin(), run.data.values.end());
  ensure(*most > *least, "--data " + run.name +
                           ": all values are equal, but a fit needs a spin-up; give a run in which the "
                           "glass begins to turn.");
  require_flat(run.study, "fit");
  ensure(!run.study.load.is_from_contact() || run.study.contact.goal == Goal::none,
         "A fit solves many studies on one mesh; set Contact/Goal = none.");
  ensure(!run.study.motion.orbit_speeds,
         "--data " + run.name +
           ": a fit has no table of the hand's speed; leave out Motion/Orbit speed file.");
  ensure(!run.study.load.is_static(), "--data " + run.name +
                                        ": the load has a given moment; a fit needs the moment of the hand, "
                                        "leave out the entries of Load but Source.");
}

} // namespace

PreparedRun prepared(const RunToFit &run, const std::vector<FitParameter> &parameters,
                     const Executor &executor)
{
  require_fittable(run);
  const ring::Motion &motion = run.study.motion.orbit;
  const double radius = run.study.glass.profile.contact_radius;
  return { run, std::make_shared<SpinUps>(run.study, parameters, executor),
           motion.yaw_inertia * motion.orbit_speed /
             (motion.friction_at_rest() * motion.normal_force() * radius * radius),
           rough_noise(run.data) };
}

} // namespace stemware::pipeline
