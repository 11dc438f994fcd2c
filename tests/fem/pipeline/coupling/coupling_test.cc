// Loads in balance with friction at every spin: balances from their neighbours, curves between samples.
#include "fem/pipeline/coupling/balanced_load.h"
#include "fem/pipeline/coupling/balanced_states.h"
#include "fem/pipeline/coupling/load_curve.h"
#include "ring_model/unilateral_foundation.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace stemware::pipeline
{
namespace
{

constexpr double weight = 2.943; // N
constexpr double rim = 0.03;     // m

/// A rigid torus rim on a mat, which counts its loads.
class CountedFoundation : public ring::UnilateralFoundation
{
public:
  CountedFoundation()
      : UnilateralFoundation(rim, 1.5)
  {
  }
  ring::RingStack rings(double normal_force, const Eigen::Vector2d &moment,
                        const ring::Slip &slip = {}) const override
  {
    ++n_loads;
    return UnilateralFoundation::rings(normal_force, moment, slip);
  }
  mutable unsigned int n_loads = 0;
};

/// Loads of the rim over the moment ratio.
ring::RingStack rim_load(double moment_ratio)
{
  return ring::UnilateralFoundation(rim, 1.5).rings(weight, { 0, -moment_ratio * weight * rim / 2 });
}

/// What turns a glass about a horizontal axis through its centre of mass, by sums over points of the ring in
/// three dimensions: the normal forces of @p load, its friction, and the hand.
Eigen::Vector2d unbalanced_moment(const ring::RingStack &load, double omega, const ring::Motion &motion)
{
  constexpr unsigned int n_points = 4096;
  const Eigen::Vector3d k(0, 0, 1), centre = motion.centre_of_mass_height * k;
  Eigen::Vector3d moment(0, 0, 0), friction(0, 0, 0);
  for (unsigned int i = 0; i < n_points; ++i)
  {
    const double theta = 2 * std::acos(-1.) * (i + 0.5) / n_points;
    const Eigen::Vector3d place(rim * std::cos(theta), rim * std::sin(theta), 0);
    double line_load = load.a(0);
    for (unsigned int n = 1; n <= load.n_harmonics(); ++n)
      line_load += load.a(n) * std::cos(n * theta) + load.b(n) * std::sin(n * theta);
    const double normal = line_load * 2 * std::acos(-1.) / n_points;
    const Eigen::Vector3d slip = Eigen::Vector3d(motion.orbit_speed, 0, 0) + omega * k.cross(place);
    const Eigen::Vector3d tangential = -motion.friction_coefficient * normal * slip.normalized();
    friction += tangential;
    moment += (place - centre).cross(normal * k + tangential);
  }
  const double towards_centre = motion.mass * motion.orbit_speed * motion.orbit_speed / motion.orbit_radius;
  moment += motion.force_offset * k.cross(Eigen::Vector3d(0, towards_centre, 0) - friction);
  return moment.head<2>();
}

TEST(BalancedStates, AreThoseFoundFromScratchWithAThirdOfTheLoads)
{
  const ring::Motion motion;
  const double scale = motion.orbit_speed / rim;
  const auto counted = std::make_shared<CountedFoundation>();
  const ring::SelfConsistentRing alone(ring::Closure::full, motion,
                                       std::make_shared<ring::UnilateralFoundation>(rim, 1.5));
  BalancedStates states(ring::SelfConsistentRing(ring::Closure::full, motion, counted), scale);
  unsigned int n_loads_alone = 0;
  // A spin-up, then a scan of all spins; the second is far from the first, and passes |omega| R = v.
  std::vector<double> spins;
  for (int i = 0; i < 200; ++i)
    spins.push_back(-3.65 * (1 - std::exp(-i / 40.)));
  for (int i = -100; i <= 100; ++i)
    spins.push_back(1.5 * i / 100 * scale);
  for (const double omega : spins)
  {
    const ring::RingEquilibrium expected = alone.at(omega);
    n_loads_alone += expected.n_evaluations;
    const ring::RingEquilibrium &found = states.at(omega);
    EXPECT_LE((found.load.moment() - expected.load.moment()).norm(), 1e-14 * weight * rim) << omega;
    EXPECT_NEAR(found.friction.torque, expected.friction.torque, 1e-14 * weight * rim) << omega;
    if (states.size() % 25 == 0) // the rule is of first order where a point of the rim rests
    {
      EXPECT_LE(unbalanced_moment(found.load, omega, motion).norm(), 1e-6 * weight * rim) << omega;
    }
  }
  EXPECT_EQ(states.size(), 400u); // rest occurs twice
  EXPECT_LE(3 * counted->n_loads, 2 * n_loads_alone);
}

TEST(LoadCurve, StatesAnErrorThatHolds)
{
  // Beyond m = 1.2 the rim lifts off; the load is less smooth there, and takes more pieces.
  for (const double upper : { 1.1, 1.5 })
    for (const double tolerance : { 1e-4, 1e-7 })
    {
      const LoadCurve curve = sample_load_curve(rim_load, 0, upper, tolerance, 1000);
      EXPECT_LE(curve.error, tolerance);
      EXPECT_GT(curve.error, 0);
      const LoadFunction load = curve.interpolate();
      for (unsigned int i = 0; i <= 501; ++i)
      {
        const double m = upper * i / 501;
        EXPECT_LE(load(m).difference(rim_load(m)), curve.error) << m;
      }
    }
}

TEST(LoadCurve, TakesMoreSamplesOnlyWhereTheyAreNeeded)
{
  const LoadCurve smooth = sample_load_curve(rim_load, 0, 0.7, 1e-6, 100);
  EXPECT_EQ(smooth.pieces.size(), 1u);
  EXPECT_EQ(smooth.n_samples, 9u + 3u); // nodes and checks
  const LoadCurve kinked = sample_load_curve(rim_load, 0, 1.5, 1e-7, 1000);
  std::size_t n_near_the_kink = 0;
  for (const LoadSamples &piece : kinked.pieces)
    n_near_the_kink += piece.begin()->first < 1.3 && piece.rbegin()->first > 1.1 ? 1 : 0;
  EXPECT_GT(2 * n_near_the_kink, kinked.pieces.size());
}

TEST(LoadCurve, SaysWhenSamplesDoNotSuffice)
{
  EXPECT_THROW(sample_load_curve(rim_load, 0, 1.5, 1e-12, 60), ToleranceMissed);
}

/// A rigid round rim, stated to be so slow that its loads are interpolated.
class SlowFoundation : public ring::UnilateralFoundation
{
public:
  SlowFoundation()
      : UnilateralFoundation(rim, 1.5)
  {
  }
  bool is_costly() const override { return true; }
};

BalancedLoad balanced_rim(unsigned int n_harmonics = 1000, const ring::Motion &motion = {})
{
  const auto model = std::make_shared<SlowFoundation>();
  const LoadReport at_rest = report_of(
    model->rings(motion.normal_force(), ring::required_moment_at_rest(ring::Closure::full, motion)));
  return balance(model, { motion, ring::Closure::full, {} }, at_rest, n_harmonics);
}

TEST(BalancedLoad, CarriesWhatItsOwnFrictionAsksFor)
{
  // M_N = -dz k x F + z_CM k x T with F = m a - T, written out in three dimensions.
  const ring::Motion motion;
  const ring::CoulombRing friction(motion.friction_coefficient);
  for (const unsigned int n : { 1u, 3u, 1000u })
    for (const double omega : { 0., -3.6, 5. })
    {
      const ring::RingStack load = balanced_rim(n).at(omega);
      EXPECT_LE(load.n_harmonics(), n);
      const ring::Wrench wrench = friction.wrench(load, omega, motion.orbit_speed);
      const Eigen::Vector3d T(wrench.force_x, wrench.force_y, 0),
        F =
          Eigen::Vector3d(0, motion.mass * motion.orbit_speed * motion.orbit_speed / motion.orbit_radius, 0) -
          T,
        k(0, 0, 1);
      const Eigen::Vector3d expected =
        -motion.force_offset * k.cross(F) + motion.centre_of_mass_height * k.cross(T);
      EXPECT_NEAR((load.moment() - expected.head<2>()).norm(), 0, 1e-12 * weight * rim) << n << ' ' << omega;
    }
}

TEST(BalancedLoad, ATruncationHasABalanceOfItsOwn)
{
  const double omega = -3.6;
  const BalancedLoad two = balanced_rim(2);
  EXPECT_EQ(two.at(omega).n_harmonics(), 2u);
  // Cut off without another balance, it is the balance of all harmonics that loses some.
  EXPECT_EQ(balanced_rim().truncated(2).at(omega).a(1), balanced_rim().at(omega).a(1));
  EXPECT_NE(balanced_rim().truncated(2).at(omega).a(1), two.at(omega).a(1));
}

TEST(BalancedLoad, InterpolatesWithinTheErrorThatItStates)
{
  const BalancedLoad exact = balanced_rim(), curve = exact.interpolated(-4, 0.5);
  const double stated = *curve.statistics()->interpolation_error;
  EXPECT_LE(stated, 1e-9);
  for (double omega = -3.97; omega < 0.5; omega += 0.13)
    EXPECT_LE(curve.at(omega).difference(exact.at(omega)), stated) << omega;
  EXPECT_EQ(curve.at(2.5).difference(exact.at(2.5)), 0); // beyond the samples
  EXPECT_GT(curve.statistics()->n_balances, 17u);
}

TEST(BalancedLoad, ThatIsConstantLooksAtNothing)
{
  const ring::RingStack load({ 0.5, 0.1, 0.02 }, { 0, 0.2, 0.03 }, rim);
  const BalancedLoad constant({ report_of(load), {} });
  EXPECT_EQ(constant.at(-7).difference(load), 0);
  EXPECT_EQ(constant.at(3, { 0.4, 1.2 }).difference(load), 0);
  EXPECT_FALSE(constant.follows_spin());
  EXPECT_EQ(constant.phases(), nullptr);
}

} // namespace
} // namespace stemware::pipeline
