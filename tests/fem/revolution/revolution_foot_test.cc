// The foot as an answer to loads: hard tables, imperfections, warm starts, and the spin that the elastic
// glass reaches.
#include "fem/contact/hard_interface.h"
#include "fem/meridian/meshed_revolution_foot.h"
#include "ring_model/moment_balance.h"
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
  setup.table = { std::make_shared<HardInterface>(), Substrate() };
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

  ring::RingStack rings(double normal_force, const Eigen::Vector2d &moment) const override
  {
    return foot.solve({ normal_force, moment(0), moment(1) }, { spin_per_speed, {} }).load;
  }
  double radius() const override { return 0.03; }

  MeshedRevolutionFoot foot;
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
  MeshedRevolutionFoot foot(hardwood());
  const ContactLoad load = foot.solve(load_at(1.2)).load;
  EXPECT_NEAR(load.a(2) / load.a(0), 0.048, 3e-3);
  EXPECT_NEAR(load.a(3) / load.a(0), -0.112, 3e-3);
  EXPECT_NEAR(load.a(4) / load.a(0), 0.087, 3e-3);
  const ContactLoad light = foot.solve(load_at(0.5)).load;
  EXPECT_LT(std::abs(light.a(2) / light.a(0)), 5e-4);
}

TEST(HardwoodTable, FrictionDecidesTheSecondHarmonic)
{
  RevolutionSetup setup = hardwood();
  setup.friction_coefficient = 0.3;
  MeshedRevolutionFoot foot(setup);
  const ContactLoad along = foot.solve(load_at(0.5)).load;
  EXPECT_NEAR(along.a(2) / along.a(0) / 0.0256, 1, 0.03);
  const ContactLoad against = foot.solve(load_at(0.5, M_PI)).load;
  EXPECT_NEAR(against.a(2) / against.a(0) / -0.0246, 1, 0.03);
}

TEST(RigidTable, FlatLandLiftsOff)
{
  RevolutionSetup setup;
  setup.profile = flat_profile();
  setup.table.interface = std::make_shared<HardInterface>();
  MeshedRevolutionFoot foot(setup.resolved_for(weight));
  const ContactLoad load = foot.solve(load_at(1.3)).load;
  EXPECT_NEAR(load.a(1) / load.a(0), 1.3434, 2e-3);
  EXPECT_NEAR(load.a(2) / load.a(0), 0.1705, 2e-3);
  EXPECT_NEAR(load.a(3) / load.a(0), -0.2852, 2e-3);
  EXPECT_NEAR(load.mean_radius, 0.02903, 1e-5);
}

TEST(RigidTable, ConvergesWherePenaltiesLeaveMoreRoundingThanTheTolerance)
{
  RevolutionSetup setup;
  setup.table.interface = std::make_shared<HardInterface>();
  setup.meridian.n_harmonics = 8;
  MeshedRevolutionFoot foot(setup.resolved_for(weight));
  const ContactState state = foot.solve(load_at(1.3));
  EXPECT_LT(state.solution.force_residual, 1e-9);
  EXPECT_LT(state.solution.moment_residual, 1e-9);
  EXPECT_NEAR(state.load.normal_force() / weight, 1, 1e-9);
}

/// b = sqrt(4 q rho / (pi E*)), q = N / (2 pi R) = 15.613 N/m: 0.9 um on a rigid table, 2.5 um on hardwood.
TEST(HardTable, CellsAreHalfTheHertzHalfWidth)
{
  RevolutionSetup rigid;
  rigid.table.interface = std::make_shared<HardInterface>();
  RevolutionSetup wood = rigid;
  wood.table.substrate = Substrate();
  const double line_load = weight / (2 * M_PI * 0.03);
  const double glass_compliance = (1 - 0.22 * 0.22) / 70e9;
  const ElasticMaterial &substrate = wood.table.substrate->material;
  const double wood_compliance =
    (1 - substrate.poisson_ratio * substrate.poisson_ratio) / substrate.young_modulus;
  const auto half_width = [&](double compliance)
  { return std::sqrt(4 * line_load * 0.003 * compliance / M_PI); };
  EXPECT_NEAR(hertz_half_width(rigid, weight) / half_width(glass_compliance), 1, 1e-12);
  EXPECT_NEAR(hertz_half_width(wood, weight) / half_width(glass_compliance + wood_compliance), 1, 1e-12);
  EXPECT_NEAR(hertz_half_width(rigid, weight), 0.9e-6, 0.02e-6);
  for (RevolutionSetup setup : { rigid, wood })
  {
    setup.meridian.n_harmonics = 1;
    const double wanted = hertz_half_width(setup, weight) / 2;
    const MeshedRevolutionFoot foot(setup.resolved_for(weight));
    const Eigen::VectorXd &radii = foot.elastic_body().contact_compliance().radii;
    const unsigned int degree = foot.elastic_body().contact_compliance().degree;
    double smallest = 1;
    for (Eigen::Index i = 0; i + degree < radii.size(); i += degree)
      smallest = std::min(smallest, radii(i + degree) - radii(i));
    EXPECT_LE(smallest, wanted * (1 + 1e-9));
    EXPECT_GT(smallest, wanted / 3 * (1 - 1e-9)); // a sixth of the half-width
  }
}

/// Hertz's ellipse by quadrature: R_y / R_x = (k^2 E - K) / (K - E), b^3 = 3 P E(e) R' / (pi k E*).
TEST(HardTable, CrestsAreAsWideAsHertzsEllipse)
{
  constexpr double slenderness = 300;
  constexpr int n_points = 100000;
  double first = 0, second = 0; // complete elliptic integrals K, E
  for (int i = 0; i < n_points; ++i)
  {
    const double angle = (i + 0.5) / n_points * M_PI_2;
    const double root = std::sqrt(std::pow(std::cos(angle), 2) + std::pow(std::sin(angle) / slenderness, 2));
    first += M_PI_2 / n_points / root;
    second += M_PI_2 / n_points * root;
  }
  const double across = 0.003;
  const double along = across * (slenderness * slenderness * second - first) / (first - second);
  RevolutionSetup setup;
  setup.table.interface = std::make_shared<HardInterface>();
  EXPECT_EQ(crest_half_width(setup, weight), 0);
  setup.imperfection.glass = { { 3, 0.6 * 0.03 * 0.03 / along / 9, 0.1 } };
  setup.imperfection.table = { { 5, 0.8 * 0.03 * 0.03 / along / 25, 0 } };
  const double compliance = (1 - 0.22 * 0.22) / 70e9;
  const double cube = weight * second * compliance /
                      (M_PI * slenderness * (1 / across + 1 / along)); // of a third of the weight
  EXPECT_NEAR(crest_half_width(setup, weight) / std::cbrt(cube), 1, 1e-6);
  const double even = hertz_half_width(setup, weight), crest = crest_half_width(setup, weight);
  EXPECT_GT(crest, even);
  EXPECT_NEAR(expected_half_width(setup, weight) / std::sqrt(even * crest), 1, 1e-12);
}

TEST(HardwoodTable, HalvingsSplitEveryCellTheFinestToo)
{
  RevolutionSetup setup;
  setup.table = { std::make_shared<HardInterface>(), Substrate() };
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

TEST(RevolutionFoot, WarmAndColdAgreeInEveryDirection)
{
  const RevolutionSetup setup;
  const MeshedRevolutionFoot warm(setup);
  std::optional<ContactState> before;
  for (const double m : { 0.3, 0.6, 1.25, 1.6 })
  {
    MeshedRevolutionFoot cold(setup);
    const ContactState from_rest = cold.solve(load_at(m, 2 * m));
    const ContactState from_before = warm.solve(load_at(m, 2 * m), {}, { before ? &*before : nullptr });
    before = from_before;
    const ContactLoad &expected = from_rest.load;
    const ContactLoad &load = from_before.load;
    for (unsigned int n = 0; n <= 8; ++n)
    {
      EXPECT_NEAR(load.a(n), expected.a(n), 1e-9 * expected.a(0));
      EXPECT_NEAR(load.b(n), expected.b(n), 1e-9 * expected.a(0));
    }
  }
  // From its own solution, where a foot that begins at rest takes several steps.
  EXPECT_EQ(warm.solve(load_at(1.6, 3.2), {}, { &*before }).solution.n_iterations, 1u);
  EXPECT_GT(MeshedRevolutionFoot(setup).solve(load_at(1.6, 3.2)).solution.n_iterations, 1u);
}

TEST(RevolutionFoot, SaysThatTheFootTips)
{
  MeshedRevolutionFoot foot{ RevolutionSetup() };
  foot.solve(load_at(0.5));
  try
  {
    foot.solve(load_at(2.3));
    FAIL() << "a foot that tips was in equilibrium";
  }
  catch (const ContactFailure &failure)
  {
    EXPECT_EQ(failure.outcome, ContactOutcome::tipping);
  }
  EXPECT_NO_THROW(foot.solve(load_at(0.5)));
}

TEST(Imperfection, HasItsCrestsWhereItSays)
{
  const RimImperfection rim = { { { 3, 2e-6, 0.4 } }, {} };
  for (const unsigned int crest : { 0u, 1u, 2u })
  {
    EXPECT_NEAR(rim.gap(1, 0.4 + 2 * M_PI * crest / 3, 0, 0), 2e-6, 1e-20);
    EXPECT_NEAR(rim.gap(1, 0.4 + 2 * M_PI * (crest + 0.5) / 3, 0, 0), -2e-6, 1e-20);
  }
}

TEST(Imperfection, OffsetAndTiltChangeNothing)
{
  RevolutionSetup setup;
  MeshedRevolutionFoot perfect(setup);
  setup.imperfection.table = { { 0, 2e-4, 0 }, { 1, 1.1e-4, -0.46 } };
  MeshedRevolutionFoot tilted(setup);
  const ContactLoad expected = perfect.solve(load_at(1.1)).load;
  const ContactLoad load = tilted.solve(load_at(1.1), { 0, { 0.3, 0.7 } }).load;
  for (unsigned int n = 0; n <= 8; ++n)
  {
    EXPECT_NEAR(load.a(n), expected.a(n), 1e-9 * expected.a(0));
    EXPECT_NEAR(load.b(n), expected.b(n), 1e-9 * expected.a(0));
  }
}

TEST(Imperfection, TurnsWithGlassAndTable)
{
  RevolutionSetup setup;
  setup.imperfection.glass = { { 2, 3e-7, 0 } };
  MeshedRevolutionFoot glass(setup);
  setup.imperfection.table = { { 2, 3e-7, 0 } };
  setup.imperfection.glass.clear();
  MeshedRevolutionFoot table(setup);
  const double angle = 2 * M_PI * 21 / 256;
  const ContactLoad still = glass.solve(load_at(0.4)).load;
  EXPECT_GT(std::abs(still.a(2) / still.a(0)), 1e-3);
  // Glass, load and all turned together: the same load, turned.
  const ContactLoad turned = glass.solve(load_at(0.4, angle), { 0, { angle, 0 } }).load;
  EXPECT_NEAR(turned.a(2), still.a(2) * std::cos(2 * angle) - still.b(2) * std::sin(2 * angle),
              1e-8 * still.a(0));
  EXPECT_NEAR(turned.b(2), still.a(2) * std::sin(2 * angle) + still.b(2) * std::cos(2 * angle),
              1e-8 * still.a(0));
  // The same bump in the table at the same place does the same.
  const ContactLoad below = table.solve(load_at(0.4, angle), { 0, { 0, angle } }).load;
  EXPECT_NEAR(below.a(2), turned.a(2), 1e-8 * still.a(0));
}

TEST(RevolutionFoot, StatesOutliveTheNextSolution)
{
  // Each with marks of its own: an imperfect rim presses elsewhere when it has turned.
  const std::shared_ptr<const InterfaceLaw> interfaces[] = { std::make_shared<WinklerInterface>(),
                                                             std::make_shared<HardInterface>() };
  for (const auto &interface : interfaces)
  {
    RevolutionSetup setup;
    setup.table.interface = interface;
    setup.imperfection.glass = { { 2, 3e-7, 0 } };
    setup.meridian.n_harmonics = 8;
    MeshedRevolutionFoot foot(setup.resolved_for(weight));
    const ContactState first = foot.solve(load_at(0.4), { 0, { 0.5, 0 } });
    const double peak = foot.pressure_map(first).cuts[3][4].pressure;
    const std::string fields = foot.fields(first).front().text;
    foot.solve(load_at(0.9, 1.), { 0, { 2., 0 } });
    const ContactLoad sums = harmonics_of(foot.point_forces(first), 4);
    for (unsigned int n = 0; n <= 4; ++n)
    {
      // The pressure's points and the forces that the body answers to differ by the equilibrium's tolerance.
      EXPECT_NEAR(sums.a(n), first.load.a(n), 1e-9 * first.load.a(0)) << n;
      EXPECT_NEAR(sums.b(n), first.load.b(n), 1e-9 * first.load.a(0)) << n;
    }
    EXPECT_EQ(foot.pressure_map(first).cuts[3][4].pressure, peak);
    EXPECT_EQ(foot.fields(first).front().text, fields);
  }
}

TEST(RevolutionFoot, PointForcesStandInTheSlipFrame)
{
  MeshedRevolutionFoot foot{ RevolutionSetup() };
  EXPECT_FALSE(foot.capabilities().is_collective);
  const Resultants load = load_at(0.8, 2.);
  const ContactState state = foot.solve(load);
  const ContactLoad sums = harmonics_of(foot.point_forces(state), 3);
  EXPECT_NEAR(sums.moment().x() / load.moment_x, 1, 1e-9);
  EXPECT_NEAR(sums.moment().y() / load.moment_y, 1, 1e-9);
  EXPECT_NEAR(sums.b(3), state.load.b(3), 1e-12 * state.load.a(0));
}
