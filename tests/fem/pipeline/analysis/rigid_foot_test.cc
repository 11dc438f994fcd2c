// Rigid foot on a Winkler mat. Reference: quadrature in two dimensions by independent code
// (tests/verification/rigid_foot.py).
#include "fem/pipeline/analysis/error_bands.h"
#include "fem/pipeline/analysis/spin_study.h"
#include "fem/pipeline/analysis/threaded_executor.h"
#include "ring_model/friction_functionals.h"
#include "ring_model/load/constants.h"
#include "ring_model/spin/answer.h"
#include "tests/fem/pipeline/analysis/solved_study.h"
#include "tests/fem/pipeline/mat_study.h"
#include "tests/fem/pipeline/program_runner.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>
#include <vector>

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

Study rigid_foot_study(double foundation_modulus)
{
  Study study = test::mat_study();
  study.table.foundation_modulus = foundation_modulus;
  return study;
}

/// Returns @p study with the given @p moment_ratio. The maximum of the load is to the right of the direction
/// of motion.
Study with_moment(Study study, double moment_ratio)
{
  study.load.moment_ratio = moment_ratio;
  study.load.moment_direction = -ring::pi / 2;
  return study;
}

TEST(RigidFoot, AgreesWithQuadratureOnAFlatAnnulusWithThePaperClosure)
{
  Study study = rigid_foot_study(1e10);
  study.glass.profile.crown_radius = 0; // flat land between the radii 28 and 32 mm
  study.motion.closure = ring::Closure::paper;
  const double expected = reference()["annulus_closure_paper"]["omega"];
  EXPECT_NEAR(expected, -3.10658352, 1e-8);
  for (const LoadCoupling coupling : { LoadCoupling::one_way, LoadCoupling::two_way })
  {
    study.load.coupling = coupling;
    EXPECT_NEAR(SolvedStudy(study, test::rigid_foot()).omega(), expected, 1e-7 * std::abs(expected));
  }
}

/// State on the default mat. `expected`: reference values by the keys of the error bands.
struct ReferenceState
{
  double moment_ratio; ///< given moment ratio; 0: moment balance
  double height;       ///< height of the centre of mass [m]; 0: given moment
  std::map<std::string, double> expected;
};

// The reference values are correct to nine digits. Pressure and friction are integrated over the land by
// quadrature, and the moment balance with tilt is solved at every spin. The time constants come from finite
// differences of the torque; steps from 0.003 to 0.03 rad/s give the same time constant to within 6e-10.
TEST(RigidFoot, ErrorBandsContainTheNumbersOfOtherCode)
{
  const std::vector<ReferenceState> states = {
    { 1.,
      0,
      { { "omega_terminal", -8.5292593583 },
        { "omega_first_harmonic", -8.389913122 },
        { "contact_fraction", 1 },
        { "a2", -0.1004544129 },
        { "a4", 0.0011679878 },
        { "b1", -0.9999712952 },
        { "b3", -0.0071278035 },
        { "peak_pressure", 100076.6416 },
        { "half", -7.855949167e-3 } } },
    { 1.2,
      0,
      { { "omega_terminal", -9.3659309418 },
        { "contact_fraction", 1 },
        { "a2", -0.1714167655 },
        { "a4", 0.0051910835 },
        { "b1", -1.1999639165 },
        { "b3", -0.0190376756 },
        { "peak_pressure", 108254.7822 },
        { "half", -9.871516410e-3 } } },
    { 1.285, 0, { { "time_constant", 0.0934089505 } } },
    { 1.3, 0, { { "omega_first_harmonic", -9.506107024 } } },
    { 1.5,
      0,
      { { "omega_terminal", -10.423213684 },
        { "omega_first_harmonic", -10.044235045 },
        { "contact_fraction", 0.618907039 },
        { "a2", -0.5443788134 },
        { "a4", -0.0455351304 },
        { "b1", -1.4999377616 },
        { "b3", -0.0099079511 },
        { "peak_pressure", 127427.8972 },
        { "half", -1.365488543e-2 } } },
    { 1.7021, 0, { { "time_constant", 0.0450137278 } } },
    { 1.8,
      0,
      { { "omega_terminal", -11.263738051 },
        { "omega_first_harmonic", -10.637746964 },
        { "time_constant", 0.0330908520 },
        { "contact_fraction", 0.362327510 },
        { "a2", -1.2882355519 },
        { "a4", 0.1938208831 },
        { "b1", -1.7997997767 },
        { "b3", 0.6799646295 },
        { "peak_pressure", 174461.3713 },
        { "half", -1.939793232e-2 } } },
    { 1.95,
      0,
      { { "omega_terminal", -11.568192889 },
        { "omega_first_harmonic", -10.856269481 },
        { "contact_fraction", 0.178035671 },
        { "a2", -1.8010531611 },
        { "a4", 1.2912755125 },
        { "b1", -1.9487930493 },
        { "b3", 1.5735241309 },
        { "peak_pressure", 276029.2751 },
        { "half", -2.413584702e-2 } } },
    { 0,
      0.08,
      { { "omega_terminal", -3.6512092261 },
        { "time_constant", 0.2725224381 },
        { "tau_at_rest", -3.677719044e-3 } } },
    { 0, 0.10, { { "omega_terminal", -4.9160578329 }, { "tau_at_rest", -3.678541932e-3 } } },
    { 0, 0.11, { { "omega_terminal", -5.9843854441 }, { "tau_at_rest", -3.679124817e-3 } } },
    { 0,
      0.12,
      { { "omega_terminal", -7.3105497223 },
        { "time_constant", 0.2438093926 },
        { "tau_at_rest", -3.680457435e-3 } } },
    { 0,
      0.13,
      { { "omega_terminal", -8.8813798800 },
        { "time_constant", 0.1347442866 },
        { "tau_at_rest", -3.683828356e-3 } } },
    { 0, 0.134, { { "omega_terminal", -9.5660928460 }, { "tau_at_rest", -3.686843551e-3 } } }
  };
  for (const ReferenceState &state : states)
  {
    Study study = test::mat_study();
    if (state.moment_ratio > 0)
      study = with_moment(study, state.moment_ratio);
    else
      study.motion.orbit.centre_of_mass_height = state.height;
    SolvedStudy solved(study, test::rigid_foot());
    ring::Question with_slope;
    with_slope.with_slope = true;
    const ring::Answer all = ring::answer(solved.load, spin_question(study, with_slope)).value();
    const BalancedLoad first = find_load(study, solved.foot, silent_progress(), 1);
    const ErrorBands bands =
      estimate_bands({ study, solved.foot, ThreadedExecutor(solved.cache) }, all,
                     ring::answer(first, spin_question(study)).value().omega_terminal());
    for (const auto &[key, expected] : state.expected)
    {
      const bool is_torque = key == "half"; // torque at half of the reference terminal spin
      const auto found = find_quantity(bands, is_torque ? "tau_at_spin_1" : key);
      ASSERT_NE(found, bands.end()) << key;
      const double value =
        is_torque ? ring::wrench(study.motion.orbit, solved.load.at(state.expected.at("omega_terminal") / 2),
                                 state.expected.at("omega_terminal") / 2)
                      .torque
                  : found->quantity.value;
      EXPECT_NEAR(value, expected, found->band + 1e-9 * std::abs(expected))
        << key << ", m = " << state.moment_ratio << ", height " << state.height;
      if (key == "omega_terminal" || key == "time_constant")
      {
        EXPECT_LT(found->band, 1e-3 * std::abs(expected)) << key << " " << state.moment_ratio;
      }
    }
  }
}

TEST(RigidFoot, SpinWithoutTiltAndTerminalStateWithTiltAgreeWithOtherCode)
{
  struct Row
  {
    double height, omega_without_tilt, moment_ratio, share;
  };
  for (const Row &row :
       { Row{ 0.08, -3.6479409597, 0.672458548, 1 }, Row{ 0.10, -4.9081467152, 1.062282370, 1 },
         Row{ 0.11, -5.9723316088, 1.263563459, 0.845300589 },
         Row{ 0.12, -7.2900470171, 1.466700683, 0.646552876 },
         Row{ 0.13, -8.8394957769, 1.669659281, 0.479444994 },
         Row{ 0.134, -9.5046231178, 1.750582376, 0.408863683 } })
  {
    Study study = test::mat_study();
    study.motion.orbit.centre_of_mass_height = row.height;
    const SolvedStudy solved(study, test::rigid_foot());
    EXPECT_NEAR(solved.row.at_terminal->moment_ratio, row.moment_ratio, 1e-5) << row.height;
    // The contact edge is interpolated between azimuth lines 1/128 of a turn apart.
    EXPECT_NEAR(solved.load.contact(solved.omega())->load.contact_fraction, row.share, 2e-3) << row.height;
    study.motion.tilt = false;
    EXPECT_NEAR(SolvedStudy(study, test::rigid_foot()).omega(), row.omega_without_tilt,
                1e-5 * std::abs(row.omega_without_tilt))
      << row.height;
  }
}

TEST(RigidFoot, AgreesWithOtherCodeInFullMomentBalanceWithTiltAndGrip)
{
  for (const auto &expected : reference()["closure_full"])
  {
    Study study = rigid_foot_study(expected["k"]);
    study.glass.profile.crown_radius = expected["crown"];
    study.motion.orbit.centre_of_mass_height = expected["z_cm"];
    study.motion.tilt = expected["tilt"];
    study.motion.grip_torque = expected["grip"];
    const double omega = expected["omega"];
    EXPECT_NEAR(SolvedStudy(study, test::rigid_foot()).omega(), omega, 1e-7 * std::abs(omega)) << expected;
  }
}

} // namespace
} // namespace stemware::pipeline
