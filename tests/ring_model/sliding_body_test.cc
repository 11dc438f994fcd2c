#include "ring_model/load/constants.h"
#include "ring_model/sliding_body.h"
#include "tests/ring_model/reference.h"
#include "tests/ulps.h"

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_2.hpp>

#include <stdexcept>

namespace stemware::ring
{
namespace
{

TEST(SlidingBody, AgreesWithTheReferenceForAUniformRing)
{
  const auto &rows = reference()["literature"]["ring_uniform"];
  for (std::size_t i = 0; i < rows["eps"].size(); ++i)
  {
    const Wrench friction = SlidingBody::ring(1.).friction(1., 1., rows["eps"][i]);
    EXPECT_NEAR(-friction.force_x, rows["f"][i].get<double>(), ulps(9, 1));
    EXPECT_NEAR(-friction.torque, rows["t"][i].get<double>(), ulps(9, 1));
    EXPECT_EQ(friction.force_y, 0.);
  }
}

TEST(SlidingBody, AgreesWithTheReferenceForAnAnnulus)
{
  for (const auto &row : reference()["literature"]["annulus_free_terminal"]["rows"])
  {
    const SlidingBody body = SlidingBody::annulus(row["eta"], 1.);
    expect_relative(body.mean_power(2.), row["gamma"], 1e-15, "gamma");
    const Wrench friction = body.friction(1., 1., row["eps0_omegaR_over_v"]);
    const std::string name = "eta " + std::to_string(row["eta"].get<double>());
    expect_relative(-friction.force_x, row["f"], 1e-13, name + " f");
    expect_relative(-friction.torque, row["t"], 1e-13, name + " t");
  }
}

TEST(SlidingBody, DiscAgreesWithReferenceAndClosedForms)
{
  const SlidingBody disc = SlidingBody::disc(1.);
  for (const auto &row : reference()["literature"]["disc_uniform"]["rows"])
  {
    const Wrench friction = disc.friction(1., row["v_over_omegaR"], 1.);
    expect_relative(-friction.force_x, row["f"], 1e-14, "f");
    expect_relative(-friction.torque, row["t"], 1e-14, "t");
  }
  // Reference: closed forms in complete elliptic integrals of modulus v/(omega R) <= 1.
  for (const double e : { 0.05, 0.3, 0.7, 0.95 })
  {
    const double K = boost::math::ellint_1(e), E = boost::math::ellint_2(e);
    const Wrench friction = disc.friction(1., e, 1.);
    expect_relative(-friction.force_x, 4. / (3. * pi * e) * ((e * e + 1.) * E + (e * e - 1.) * K), 1e-12,
                    "f");
    expect_relative(-friction.torque, 4. / (9. * pi) * ((4. - 2. * e * e) * E + (e * e - 1.) * K), 1e-13,
                    "t");
  }
}

TEST(SlidingBody, AgreesWithTheClosedFormsUnderHertzPressure)
{
  const auto root = [](const std::vector<double> &radii)
  {
    std::vector<double> values;
    for (const double r : radii)
      values.push_back(7. * std::sqrt(1. - r * r));
    return values;
  };
  const SlidingBody body = SlidingBody::with_pressure(root, 0., 1.);
  EXPECT_NEAR(body.mean_power(2.), 0.4, 1e-14);
  EXPECT_NEAR(body.mean_power(-1.), 0.75 * pi, 1e-12);
  EXPECT_NEAR(body.friction(1., 0., 2.).torque, -3. * pi / 16., 1e-13);
  EXPECT_NEAR(body.friction(1., 2., 0.).force_x, -1., 1e-13);
}

TEST(SlidingBody, RefusesInvalidRadiiPressuresAndVelocities)
{
  EXPECT_THROW(SlidingBody::ring(0.), std::invalid_argument);
  EXPECT_THROW(SlidingBody::annulus(0.5, 0.5), std::invalid_argument);
  EXPECT_THROW(SlidingBody::annulus(-0.1, 0.5), std::invalid_argument);
  const auto pressure = [](double value)
  { return [value](const std::vector<double> &radii) { return std::vector<double>(radii.size(), value); }; };
  EXPECT_THROW(SlidingBody::with_pressure(pressure(0.), 0., 1.), std::invalid_argument);
  EXPECT_THROW(SlidingBody::with_pressure(pressure(-1.), 0., 1.), std::invalid_argument);
  EXPECT_THROW(SlidingBody::with_pressure(pressure(1.), 1., 1.), std::invalid_argument);
  EXPECT_THROW(SlidingBody::with_pressure({}, 0., 1.), std::invalid_argument);
  EXPECT_THROW(SlidingBody::ring(1.).friction(1., 0., 0.), std::invalid_argument);
  EXPECT_THROW(SlidingBody::ring(1.).friction(0., 1., 1.), std::invalid_argument);
}
} // namespace
} // namespace stemware::ring
