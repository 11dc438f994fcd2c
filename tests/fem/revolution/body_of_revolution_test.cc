// Exact properties of the body of revolution: no mixing of harmonics, rotation, rigid motions of the table,
// warm starts.
#include "fem/meridian/compute_compliance.h"
#include "tests/fem/revolution/revolution_case.h"

#include <gtest/gtest.h>

using namespace stemware::revolution_tests;

namespace
{

/// Largest difference of two loads' harmonics, over a_0, when @p rotated is turned back by @p angle.
double difference(const ContactLoad &load, const ContactLoad &rotated, double angle)
{
  double largest = 0;
  for (unsigned int n = 0; n <= load.n_harmonics(); ++n)
  {
    const double c = std::cos(n * angle);
    const double s = std::sin(n * angle);
    largest = std::max(largest, std::abs(rotated.a(n) * c + rotated.b(n) * s - load.a(n)));
    largest = std::max(largest, std::abs(rotated.b(n) * c - rotated.a(n) * s - load.b(n)));
  }
  return largest / load.a(0);
}

} // namespace

TEST(BodyOfRevolution, FlatFootInFullContactMixesNoHarmonics)
{
  RevolutionCase foot(flat_profile(), foot_compliance(flat_profile(), equal_cells()));
  for (const double modulus : { 1e9, 1e10, 1e11 })
  {
    const ContactLoad load = foot.solve_on_winkler(modulus, load_at(0.4, 0.3), 16);
    for (unsigned int n = 2; n <= 16; ++n)
      EXPECT_LT(std::hypot(load.a(n), load.b(n)) / load.a(0), 1e-12) << "n = " << n << ", k = " << modulus;
    EXPECT_EQ(load.contact_fraction, 1);
  }
}

TEST(BodyOfRevolution, ShortCutsOfItsLinesChangeNothing)
{
  // The same surface without mirrored lines, and with the products of shapes written out.
  const GlassProfile profile;
  const RevolutionCase foot(profile, foot_compliance(profile, graded_cells()), 64);
  const ContactSurface &surface = foot.body.contact_surface();
  ContactSurface plain = surface;
  plain.mirrored_lines.clear();
  for (ContactLine &line : plain.lines)
  {
    ASSERT_TRUE(line.samples_are_nodes);
    line.samples_are_nodes = false;
  }
  ASSERT_EQ(surface.mirrored_lines.size(), surface.lines.size());
  const auto law = make_law(WinklerInterface(1e10), surface);
  const auto plain_law = make_law(WinklerInterface(1e10), plain);
  for (const double tilt_across : { 0., 1e-4 }) // even in theta, and not
  {
    Eigen::VectorXd normal_displacement =
      -2e-4 * surface.node_position.col(0) - tilt_across * surface.node_position.col(1);
    normal_displacement.array() -= 3e-6;
    ContactForces response, expected;
    for (unsigned int repetition = 0; repetition < 2; ++repetition) // the second one refills
      law->evaluate(normal_displacement, response);
    plain_law->evaluate(normal_displacement, expected);
    ASSERT_GT(expected.forces.maxCoeff(), 0);
    EXPECT_NE(std::count(expected.active_set.begin(), expected.active_set.end(), false), 0);
    EXPECT_EQ(response.active_set, expected.active_set);
    EXPECT_LT((response.forces - expected.forces).cwiseAbs().maxCoeff(), 1e-14 * expected.forces.maxCoeff());
    const Eigen::MatrixXd tangent(expected.tangent);
    EXPECT_LT((Eigen::MatrixXd(response.tangent) - tangent).cwiseAbs().maxCoeff(),
              1e-14 * tangent.maxCoeff());
  }
}

TEST(BodyOfRevolution, LoadTurnsWithTheMoment)
{
  const GlassProfile profile;
  RevolutionCase foot(profile, foot_compliance(profile, graded_cells()));
  const double angle =
    2 * M_PI * 37 / 256; // from one azimuth line to another: equal quadrature, and no line of symmetry at x
  for (const double m : { 0.5, 1.5 })
  {
    const ContactLoad along_x = foot.solve_on_winkler(1e10, load_at(m));
    const ContactLoad turned = foot.solve_on_winkler(1e10, load_at(m, angle));
    EXPECT_LT(difference(along_x, turned, angle), 1e-9) << "m = " << m;
    // Between two lines the kink at the edge of contact is integrated at other places.
    const ContactLoad between = foot.solve_on_winkler(1e10, load_at(m, angle + 0.3 / 256));
    EXPECT_LT(difference(along_x, between, angle + 0.3 / 256), 1e-5) << "m = " << m;
  }
}

TEST(BodyOfRevolution, OffsetAndTiltOfTheTableChangeNothing)
{
  const GlassProfile profile;
  const ContactCompliance compliance = foot_compliance(profile, graded_cells());
  RevolutionCase foot(profile, compliance);
  RevolutionCase tilted(profile, compliance);
  tilted.body.set_gap(
    [&](double r, double theta)
    { return profile.gap(r) + 3e-4 + 2e-3 * r * std::cos(theta) - 1e-3 * r * std::sin(theta); });
  const ContactLoad load = foot.solve_on_winkler(1e10, load_at(1.2, 0.4));
  const ContactLoad same = tilted.solve_on_winkler(1e10, load_at(1.2, 0.4));
  EXPECT_LT(difference(load, same, 0), 1e-9);
}

TEST(BodyOfRevolution, HoldsForceAndMomentToSolverPrecision)
{
  const GlassProfile profile;
  RevolutionCase foot(profile, foot_compliance(profile, graded_cells()));
  const ContactLoad load = foot.solve_on_winkler(1e10, load_at(0.9, 1.1));
  EXPECT_NEAR(load.normal_force() / weight, 1, 1e-10);
  EXPECT_NEAR(load.moment().x() / load_at(0.9, 1.1).moment_x, 1, 1e-9);
  EXPECT_NEAR(load.moment().y() / load_at(0.9, 1.1).moment_y, 1, 1e-9);
  EXPECT_LT(foot.solution.equilibrium_residual, 1e-9);
}

TEST(BodyOfRevolution, WarmStartFindsTheColdSolution)
{
  const GlassProfile profile;
  const ContactCompliance compliance = foot_compliance(profile, graded_cells());
  RevolutionCase cold(profile, compliance);
  RevolutionCase warm(profile, compliance);
  const auto mat = make_law(WinklerInterface(1e10), warm.body.contact_surface());
  const ContactLoad expected = cold.solve_on_winkler(1e10, load_at(1.3, 0.2));
  const ContactSolution neighbour = solve_contact(warm.body, *mat, load_at(1.2, 0.1), warm.radius);
  const ContactStart start = from(neighbour);
  const ContactSolution solution = solve_contact(warm.body, *mat, load_at(1.3, 0.2), warm.radius, {}, &start);
  EXPECT_LT(difference(expected, extract_load(*mat, solution, 8), 0), 1e-9);
}

TEST(BodyOfRevolution, StiffnessAndLoadScaleTogether)
{
  // The same foot with ten times the modulus under ten times the load on ten times the mat: equal
  // displacements.
  const GlassProfile profile;
  dealii::Triangulation<2> triangulation;
  make_meridian_mesh(profile, graded_cells(), triangulation);
  ElasticMaterial stiff;
  stiff.young_modulus *= 10;
  RevolutionCase foot(profile, compute_compliance(triangulation, ElasticMaterial()));
  RevolutionCase stiffer(profile, compute_compliance(triangulation, stiff));
  Resultants load = load_at(1.2);
  const ContactLoad expected = foot.solve_on_winkler(1e10, load);
  load.normal_force *= 10;
  load.moment_y *= 10;
  const ContactLoad scaled = stiffer.solve_on_winkler(1e11, load);
  for (unsigned int n = 0; n <= 8; ++n)
    EXPECT_NEAR(scaled.a(n) / 10, expected.a(n), 1e-9 * expected.a(0));
}

TEST(BodyOfRevolution, RefusesWhatItCannotResolve)
{
  const ContactCompliance compliance = foot_compliance(GlassProfile(), graded_cells());
  EXPECT_THROW(RevolutionCase(GlassProfile(), compliance, 32), std::invalid_argument);
  MeridianOptions options;
  options.degree = 5;
  EXPECT_THROW(foot_compliance(GlassProfile(), graded_cells(), options), std::invalid_argument);
  ContactCompliance sum = compliance;
  EXPECT_THROW(sum += foot_compliance(GlassProfile(), graded_cells(1)), std::invalid_argument);
  SlidingTraction traction;
  traction.friction_coefficient = -0.1;
  RevolutionCase foot(GlassProfile(), compliance);
  EXPECT_THROW(foot.body.set_sliding(traction), std::invalid_argument);
}
