// The foot as an answer to loads: hard tables, imperfections, warm starts, and the spin that the elastic
// glass reaches.
#include "fem/revolution/revolution_foot.h"
#include "ring_model/closures.h"
#include "ring_model/self_consistent_ring.h"
#include "tests/fem/revolution/revolution_case.h"

#include <deal.II/grid/grid_tools.h>

#include <gtest/gtest.h>

using namespace stemware::revolution_tests;
namespace ring = stemware::ring;

namespace
{

RevolutionSetup hardwood()
{
  RevolutionSetup setup;
  setup.support = TableSupport::elastic;
  return setup.resolved_for(weight);
}

/// A finite-element foot as a load of the ring, pressed at a given spin.
class ElasticLoad : public ring::LoadModel
{
public:
  explicit ElasticLoad(const RevolutionSetup &setup)
      : foot(setup)
  {
  }

  ring::RingStack load(double normal_force, const Eigen::Vector2d &moment) const override
  {
    const LoadHarmonics pressed = foot.press({ normal_force, moment(0), moment(1) }, {}, spin_per_speed);
    return ring::RingStack(pressed.a, pressed.b, pressed.ring_radius);
  }
  double radius() const override { return 0.03; }
  double lift_off_ratio() const override { return 1.2; }

  mutable FootResponse foot;
  double spin_per_speed = 0;
};

/// Spin at which the yaw torque of the default glass vanishes, the table's friction field following the spin
/// [rad/s].
double terminal_spin(const RevolutionSetup &setup)
{
  ring::Motion motion;
  motion.centre_of_mass_height = 0.08;
  const auto load = std::make_shared<ElasticLoad>(setup);
  const ring::SelfConsistentRing glass(ring::Closure::full, motion, load);
  const auto torque = [&](double omega)
  {
    load->spin_per_speed = omega / motion.orbit_speed;
    return glass.torque(omega);
  };
  double before = -3.5;
  double now = -3.7;
  double torque_before = torque(before);
  for (unsigned int i = 0; i < 20 && std::abs(now - before) > 1e-8; ++i)
  {
    const double torque_now = torque(now);
    const double next = now - torque_now * (now - before) / (torque_now - torque_before);
    before = now;
    torque_before = torque_now;
    now = next;
  }
  return now;
}

} // namespace

TEST(HardwoodTable, HarmonicsWithoutFriction)
{
  FootResponse foot(hardwood());
  const LoadHarmonics load = foot.press(load_at(1.2));
  EXPECT_NEAR(load.a[2] / load.a[0], 0.048, 3e-3);
  EXPECT_NEAR(load.a[3] / load.a[0], -0.112, 3e-3);
  EXPECT_NEAR(load.a[4] / load.a[0], 0.087, 3e-3);
  const LoadHarmonics light = foot.press(load_at(0.5));
  EXPECT_LT(std::abs(light.a[2] / light.a[0]), 5e-4);
}

TEST(HardwoodTable, FrictionDecidesTheSecondHarmonic)
{
  RevolutionSetup setup = hardwood();
  setup.friction_coefficient = 0.3;
  FootResponse foot(setup);
  const LoadHarmonics along = foot.press(load_at(0.5));
  EXPECT_NEAR(along.a[2] / along.a[0] / 0.0256, 1, 0.03);
  const LoadHarmonics against = foot.press(load_at(0.5, M_PI));
  EXPECT_NEAR(against.a[2] / against.a[0] / -0.0246, 1, 0.03);
}

TEST(RigidTable, FlatLandLiftsOff)
{
  RevolutionSetup setup;
  setup.profile = flat_profile();
  setup.support = TableSupport::rigid;
  FootResponse foot(setup.resolved_for(weight));
  const LoadHarmonics load = foot.press(load_at(1.3));
  EXPECT_NEAR(load.a[1] / load.a[0], 1.3434, 2e-3);
  EXPECT_NEAR(load.a[2] / load.a[0], 0.1705, 2e-3);
  EXPECT_NEAR(load.a[3] / load.a[0], -0.2852, 2e-3);
  EXPECT_NEAR(load.mean_radius, 0.02903, 1e-5);
}

TEST(RigidTable, ConvergesWherePenaltiesLeaveMoreRoundingThanTheTolerance)
{
  RevolutionSetup setup;
  setup.support = TableSupport::rigid;
  setup.meridian.n_harmonics = 8;
  FootResponse foot(setup.resolved_for(weight));
  const LoadHarmonics load = foot.press(load_at(1.3));
  EXPECT_LT(foot.solution().force_residual, 1e-9);
  EXPECT_LT(foot.solution().moment_residual, 1e-9);
  EXPECT_NEAR(load.normal_force / weight, 1, 1e-9);
}

TEST(HardwoodTable, HalvingsSplitEveryCellTheFinestToo)
{
  RevolutionSetup setup;
  setup.support = TableSupport::elastic;
  const RevolutionSetup coarse = setup.resolved_for(weight);
  setup.resolution.refinements = 1;
  const RevolutionSetup fine = setup.resolved_for(weight);
  dealii::Triangulation<2> coarse_mesh;
  dealii::Triangulation<2> fine_mesh;
  make_meridian_mesh(coarse.profile, coarse.resolution, coarse_mesh);
  make_meridian_mesh(fine.profile, fine.resolution, fine_mesh);
  EXPECT_EQ(fine_mesh.n_active_cells(), 4 * coarse_mesh.n_active_cells());
  EXPECT_NEAR(dealii::GridTools::minimal_cell_diameter(fine_mesh) /
                dealii::GridTools::minimal_cell_diameter(coarse_mesh),
              0.5, 1e-9);
}

TEST(CoupledSpin, TerminalSpinOfTheElasticGlass)
{
  RevolutionSetup setup;
  EXPECT_NEAR(terminal_spin(setup), -3.6490, 2e-4);
  setup.friction_coefficient = 0.3;
  EXPECT_NEAR(terminal_spin(setup), -3.6475, 2e-4);
}

TEST(FootResponse, WarmAndColdAgreeInEveryDirection)
{
  const RevolutionSetup setup;
  FootResponse warm(setup);
  for (const double m : { 0.3, 0.6, 1.25, 1.6 })
  {
    FootResponse cold(setup);
    const LoadHarmonics expected = cold.press(load_at(m, 2 * m));
    const LoadHarmonics load = warm.press(load_at(m, 2 * m));
    for (unsigned int n = 0; n <= 8; ++n)
    {
      EXPECT_NEAR(load.a[n], expected.a[n], 1e-9 * expected.a[0]);
      EXPECT_NEAR(load.b[n], expected.b[n], 1e-9 * expected.a[0]);
    }
  }
  EXPECT_EQ(warm.n_cold_starts(), 1u);
}

TEST(FootResponse, SaysThatTheFootTips)
{
  FootResponse foot{ RevolutionSetup() };
  foot.press(load_at(0.5));
  try
  {
    foot.press(load_at(2.3));
    FAIL() << "a foot that tips was in equilibrium";
  }
  catch (const ContactFailure &failure)
  {
    EXPECT_EQ(failure.outcome, ContactOutcome::tipping);
  }
  EXPECT_NO_THROW(foot.press(load_at(0.5)));
}

TEST(Imperfection, OffsetAndTiltChangeNothing)
{
  RevolutionSetup setup;
  FootResponse perfect(setup);
  setup.imperfection.table = { { 0, 2e-4, 0 }, { 1, 1e-4, -5e-5 } };
  FootResponse tilted(setup);
  const LoadHarmonics expected = perfect.press(load_at(1.1));
  const LoadHarmonics load = tilted.press(load_at(1.1), { 0.3, 0.7 });
  for (unsigned int n = 0; n <= 8; ++n)
  {
    EXPECT_NEAR(load.a[n], expected.a[n], 1e-9 * expected.a[0]);
    EXPECT_NEAR(load.b[n], expected.b[n], 1e-9 * expected.a[0]);
  }
}

TEST(Imperfection, TurnsWithGlassAndTable)
{
  RevolutionSetup setup;
  setup.imperfection.glass = { { 2, 3e-7, 0 } };
  FootResponse glass(setup);
  setup.imperfection.table = { { 2, 3e-7, 0 } };
  setup.imperfection.glass.clear();
  FootResponse table(setup);
  const double angle = 2 * M_PI * 21 / 256;
  const LoadHarmonics still = glass.press(load_at(0.4));
  EXPECT_GT(std::abs(still.a[2] / still.a[0]), 1e-3);
  // Glass, load and all turned together: the same load, turned.
  const LoadHarmonics turned = glass.press(load_at(0.4, angle), { angle, 0 });
  EXPECT_NEAR(turned.a[2], still.a[2] * std::cos(2 * angle) - still.b[2] * std::sin(2 * angle),
              1e-8 * still.a[0]);
  EXPECT_NEAR(turned.b[2], still.a[2] * std::sin(2 * angle) + still.b[2] * std::cos(2 * angle),
              1e-8 * still.a[0]);
  // The same bump in the table at the same place does the same.
  const LoadHarmonics below = table.press(load_at(0.4, angle), { 0, angle });
  EXPECT_NEAR(below.a[2], turned.a[2], 1e-8 * still.a[0]);
}
