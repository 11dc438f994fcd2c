#include "fem/pipeline/study/contact_demand.h"

#include "fem/pipeline/support/failures.h"
#include "fem/pipeline/support/number_text.h"

#include <cmath>

namespace stemware::pipeline
{

fem::ContactLoad demanded_load(const Study &study)
{
  const ring::Motion &orbit = study.motion.orbit;
  const double radius = study.glass.profile.contact_radius;
  fem::ContactLoad load;
  load.normal_force = orbit.normal_force();
  if (study.load.is_static())
  {
    // The load is largest where the moment presses: (sum y f, -sum x f) for forces gathered at that theta.
    const double moment = study.load.moment_ratio * load.normal_force * radius / 2;
    load.moment_x = moment * std::sin(study.load.moment_direction);
    load.moment_y = -moment * std::cos(study.load.moment_direction);
  }
  else
  {
    const Eigen::Vector2d moment = ring::required_moment_at_rest(study.motion.closure, orbit);
    load.moment_x = moment.x();
    load.moment_y = moment.y();
  }
  const double ratio = moment_ratio(load, radius);
  if (!(ratio < 2))
    throw BadInput("The closure " + ring::to_string(study.motion.closure) + " asks for a moment ratio of " +
                   to_short_text(ratio) +
                   ", but the foot tips at 2; change the height of the hand or the speed, or set Load/Moment "
                   "ratio below 2.");
  return load;
}

double moment_ratio(const fem::ContactLoad &load, double contact_radius)
{
  return std::hypot(load.moment_x, load.moment_y) / (load.normal_force * contact_radius / 2);
}

} // namespace stemware::pipeline
