#include "ring_model/free_sliding.h"
#include "ring_model/friction_kernels.h"
#include "ring_model/load/constants.h"
#include "tests/ring_model/reference.h"

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_2.hpp>

#include <limits>
#include <stdexcept>

namespace stemware::ring
{
namespace
{
using test::expect_relative;
using test::reference;

/// Unit mass, radius and mu g; inertia gamma.
FreeSlider unit_slider(const SlidingBody &body, double gamma)
{
  return { body, 1., gamma, 1., 1., 0. };
}

/// final_slip_ratio() of a body of rings.
double final_ratio(const FreeSlider &slider, double slip_ratio)
{
  return final_slip_ratio(
    { slider.mass, slider.yaw_inertia, slider.body.outer_radius() },
    [&](double speed, double omega) { return sliding_friction(slider, speed, omega); }, slip_ratio);
}

/// slide_to_stop() of a body of rings.
SlidingPath slide_to_stop(const FreeSlider &slider, double speed, double omega, double accuracy = 1e-12)
{
  return slide_to_stop(
    SlidingInertia{ slider.mass, slider.yaw_inertia, slider.body.outer_radius() },
    [&](double v, double spin) { return sliding_friction(slider, v, spin); }, speed, omega, accuracy);
}

TEST(FreeSliding, UniformRingRowsOfTheReference)
{
  const auto &rows = reference()["literature"]["ring_uniform"];
  const FreeSlider ring = unit_slider(SlidingBody::ring(1.), 1.);
  for (std::size_t i = 0; i < rows["eps"].size(); ++i)
  {
    const Wrench friction = sliding_friction(ring, 1., rows["eps"][i]);
    EXPECT_NEAR(-friction.force_x, rows["f"][i].get<double>(), 2e-15);
    EXPECT_NEAR(-friction.torque, rows["t"][i].get<double>(), 2e-15);
    EXPECT_EQ(friction.force_y, 0.);
  }
}

TEST(FreeSliding, RingOfInertiaMRSquaredStopsRollingAboutItsRim)
{
  const auto &row = reference()["literature"]["ring_free_terminal"];
  const FreeSlider ring = unit_slider(SlidingBody::ring(1.), 1.);
  for (const double start : { 0.1, 0.7, 1., 3., 20., -0.5 })
    EXPECT_EQ(slide_to_stop(ring, 1., start).final_slip_ratio, std::copysign(1., start)) << start;
  const Wrench friction = sliding_friction(ring, 1., 1.);
  expect_relative(-friction.force_x, row["f"], 1e-15, "f");
  expect_relative(-friction.torque, row["t"], 1e-15, "t");
  // The integration gets there by itself, long before the stop.
  const auto path = slide_to_stop(ring, 1., 0.5);
  const SlidingState &late = path.states[path.states.size() - 2];
  EXPECT_NEAR(late.omega / late.speed, 1., 1e-11);
}

TEST(FreeSliding, RingRowsOverTheInertia)
{
  for (const auto &row : reference()["literature"]["ring_free_terminal_vs_gamma"]["rows"])
  {
    const FreeSlider ring = unit_slider(SlidingBody::ring(1.), row["gamma"]);
    for (const double ratio : { final_ratio(ring, 0.01), final_ratio(ring, 50.) })
    {
      expect_relative(ratio, row["eps0_omegaR_over_v"], 1e-13, "eps_0");
      expect_relative(1. / ratio, row["v_over_omegaR"], 1e-13, "v / omega R");
    }
  }
  // Outside 1/2 < gamma < 2 one motion dies first.
  EXPECT_EQ(slide_to_stop(unit_slider(SlidingBody::ring(1.), 0.45), 1., 1.).final_slip_ratio, 0.);
  EXPECT_EQ(slide_to_stop(unit_slider(SlidingBody::ring(1.), 2.2), 1., 1.).final_slip_ratio,
            std::numeric_limits<double>::infinity());
}

TEST(FreeSliding, AnnulusAndDiscRowsOfTheReference)
{
  for (const auto &row : reference()["literature"]["annulus_free_terminal"]["rows"])
  {
    const SlidingBody body = SlidingBody::annulus(row["eta"], 1.);
    expect_relative(body.mean_square_radius(), row["gamma"], 1e-15, "gamma");
    const FreeSlider slider = unit_slider(body, row["gamma"]);
    const std::string name = "eta " + std::to_string(row["eta"].get<double>());
    const double eps = final_ratio(slider, 0.3);
    expect_relative(eps, row["eps0_omegaR_over_v"], 1e-14, name + " eps");
    expect_relative(1. / eps, row["v_over_omegaR"], 1e-14, name + " v / omega R");
    const Wrench friction = sliding_friction(slider, 1., eps);
    expect_relative(-friction.force_x, row["f"], 1e-14, name + " f");
    expect_relative(-friction.torque, row["t"], 1e-14, name + " t");
  }
  const FreeSlider disc = unit_slider(SlidingBody::disc(1.), 0.5);
  EXPECT_NEAR(1. / slide_to_stop(disc, 1., 0.2).final_slip_ratio, 0.6530017892055976, 5e-15);
}

TEST(FreeSliding, DiscRowsAndClosedFormsAreReproduced)
{
  const FreeSlider disc = unit_slider(SlidingBody::disc(1.), 0.5);
  for (const auto &row : reference()["literature"]["disc_uniform"]["rows"])
  {
    const Wrench friction = sliding_friction(disc, row["v_over_omegaR"], 1.);
    expect_relative(-friction.force_x, row["f"], 1e-14, "f");
    expect_relative(-friction.torque, row["t"], 1e-14, "t");
  }
  // Closed forms in complete elliptic integrals of modulus v/(omega R) <= 1, another route than rings.
  for (const double e : { 0.05, 0.3, 0.7, 0.95 })
  {
    const double K = boost::math::ellint_1(e), E = boost::math::ellint_2(e);
    const Wrench friction = sliding_friction(disc, e, 1.);
    expect_relative(-friction.force_x, 4. / (3. * pi * e) * ((e * e + 1.) * E + (e * e - 1.) * K), 1e-12,
                    "f");
    expect_relative(-friction.torque, 4. / (9. * pi) * ((4. - 2. * e * e) * E + (e * e - 1.) * K), 1e-13,
                    "t");
  }
}

TEST(FreeSliding, RingStoppingRowsOfTheReference)
{
  const FreeSlider ring = unit_slider(SlidingBody::ring(1.), 1.);
  for (const auto &row : reference()["literature"]["ring_stopping"]["rows"])
  {
    const auto path = slide_to_stop(ring, 1., row["eps_start"], 1e-13);
    const SlidingState &stop = path.states.back();
    const std::string name = "eps " + std::to_string(row["eps_start"].get<double>());
    expect_relative(stop.time, row["T"], 1e-12, name + " T");
    expect_relative(stop.x, row["X"], 1e-12, name + " X");
    expect_relative(stop.yaw, row["Phi"], 1e-12, name + " Phi");
    EXPECT_EQ(stop.y, 0.);
    EXPECT_EQ(stop.speed, 0.);
    EXPECT_EQ(stop.omega, 0.);
  }
}

TEST(FreeSliding, WithoutSpinItIsABrick)
{
  // T = v_0 / mu g, X = v_0^2 / 2 mu g, for any body.
  for (const SlidingBody &body :
       { SlidingBody::ring(0.03), SlidingBody::disc(0.03), SlidingBody::annulus(0.01, 0.03) })
  {
    const auto path = slide_to_stop({ body, 0.3, 3e-4, 0.25, 9.81, 0.02 }, 2., 0.);
    expect_relative(path.states.back().time, 2. / (0.25 * 9.81), 1e-11, "time");
    expect_relative(path.states.back().x, 4. / (2. * 0.25 * 9.81), 1e-11, "distance");
    EXPECT_EQ(path.states.back().y, 0.);
    EXPECT_EQ(path.states.back().yaw, 0.);
    EXPECT_EQ(path.final_slip_ratio, 0.);
  }
}

TEST(FreeSliding, CylinderRowsOfTheReference)
{
  for (const auto &row : reference()["free_sliding_cylinder"]["rows"])
  {
    FreeSlider cylinder{
      SlidingBody::ring(0.1), 2., 0.01, row["mu"], 9.81, 0.1 * row["h_over_R"].get<double>()
    };
    const double weight = 2. * 9.81, eps = row["eps"];
    const Wrench friction = sliding_friction(cylinder, 0.7, eps * 0.7 / 0.1);
    EXPECT_NEAR(friction.force_x / weight, row["Tpar_over_N"].get<double>(), 1e-15);
    EXPECT_NEAR(friction.force_y / weight, row["Tperp_over_N"].get<double>(), 1e-15);
    EXPECT_NEAR(friction.torque / (weight * 0.1), row["tau_over_NR"].get<double>(), 1e-15);
  }
}

TEST(FreeSliding, AtTheStopThereIsAHeadingOnlyWhereNothingPushesAcross)
{
  // Up to the stop the tilted tumbler's friction has a part across its motion: the direction goes on turning,
  // by equal angles for equal shares of the speed.
  const FreeSlider tumbler{ SlidingBody::annulus(0.02, 0.03), 0.3, 3e-4, 0.2, 9.81, 0.05 };
  const auto path = slide_to_stop(tumbler, 1., 20.);
  EXPECT_TRUE(std::isnan(path.states.back().heading));
  const auto heading_at = [&](double speed)
  {
    std::size_t i = 1;
    while (path.states[i].speed > speed)
      ++i;
    const SlidingState &above = path.states[i - 1], &below = path.states[i];
    const double share = std::log(above.speed / speed) / std::log(above.speed / below.speed);
    return above.heading + share * (below.heading - above.heading);
  };
  const double one = heading_at(1e-6) - heading_at(1e-3), other = heading_at(1e-12) - heading_at(1e-9);
  EXPECT_GT(std::abs(other), 0.1);
  EXPECT_NEAR(one / other, 1, 1e-3);
  // Without tilt, or without spin, nothing does.
  FreeSlider low = tumbler;
  low.centre_of_mass_height = 0;
  EXPECT_EQ(slide_to_stop(low, 1., 20.).states.back().heading, 0.);
  EXPECT_EQ(slide_to_stop(tumbler, 1., 0.).states.back().heading, 0.);
}

TEST(FreeSliding, AgreesWithADirectIntegrationUntilCloseToTheStop)
{
  // Classical Runge-Kutta in time on v_x, v_y, omega with fixed steps, up to 90 % of the way.
  const FreeSlider tumbler{ SlidingBody::ring(0.03), 0.3, 2e-4, 0.2, 9.81, 0.04 };
  const auto path = slide_to_stop(tumbler, 1., 25.);
  using State = std::array<double, 5>; // x, y, v_x, v_y, omega
  const auto rate = [&](const State &s)
  {
    const double speed = std::hypot(s[2], s[3]);
    const Wrench friction = sliding_friction(tumbler, speed, s[4]);
    const double c = s[2] / speed, sine = s[3] / speed;
    return State{ s[2], s[3], (c * friction.force_x - sine * friction.force_y) / 0.3,
                  (sine * friction.force_x + c * friction.force_y) / 0.3, friction.torque / 2e-4 };
  };
  const auto moved = [](const State &s, const State &k, double h)
  {
    State result = s;
    for (unsigned int i = 0; i < 5; ++i)
      result[i] += h * k[i];
    return result;
  };
  std::size_t index = 0;
  while (path.states[index].speed > 0.1)
    ++index;
  const SlidingState &target = path.states[index];
  State state{ 0., 0., 1., 0., 25. };
  const unsigned int n_steps = 4000;
  const double h = target.time / n_steps;
  for (unsigned int i = 0; i < n_steps; ++i)
  {
    const State k1 = rate(state), k2 = rate(moved(state, k1, h / 2.)), k3 = rate(moved(state, k2, h / 2.)),
                k4 = rate(moved(state, k3, h));
    for (unsigned int j = 0; j < 5; ++j)
      state[j] += h / 6. * (k1[j] + 2. * k2[j] + 2. * k3[j] + k4[j]);
  }
  EXPECT_NEAR(state[0], target.x, 1e-9);
  EXPECT_NEAR(state[1], target.y, 1e-9);
  EXPECT_NEAR(std::hypot(state[2], state[3]), target.speed, 1e-9);
  EXPECT_NEAR(std::atan2(state[3], state[2]), target.heading, 1e-8);
  EXPECT_NEAR(state[4], target.omega, 1e-6);
}

TEST(FreeSliding, FrictionTakesTheKineticEnergyThatTheBodyLoses)
{
  // The power at every step, by another route: a plain sum over the rim of mu p |v_rel|, with the first
  // harmonic that carries h k x T; its integral over time by Simpson's rule on a fine classical integration.
  const double mass = 0.3, inertia = 2e-4, radius = 0.03, mu = 0.2, height = 0.04, weight = mass * 9.81;
  const FreeSlider tumbler{ SlidingBody::ring(radius), mass, inertia, mu, 9.81, height };
  const auto energy = [&](const SlidingState &state)
  { return (mass * state.speed * state.speed + inertia * state.omega * state.omega) / 2.; };
  const auto path = slide_to_stop(tumbler, 1., 25.);
  for (const SlidingState &state : path.states)
    EXPECT_NEAR(energy(state) + state.friction_loss, energy(path.states.front()),
                1e-11 * energy(path.states.front()));

  std::size_t end = 0;
  while (path.states[end].speed > 0.3)
    ++end;
  const auto power = [&](double speed, double omega)
  {
    const Wrench friction = sliding_friction(tumbler, speed, omega);
    const double alpha = -2. * height * friction.force_x / (weight * radius),
                 beta = -2. * height * friction.force_y / (weight * radius);
    const unsigned int n = 2000;
    double sum = 0.;
    for (unsigned int i = 0; i < n; ++i)
    {
      const double theta = 2. * pi * i / n, rim = omega * radius;
      sum += mu * weight / n * (1. + alpha * std::cos(theta) + beta * std::sin(theta)) *
             std::hypot(speed - rim * std::sin(theta), rim * std::cos(theta));
    }
    return sum;
  };
  // The steps are short: on each the power is a parabola to 1e-9 through its ends and the mean of the motion.
  double loss = 0.;
  for (std::size_t i = 1; i <= end; ++i)
  {
    const SlidingState &a = path.states[i - 1], &b = path.states[i];
    loss += (b.time - a.time) / 6. *
            (power(a.speed, a.omega) + power(b.speed, b.omega) +
             4. * power((a.speed + b.speed) / 2., (a.omega + b.omega) / 2.));
  }
  EXPECT_NEAR(loss, path.states[end].friction_loss, 1e-6 * loss);
}

// Other code: integration of the friction of a ring and a disc in elliptic integrals. R = 30 mm, mu g = 2.943
// m/s^2, 20 rad/s at the start.
TEST(FreeSliding, TimeDistanceAndTurnsToTheStop)
{
  struct Row
  {
    SlidingBody body;
    double inertia; ///< over m R^2
    double speed, time, distance, turns;
  };
  const SlidingBody ring = SlidingBody::ring(0.03), disc = SlidingBody::disc(0.03);
  for (const Row &row : { Row{ ring, 1, 1, 0.433690092820, 0.202232922128, 0.782860723683 },
                          Row{ ring, 1, 0.6, 0.320243899449, 0.096073169835, 0.509683995923 },
                          Row{ ring, 1, 0.1, 0.211519534404, 0.013714514923, 0.329017871338 },
                          Row{ disc, 0.5, 1, 0.394384128673, 0.185899327455, 0.749733928188 },
                          Row{ disc, 0.5, 0.6, 0.273251433663, 0.077969079405, 0.469893865146 } })
  {
    const SlidingState stop =
      slide_to_stop(FreeSlider{ row.body, 0.3, row.inertia * 0.3 * 9e-4, 0.3 }, row.speed, 20).states.back();
    EXPECT_NEAR(stop.time, row.time, 2e-12) << row.speed;
    EXPECT_NEAR(stop.distance, row.distance, 2e-12) << row.speed;
    EXPECT_NEAR(stop.yaw / (2 * pi), row.turns, 2e-12) << row.speed;
  }
}

TEST(FreeSliding, ADriftingRingFollowsTheClosedFormOfSlowSpin)
{
  // a_y = -mu^2 g (h / R) eps for small eps. With I = m R^2 (1/2 - (mu h / R)^2) the ratio eps stays, and
  // the path ends at y = -eps (h / R) v_0^2 / (4 g).
  const double mu = 0.2, radius = 0.03, height = 0.05, eps = 1e-4, gravity = 9.81, speed = 1.3;
  const double gamma = 0.5 - std::pow(mu * height / radius, 2);
  const FreeSlider ring{ SlidingBody::ring(radius), 0.3, 0.3 * radius * radius * gamma, mu, gravity, height };
  const Wrench friction = sliding_friction(ring, speed, eps * speed / radius);
  expect_relative(friction.force_y / 0.3, -mu * mu * gravity * height / radius * eps, 1e-7, "a_y");
  const auto path = slide_to_stop(ring, speed, eps * speed / radius);
  expect_relative(path.states.back().y, -eps * height / radius * speed * speed / (4. * gravity), 1e-6, "y");
}

TEST(FreeSliding, HertzPressureHasItsClosedForms)
{
  const auto root = [](const std::vector<double> &radii)
  {
    std::vector<double> values;
    for (const double r : radii)
      values.push_back(7. * std::sqrt(1. - r * r));
    return values;
  };
  const SlidingBody body = SlidingBody::with_pressure(root, 0., 1.);
  EXPECT_NEAR(body.mean_square_radius(), 0.4, 1e-14);
  EXPECT_NEAR(body.mean_power(-1.), 0.75 * pi, 1e-12);
  EXPECT_NEAR(sliding_friction(unit_slider(body, 0.4), 0., 2.).torque, -3. * pi / 16., 1e-13);
  EXPECT_NEAR(sliding_friction(unit_slider(body, 0.4), 2., 0.).force_x, -1., 1e-13);
}

TEST(FreeSliding, UniformPressureIsTheAnnulus)
{
  const auto one = [](const std::vector<double> &radii) { return std::vector<double>(radii.size(), 3.); };
  FreeSlider given = unit_slider(SlidingBody::with_pressure(one, 0.4, 1.), 0.5),
             annulus = unit_slider(SlidingBody::annulus(0.4, 1.), 0.5);
  given.centre_of_mass_height = annulus.centre_of_mass_height = 0.2;
  for (const double omega : { -7., -1.6, -1., -0.3, 0., 0.9, 1.00001, 2.5 })
  {
    const Wrench found = sliding_friction(given, 1., omega), exact = sliding_friction(annulus, 1., omega);
    EXPECT_NEAR(found.torque, exact.torque, 1e-13) << omega;
    EXPECT_NEAR(found.force_x, exact.force_x, 1e-13) << omega;
    EXPECT_NEAR(found.force_y, exact.force_y, 1e-13) << omega;
  }
}

TEST(FreeSliding, WithoutSpeedItSpinsOnItsPlace)
{
  // Constant torque -2/3: omega falls in a straight line.
  const SlidingPath path = slide_to_stop(unit_slider(SlidingBody::disc(1.), 0.5), 0., -3.);
  EXPECT_NEAR(path.states.back().time, 3. * 0.5 * 1.5, 1e-11);
  EXPECT_NEAR(path.states.back().yaw, -0.5 * 3. * 3. * 0.5 * 1.5, 1e-11);
  EXPECT_NEAR(path.states.back().friction_loss, 0.5 * 0.5 * 9., 1e-11);
  EXPECT_EQ(path.final_slip_ratio, -std::numeric_limits<double>::infinity());
  for (const SlidingState &state : path.states)
  {
    EXPECT_EQ(state.speed, 0.);
    EXPECT_TRUE(std::isnan(state.heading));
  }
}

TEST(FreeSliding, RefusesBadInput)
{
  EXPECT_THROW(SlidingBody::ring(0.), std::invalid_argument);
  EXPECT_THROW(SlidingBody::annulus(0.5, 0.5), std::invalid_argument);
  EXPECT_THROW(SlidingBody::annulus(-0.1, 0.5), std::invalid_argument);
  const FreeSlider ring = unit_slider(SlidingBody::ring(1.), 1.);
  EXPECT_THROW(slide_to_stop(ring, 0., 0.), std::invalid_argument);
  EXPECT_THROW(slide_to_stop(ring, -1., 1.), std::invalid_argument);
  const auto pressure = [](double value)
  { return [value](const std::vector<double> &radii) { return std::vector<double>(radii.size(), value); }; };
  EXPECT_THROW(SlidingBody::with_pressure(pressure(0.), 0., 1.), std::invalid_argument);
  EXPECT_THROW(SlidingBody::with_pressure(pressure(-1.), 0., 1.), std::invalid_argument);
  EXPECT_THROW(SlidingBody::with_pressure(pressure(1.), 1., 1.), std::invalid_argument);
  EXPECT_THROW(SlidingBody::with_pressure({}, 0., 1.), std::invalid_argument);
  EXPECT_THROW(slide_to_stop(ring, 1., std::numeric_limits<double>::quiet_NaN()), std::invalid_argument);
  EXPECT_THROW(slide_to_stop(unit_slider(SlidingBody::ring(1.), 0.), 1., 1.), std::invalid_argument);
  EXPECT_THROW(sliding_friction(ring, 0., 0.), std::invalid_argument);
}
} // namespace
} // namespace stemware::ring
