// References: closed forms with quadrature (Boussinesq, Cerruti, transfer function of a layer); for punches:
// annular_punch.py (docs/verification/annular_punch.md).
#include "fem/contact/hard_interface.h"
#include "fem/revolution/compliance_cache.h"
#include "fem/revolution/meshed_revolution_foot.h"
#include "ring_model/load/constants.h"
#include "tests/fem/revolution/revolution_case.h"
#include "tests/verification/half_space_formulas.h"

#include <gtest/gtest.h>

using stemware::ring::pi;
using namespace stemware::revolution_tests;
using namespace stemware::verification;

namespace
{

const ElasticMaterial wood{ 10e9, 0.3 };

GlassProfile strip(double width)
{
  GlassProfile profile;
  profile.land_width = width;
  profile.crown_radius = 0;
  return profile;
}

ContactCompliance compliance_of_disc(const TableDisc &disc, const ElasticMaterial &material,
                                     const GlassProfile &profile, unsigned int refinements,
                                     unsigned int n_harmonics)
{
  MeridianResolution resolution = equal_cells(refinements);
  resolution.land_cells = 8;
  dealii::Triangulation<2> triangulation;
  make_meridian_mesh(disc, profile, resolution, triangulation);
  return compute_compliance(triangulation, material, { 2, n_harmonics });
}

Eigen::VectorXd nodes_of(const ContactCompliance &compliance, Band band)
{
  return nodes_between(compliance, band.inner, band.outer);
}

} // namespace

// All harmonics above 16 use the compliance of n = 24.
TEST(HalfSpace, NormalComplianceAgreesWithBoussinesq)
{
  const ContactCompliance disc = compliance_of_disc({ 0.3, 0.3 }, wood, strip(0.004), 1, 16);
  const Band whole = { 0.028, 0.032 }, inner = { 0.028, 0.03 }, outer = { 0.03, 0.032 };
  for (const unsigned int n : { 2u, 3u, 6u, 16u, 24u })
  {
    const Eigen::MatrixXd &normal = n == 24 ? disc.tail.normal : disc.harmonics[n].normal;
    for (const auto &[loaded, seen] : { std::pair(whole, whole), { inner, outer }, { outer, inner } })
      EXPECT_NEAR(nodes_of(disc, seen).dot(normal * nodes_of(disc, loaded)) /
                    normal_compliance(n, loaded, seen, wood),
                  1, n < 16 ? 1.5e-3 : 3e-3)
        << "n = " << n;
  }
}

// The compliances end at harmonic 16, and higher harmonics use the compliance of n = 24. The disc therefore
// responds to harmonic 20 like a half-space to harmonic 24.
TEST(HalfSpace, HarmonicsAboveTheComputedOnesUseTheComplianceOfHarmonic24)
{
  constexpr unsigned int n_lines = 64;
  const ContactCompliance disc = compliance_of_disc({ 0.3, 0.3 }, wood, strip(0.004), 1, 16);
  const Band whole = { 0.028, 0.032 };
  const Eigen::VectorXd nodes = nodes_of(disc, whole);
  BodyOfRevolution body(
    disc, [](double, double) { return 0.; }, n_lines);
  for (const auto &[n, answers_as] : { std::pair(5u, 5u), { 20u, 24u } })
  {
    Eigen::MatrixXd forces(nodes.size(), n_lines);
    for (unsigned int j = 0; j < n_lines; ++j)
      forces.col(j) = nodes * (2 * pi / n_lines * std::cos(2 * pi * n * j / n_lines));
    body.set_forces(forces.reshaped());
    const Eigen::VectorXd ahead = body.contact_displacement().head(nodes.size());
    EXPECT_NEAR(nodes.dot(ahead) / normal_compliance(answers_as, whole, whole, wood), 1, 3e-3) << n;
  }
}

TEST(HalfSpace, TangentialComplianceAgreesWithCerruti)
{
  const ContactCompliance disc = compliance_of_disc({ 0.3, 0.3 }, wood, strip(0.004), 1, 6);
  const Band inner = { 0.028, 0.03 }, outer = { 0.03, 0.032 };
  for (const unsigned int n : { 2u, 3u, 6u })
    for (const auto &[loaded, seen] : { std::pair(inner, outer), { outer, inner } })
    {
      const TangentialCompliance expected = tangential_compliance(n, loaded, seen, wood);
      const Eigen::VectorXd force = nodes_of(disc, loaded), mean = nodes_of(disc, seen);
      EXPECT_NEAR(mean.dot(disc.harmonics[n].radial * force) / expected.radial, 1, 5e-3) << n;
      EXPECT_NEAR(mean.dot(disc.harmonics[n].azimuthal * force) / expected.azimuthal, 1, 5e-3) << n;
    }
}

// Reference: Johnson, Contact Mechanics, section 5.8. Cases: layers thicker than the contact is wide, with nu
// = 0 and nu = 0.3, and a thin layer.
TEST(Layer, NormalComplianceAgreesWithTheTransferFunction)
{
  const struct
  {
    double thickness, poisson_ratio;
    unsigned int refinements;
  } layers[] = { { 5e-3, 0, 1 }, { 5e-3, 0.3, 1 }, { 5e-5, 0, 2 } };
  for (const auto &[thickness, poisson_ratio, refinements] : layers)
  {
    const ElasticMaterial cork{ 5e6, poisson_ratio };
    const ContactCompliance layer =
      compliance_of_disc({ 0.15, thickness }, cork, strip(4e-4), refinements, 2);
    const Band whole = { 0.0298, 0.0302 };
    const Eigen::VectorXd nodes = nodes_of(layer, whole);
    for (const unsigned int n : { 0u, 2u })
      EXPECT_NEAR(nodes.dot(layer.harmonics[n].normal * nodes) /
                    normal_compliance(n, whole, whole, cork, thickness),
                  1, 2e-3)
        << "h = " << thickness << ", nu = " << poisson_ratio << ", n = " << n;
  }
}

// Reference: tests/verification/annular_punch.py, for a layer that is 100 outer radii thick. The remaining
// error comes from the singular pressure at the edges.
TEST(HalfSpace, DepthAndTiltOfWideAnnularPunchesConvergeToTheReference)
{
  const struct
  {
    double ratio, load, moment; ///< inner / outer; force / (2 E* outer depth); 3 torque / (4 E* outer^3 tilt)
  } punches[] = { { 0.5, 0.9895262242, 0.9960429791 },
                  { 0.7, 0.9473028987, 0.9741349404 },
                  { 0.9, 0.8269807294, 0.8624369366 } };
  const struct
  {
    unsigned int n_cells;
    double error_of_depth, error_of_tilt;
  } meshes[] = { { 16, 7e-3, 1.8e-2 }, { 32, 3.5e-3, 9e-3 } };
  const double outer = 0.030, force = 981;
  for (const auto &[ratio, load, moment] : punches)
    for (const auto &[n_cells, error_of_depth, error_of_tilt] : meshes)
    {
      RevolutionSetup setup;
      setup.profile = strip(outer * (1 - ratio));
      setup.profile.contact_radius = outer * (1 + ratio) / 2;
      setup.table.interface = std::make_shared<HardInterface>();
      setup.table.substrate = Substrate{ { 3, 3 }, wood };
      setup.foot_is_rigid = true;
      setup.resolution.land_cells = n_cells;
      setup.n_lines = 128;
      const MeshedRevolutionFoot foot(setup.resolved_for(force));
      const double torque = 0.2 * force * setup.profile.contact_radius / 2;
      const ContactState state = foot.solve({ force, torque, 0 });
      const Eigen::Vector3d motion = state.solution.motion;
      EXPECT_EQ(state.load.contact_fraction, 1) << ratio << ", " << n_cells << " cells";
      const double modulus = plane_strain_modulus(wood);
      EXPECT_NEAR(std::abs(motion(0)) * 2 * modulus * outer * load / force, 1, error_of_depth)
        << ratio << ", " << n_cells << " cells";
      EXPECT_NEAR(motion.tail<2>().norm() * 4 * modulus * std::pow(outer, 3) * moment / (3 * torque), 1,
                  error_of_tilt)
        << ratio << ", " << n_cells << " cells";
    }
}
