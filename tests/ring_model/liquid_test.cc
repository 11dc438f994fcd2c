// Moments of the liquid in the bowl. Reference: weights and moments of vertical columns of liquid, summed in
// three dimensions.
#include "ring_model/load/constants.h"
#include "ring_model/moment_balance.h"
#include "tests/ring_model/reference.h"
#include "tests/ulps.h"

#include <Eigen/Geometry>

#include <functional>
#include <stdexcept>

namespace stemware::ring
{
namespace
{
using Eigen::Vector3d;

/// Returns the mass of @p liquid below a plane of slope (s_x, s_y) [kg], and the moment sum r x f of the
/// forces f = mass * @p field at the centres of the columns [N m].
std::pair<double, Vector3d> columns(const Liquid &liquid, const Eigen::Vector2d &slope, const Vector3d &field)
{
  // Gauss points in r and equally spaced angles integrate these polynomials in x and y exactly.
  const double node = std::sqrt(0.6) / 2, points[3] = { 0.5 - node, 0.5, 0.5 + node },
               weights[3] = { 5. / 18, 8. / 18, 5. / 18 };
  constexpr unsigned int n_angles = 16;
  const double turn = 2 * pi, radius = liquid.bowl_radius,
               depth = liquid.mass / (liquid.density * turn / 2 * radius * radius);
  double mass = 0;
  Vector3d moment = Vector3d::Zero();
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int k = 0; k < n_angles; ++k)
    {
      const double r = radius * points[i], angle = turn * k / n_angles, x = r * std::cos(angle),
                   y = r * std::sin(angle), height = depth + slope.x() * x + slope.y() * y;
      const double column = liquid.density * height * r * radius * weights[i] * turn / n_angles;
      mass += column;
      moment += Vector3d(x, y, liquid.bowl_height + height / 2).cross(column * field);
    }
  return { mass, moment };
}

Motion filled(unsigned int seed)
{
  test::Numbers numbers(seed);
  Motion motion;
  motion.mass = numbers.between(0.1, 0.4);
  motion.centre_of_mass_height = numbers.between(0.05, 0.12);
  motion.force_offset = numbers.between(-0.08, 0.05);
  motion.orbit_speed = numbers.between(0.1, 0.6);
  motion.orbit_acceleration = numbers.between(-1, 1);
  motion.orbit_sense = seed % 2 == 0 ? OrbitSense::counterclockwise : OrbitSense::clockwise;
  motion.liquid = { numbers.between(0.1, 0.2), numbers.between(950, 1050), numbers.between(0.03, 0.04),
                    numbers.between(0.02, 0.1), 0.2 };
  return motion;
}

TEST(Liquid, RequiredMomentsAgreeWithASumOverLiquidColumns)
{
  for (unsigned int seed = 1; seed <= 20; ++seed)
  {
    const Motion motion = filled(seed);
    motion.validate();
    const Eigen::Vector2d a = motion.acceleration(), friction(-0.7, 0.2);
    const Vector3d field(-a.x(), -a.y(), -motion.gravity);
    const auto [liquid_mass, of_liquid] = columns(motion.liquid, -a / motion.gravity, field);
    expect_relative(liquid_mass, motion.liquid.mass, 1e-14, "mass");
    const Vector3d hand(liquid_mass * a.x() + motion.mass * a.x() - friction.x(),
                        liquid_mass * a.y() + motion.mass * a.y() - friction.y(), 0);
    const double z = motion.centre_of_mass_height;
    const Vector3d others = of_liquid + Vector3d(0, 0, z).cross(motion.mass * field) +
                            Vector3d(0, 0, z + motion.force_offset).cross(hand);
    const Eigen::Vector2d moment = required_moment(Closure::full, motion, friction);
    EXPECT_NEAR((moment + others.head<2>()).norm(), 0, ulps(500, others.norm())) << seed;

    // required_moment() of Closure::hand omits the moment of the friction about the common centre of mass.
    const double rise = Vector3d(columns(motion.liquid, -a / motion.gravity, { 1, 0, 0 }).second).y();
    const double centre = (rise + motion.mass * z) / (liquid_mass + motion.mass);
    const Eigen::Vector2d of_hand = required_moment(Closure::hand, motion, friction);
    EXPECT_NEAR((moment - of_hand - centre * Eigen::Vector2d(-friction.y(), friction.x())).norm(), 0,
                ulps(10, others.norm()))
      << seed;

    Motion frozen = motion;
    frozen.liquid.surface_leans = false;
    const Vector3d of_solid = columns(motion.liquid, { 0, 0 }, field).second;
    EXPECT_NEAR(
      (required_moment(Closure::full, frozen, friction) - moment - (of_liquid - of_solid).head<2>()).norm(),
      0, 1e-13 * others.norm())
      << seed;
  }
}

TEST(Liquid, ActsAtItsMetacentreOnALeaningGlass)
{
  for (unsigned int seed = 1; seed <= 20; ++seed)
  {
    Motion motion = filled(seed);
    motion.orbit_speed = 1e-6;
    motion.orbit_acceleration = 0;
    // In the frame of a leaning glass, gravity and the liquid's surface lean. The metacentre gives the moment
    // to first order in the lean.
    const double lean = 1e-5;
    const Vector3d field(motion.gravity * std::sin(lean), 0, -motion.gravity * std::cos(lean));
    const Vector3d moment = columns(motion.liquid, { std::tan(lean), 0 }, field).second +
                            Vector3d(0, 0, motion.centre_of_mass_height).cross(motion.mass * field);
    expect_relative(moment.y() / lean, motion.normal_force() * motion.overturning_height(), 1e-9, "N z");
  }
}

TEST(Liquid, RefusesOverflowABareBottomAndInvalidValues)
{
  Motion motion = filled(3);
  const double level = motion.liquid.level(),
               rise = motion.liquid.bowl_radius * motion.acceleration().norm() / motion.gravity;
  motion.liquid.bowl_depth = level + 1.001 * rise;
  EXPECT_NO_THROW(motion.validate());
  motion.liquid.bowl_depth = level + 0.999 * rise;
  EXPECT_THROW(motion.validate(), std::invalid_argument);
  motion.liquid.surface_leans = false;
  EXPECT_NO_THROW(motion.validate());
  motion.liquid.surface_leans = true;
  motion.liquid.bowl_depth = 1;
  motion.liquid.mass *= 1.001 * rise / level;
  EXPECT_NO_THROW(motion.validate());
  motion.liquid.mass *= 0.998;
  EXPECT_THROW(motion.validate(), std::invalid_argument);
  const std::function<void(Liquid &)> wrong[] = { [](Liquid &liquid) { liquid.mass = -1; },
                                                  [](Liquid &liquid) { liquid.density = 0; },
                                                  [](Liquid &liquid) { liquid.bowl_radius = 0; },
                                                  [](Liquid &liquid) { liquid.bowl_height = -1; } };
  for (const auto &change : wrong)
  {
    Motion other = filled(4);
    change(other.liquid);
    EXPECT_THROW(other.validate(), std::invalid_argument);
  }
}
} // namespace
} // namespace stemware::ring
