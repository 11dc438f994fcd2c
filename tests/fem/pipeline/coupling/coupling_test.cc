// Loads in balance with friction at every spin: balances from their neighbours, curves between samples.
#include "fem/pipeline/coupling/balanced_states.h"
#include "fem/pipeline/coupling/load_curve.h"
#include "ring_model/unilateral_foundation.h"

#include <gtest/gtest.h>

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
  ring::RingStack load(double normal_force, const Eigen::Vector2d &moment) const override
  {
    ++n_loads;
    return UnilateralFoundation::load(normal_force, moment);
  }
  mutable unsigned int n_loads = 0;
};

/// Loads of the rim over the moment ratio.
ring::RingStack rim_load(double moment_ratio)
{
  return ring::UnilateralFoundation(rim, 1.5).load(weight, { 0, -moment_ratio * weight * rim / 2 });
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
        EXPECT_LE(load_difference(load(m), rim_load(m)), curve.error) << m;
      }
    }
}

TEST(LoadCurve, TakesMoreSamplesOnlyWhereTheyAreNeeded)
{
  const LoadCurve smooth = sample_load_curve(rim_load, 0, 0.7, 1e-6, 100);
  EXPECT_EQ(smooth.pieces.size(), 1u);
  EXPECT_EQ(smooth.n_samples, 17u);
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

TEST(LoadCurve, DifferenceSeesEveryPartOfALoad)
{
  const ring::RingStack load({ 0.5, 0.1, 0.02 }, { 0, 0.2, 0.03 }, rim);
  EXPECT_EQ(load_difference(load, load), 0);
  EXPECT_NEAR(load_difference({ { 0.5, 0.1, 0.03 }, { 0, 0.2, 0.03 }, rim }, load), 0.02, 1e-15);
  EXPECT_NEAR(load_difference({ { 0.5, 0.1, 0.02 }, { 0, 0.2, 0.02 }, rim }, load), 0.02, 1e-15);
  EXPECT_NEAR(load_difference({ { 0.5, 0.1, 0.02 }, { 0, 0.2, 0.03 }, 1.01 * rim }, load), 0.01, 1e-15);
  EXPECT_NEAR(load_difference({ { 0.5, 0.1 }, { 0, 0.2 }, rim }, load), 0.06, 1e-15);
}

} // namespace
} // namespace stemware::pipeline
