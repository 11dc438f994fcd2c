#include "fem/pipeline/analysis/spin_study.h"
#include "fem/pipeline/analysis/study_answer.h"
#include "fem/pipeline/analysis/sweep_case.h"
#include "fem/pipeline/coupling/make_foot.h"
#include "fem/pipeline/coupling/study_load.h"
#include "tests/fem/pipeline/analysis/quick_studies.h"
#include "tests/fem/pipeline/analysis/solved_run.h"
#include "tests/fem/pipeline/analysis/solved_study.h"
#include "tests/fem/pipeline/mat_study.h"

#include <gtest/gtest.h>

#include <cmath>

namespace stemware::pipeline
{
namespace
{

using namespace stemware::test;
using Json = nlohmann::ordered_json;

TEST(OneNumber, ErrorBandsAndTablesContainTheReportedNumbers)
{
  const Json summary = SolvedRun(quick_contact_study()).summary();
  const Json &load = summary["load"], &ring = summary["ring"], &budget = summary["budget"];
  std::map<std::string, double> reported = { { "ring_radius", load["ring_radius"] },
                                             { "contact_fraction", load["contact_fraction"] },
                                             { "azimuth_fraction", load["azimuth_fraction"] },
                                             { "least_load", load["least_load"] },
                                             { "peak_pressure", load["peak_pressure"] },
                                             { "tau_at_rest", ring["tau_at_rest"] },
                                             { "tau_at_spin_1", budget.back()["torques"][1] },
                                             { "omega_terminal", ring["omega_terminal"] },
                                             { "time_constant", ring["time_constant"] },
                                             { "omega_first_harmonic",
                                               summary["truncation"].front()["omega_terminal"] },
                                             { "harmonic_effect", summary["harmonic_effect"]["absolute"] } };
  for (const unsigned int i : { 0u, 1u, 2u })
    reported["table_motion_" + std::to_string(i)] = summary["contact"]["table_motion"][i];
  for (unsigned int n = 1; n <= 8; ++n)
    for (const char *part : { "a", "b" })
      reported[part + std::to_string(n)] = load[part][n].get<double>() / load["a"][0].get<double>();
  const Json &bands = summary["error_bands"];
  ASSERT_FALSE(bands.empty());
  for (const auto &[key, band] : bands.items())
  {
    if (key == "tau_at_spin_2") // this torque is reported in the error bands only
      continue;
    EXPECT_EQ(band["value"].get<double>(), reported.at(key)) << key;
  }
  for (const auto &[key, share] : { std::pair("tau_at_spin_1", 0.5), { "tau_at_spin_2", 1.5 } })
    EXPECT_NEAR(bands[key]["omega"].get<double>(), share * ring["omega_terminal"].get<double>(), 1e-12);
  EXPECT_EQ(budget.back()["torques"][0], ring["tau_at_rest"]);
  EXPECT_EQ(summary["truncation"].back()["tau_at_rest"], ring["tau_at_rest"]);
  EXPECT_EQ(budget.back()["torques"][2], ring["tau_at_terminal"]);
}

TEST(OneNumber, TorquesCancelAtTheTerminalSpin)
{
  Study study = quick_contact_study();
  study.motion.grip_torque = 2e-4;
  const Json ring = SolvedRun(study).summary()["ring"];
  const double friction = ring["tau_at_terminal"], lean = ring["lean_torque_at_terminal"],
               grip = ring["grip_torque_at_terminal"];
  EXPECT_EQ(grip, 2e-4); // the grip opposes a clockwise spin
  EXPECT_NEAR(friction + lean + grip, 0, 1e-12);
  EXPECT_GT(std::abs(lean), 1e-8); // deformation by friction makes the pressure asymmetric
}

TEST(OneNumber, MomentRatiosReferToTheContactRadius)
{
  Study study = quick_contact_study();
  study.glass.profile.crown_radius = 0; // the load then acts beside the middle of the land
  study.load.moment_ratio = 1.2;
  const Json summary = SolvedRun(study).summary();
  EXPECT_NEAR(summary["load"]["moment_ratio"].get<double>(), 1.2, 1e-9);
  EXPECT_NEAR(summary["load_at_terminal"]["moment_ratio"].get<double>(), 1.2, 1e-9);
  EXPECT_NEAR(summary["ring"]["moment_ratio_at_terminal"].get<double>(), 1.2, 1e-9);
  // The ratio |(a_1, b_1)| / a_0 differs from 1.2, because the load does not act at the contact radius.
  const Json &load = summary["load"];
  const double of_harmonics =
    std::hypot(load["a"][1].get<double>(), load["b"][1].get<double>()) / load["a"][0].get<double>();
  EXPECT_GT(std::abs(of_harmonics - 1.2), 1e-3);
}

// Rigid foot on the default mat. Reference: quadrature in two dimensions by independent code. A terminal spin
// exists up to z_CM = 0.134575746 m and a balance at rest up to 0.143684201 m. Just above 0.134575746 m, only
// a narrow range of spins around -9.2306 rad/s has no balance.
ring::Answer row_at_height(double height, bool rigid)
{
  static fem::ComplianceCache cache;
  Study study = test::mat_study();
  study.motion.orbit.centre_of_mass_height = height;
  const std::shared_ptr<ElasticFoot> foot =
    study_foot({ study, {}, rigid ? rigid_foot() : Model() }, foot_maker(cache));
  return ring::answer(find_load(study, foot), spin_question(study)).value();
}

TEST(Fall, AgreesWithOtherCodeForARigidFoot)
{
  EXPECT_TRUE(row_at_height(0.13457, true).terminal);
  for (const auto &[height, spin] : { std::pair(0.13458, -9.19), std::pair(0.1346, -9.09) })
  {
    const ring::Answer falls = row_at_height(height, true);
    EXPECT_EQ(falls.status, ring::Status::tips) << height;
    ASSERT_TRUE(falls.fall) << height;
    EXPECT_NEAR(falls.fall->omega, spin, 0.015) << height;
    EXPECT_GT(falls.fall->moment_ratio, falls.at_rest->moment_ratio);
    EXPECT_LT(falls.fall->moment_ratio, 2);
  }
}

// A terminal spin exists up to a maximum height z_CM. Within 2e-7 m below this height, the moment balance has
// two solutions in a narrow range of spins. All commands must stay on the same solution.
TEST(Fall, RunTruncateAndSweepFindTippingAtTheSameHeights)
{
  Study study = mat_study();
  study.glass.material.young_modulus = 2e20;
  study.contact.friction_coupling = FrictionCoupling::none;
  fem::ComplianceCache cache;
  const ThreadedExecutor executor(cache);
  for (const double height : { 0.13457555, 0.134576 })
  {
    study.motion.orbit.centre_of_mass_height = height;
    const bool falls = height > 0.134575746;
    const std::shared_ptr<ElasticFoot> foot = study_foot(study, foot_maker(cache));
    const BalancedLoad load = find_load(study, foot);
    const SpinStudy run = study_spin({ study, foot, executor }, load, Depth::answer);
    EXPECT_EQ(run.answer().fall.has_value(), falls) << height;
    const ring::Answer truncated = answer_study(study, Depth::rows, executor, false).spin.answer();
    EXPECT_EQ(truncated.fall.has_value(), falls) << height;
    EXPECT_EQ(case_result(study, executor).status, falls ? "tips" : "ok") << height;
    if (!falls)
    {
      EXPECT_NEAR(*run.answer().omega_terminal(), *truncated.omega_terminal(), 1e-8);
    }
  }
}

TEST(Fall, TippingIsReportedAsAResultNotAnError)
{
  Study study = quick_contact_study();
  study.motion.orbit.centre_of_mass_height = 0.138;
  const SolvedRun run(study, rigid_foot());
  const Json summary = run.summary(), &ring = summary["ring"];
  EXPECT_EQ(ring["standing"], "tips");
  EXPECT_TRUE(ring["omega_terminal"].is_null());
  EXPECT_TRUE(summary["load_at_terminal"].is_null());
  EXPECT_NEAR(summary["load_at_fall"]["moment_ratio"].get<double>(),
              ring["fall"]["moment_ratio"].get<double>(), 1e-4);
  EXPECT_LT(ring["fall"]["omega"].get<double>(), -1);
  EXPECT_LT(ring["tau_at_rest"].get<double>(), 0);
  EXPECT_TRUE(summary["error_bands"].is_null());
  EXPECT_EQ(summary["budget"].back()["state"], "tips");
  EXPECT_FALSE(summary["budget"].front()["omega_terminal"].is_null());
}

} // namespace
} // namespace stemware::pipeline
