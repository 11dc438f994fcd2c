// A rigid foot on a Winkler mat, from the study to its terminal spin. Reference: other code, quadrature in
// two dimensions without rings, harmonics or kernels (tests/verification/rigid_foot.py).
#include "fem/pipeline/analysis/refinement/error_bands.h"
#include "ring_model/terminal_spin.h"
#include "ring_model/unilateral_foundation.h"
#include "tests/fem/pipeline/analysis/solved_study.h"
#include "tests/fem/pipeline/program_runner.h"

#include <gtest/gtest.h>

#include <cmath>

namespace stemware::pipeline
{
namespace
{

using test::SolvedStudy;

const nlohmann::json &reference()
{
  static const auto file = nlohmann::json::parse(test::read_text(STEMWARE_RIGID_FOOT));
  return file;
}

/// A rigid foot on a mat of that modulus [Pa/m].
Study rigid_foot_study(double foundation_modulus)
{
  Study study;
  study.model.foot_is_rigid = true;
  study.table.foundation_modulus = foundation_modulus;
  return study;
}

/// With m given, its maximum to the right of the motion.
Study with_moment(Study study, double moment_ratio)
{
  study.load.moment_ratio = moment_ratio;
  study.load.moment_direction = -std::acos(-1.) / 2;
  return study;
}

TEST(RigidFoot, AFlatAnnulusInTheClosurePaper)
{
  Study study = rigid_foot_study(1e10);
  study.glass.profile.crown_radius = 0; // a land from 28 to 32 mm
  study.motion.closure = ring::Closure::paper;
  const double expected = reference()["annulus_closure_paper"]["omega"];
  EXPECT_NEAR(expected, -3.10658352, 1e-8);
  for (const LoadCoupling coupling : { LoadCoupling::one_way, LoadCoupling::two_way })
  {
    study.load.coupling = coupling;
    EXPECT_NEAR(SolvedStudy(study).omega(), expected, 1e-7 * std::abs(expected));
  }
}

TEST(RigidFoot, WithGivenMomentsWithinTheBand)
{
  for (const auto &expected : reference()["given_moment_direction_minus_90_deg"])
  {
    Study study = with_moment(rigid_foot_study(expected["k"]), expected["moment_ratio"]);
    study.glass.profile.crown_radius = expected["crown"];
    SolvedStudy solved(study);
    const auto band =
      band_of(estimate_bands(study, solved.foot, solved.row, std::nullopt, solved.cache), "omega_terminal");
    ASSERT_TRUE(band);
    EXPECT_NEAR(solved.omega(), expected["omega"].get<double>(), *band) << expected;
    // A band that says something; near tipping the slip ratio is 0.99, and the lines count.
    EXPECT_LT(*band, expected["moment_ratio"] < 1.9 ? 1e-3 : 2e-2) << expected;
    if (expected["moment_ratio"] > 1.9 && expected["k"] == 1e10)
      EXPECT_LT(*band, 10 * std::abs(solved.omega() - expected["omega"].get<double>()));
  }
}

TEST(RigidFoot, TendsToTheRingOfZeroWidthLikeItsWidthSquared)
{
  // Closed form of a torus on a mat, docs/theory/load_models.md. The half-width of the contact is
  // sqrt(2 crown d), and the depth d goes like k^(-2/3) at a given moment.
  for (const double moment_ratio : { 1.8, 1.95 })
  {
    std::vector<double> differences;
    for (const double modulus : { 1e10, 1e11, 1e12 })
    {
      Study study = with_moment(rigid_foot_study(modulus), moment_ratio);
      const SolvedStudy solved(study);
      const ring::UnilateralFoundation torus(study.glass.profile.contact_radius, 1.5, 4096);
      const ring::RingStack line =
        torus.rings(study.motion.orbit.normal_force(),
                    { study.required_resultants().moment_x, study.required_resultants().moment_y });
      differences.push_back(solved.omega() - ring::terminal_spin(line, study.motion.orbit).omega);
    }
    for (std::size_t i = 1; i < differences.size(); ++i)
      EXPECT_NEAR(differences[i] / differences[i - 1], std::pow(10, -2. / 3), 0.02)
        << moment_ratio << " " << differences[i];
  }
}

TEST(RigidFoot, InTheClosureFullWithTiltAndGrip)
{
  for (const auto &expected : reference()["closure_full"])
  {
    Study study = rigid_foot_study(expected["k"]);
    study.glass.profile.crown_radius = expected["crown"];
    study.motion.orbit.centre_of_mass_height = expected["z_cm"];
    study.motion.tilt = expected["tilt"];
    study.motion.grip_torque = expected["grip"];
    const double omega = expected["omega"];
    EXPECT_NEAR(SolvedStudy(study).omega(), omega, 1e-7 * std::abs(omega)) << expected;
  }
}

} // namespace
} // namespace stemware::pipeline
