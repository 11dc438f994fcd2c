// The other body, and contact in balance with friction at every spin, through the program.
#include "program_runner.h"

#include <gtest/gtest.h>

#include <cmath>

namespace stemware::test
{
namespace
{

/// summary.json of the default glass as a body of revolution; the spin-up is cut short, which nothing else
/// depends on.
nlohmann::json run(const std::vector<std::string> &settings)
{
  const ScratchFolder scratch;
  std::vector<std::string> arguments = { "run", scratch.write("study.prm", "# the default glass\n"),
                                         "--output", "results" };
  for (const char *setting : { "Motion/End time=0.02", "Motion/Euler step=0.01" })
    arguments.insert(arguments.end(), { "--set", setting });
  for (const std::string &setting : settings)
    arguments.insert(arguments.end(), { "--set", setting });
  const Ended ended = stemware(scratch, arguments);
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  return read_summary(scratch / "results");
}

double harmonic(const nlohmann::json &summary, unsigned int n)
{
  const auto &load = summary["load"];
  return std::hypot(load["a"][n].get<double>(), load["b"][n].get<double>()) / load["a"][0].get<double>();
}

std::vector<std::string> lifted_on(const std::vector<std::string> &table)
{
  std::vector<std::string> settings = { "Contact/Body=revolution", "Load/Moment ratio=1.2" };
  settings.insert(settings.end(), table.begin(), table.end());
  return settings;
}

} // namespace

TEST(RevolutionRun, AgreesWithTheSolidBody)
{
  const auto revolution = run({ "Contact/Body=revolution", "Load/Moment ratio=1.2" });
  const auto solid = run({ "Contact/Body=solid", "Load/Moment ratio=1.2", "Contact/Azimuthal cells=24" });
  EXPECT_EQ(revolution["contact"]["body"], "revolution");
  EXPECT_EQ(solid["contact"]["body"], "solid");
  for (unsigned int n = 2; n <= 6; ++n)
    EXPECT_NEAR(harmonic(revolution, n), harmonic(solid, n), 1e-4) << "n = " << n;
  for (const char *when : { "at_rest", "at_terminal" })
    EXPECT_NEAR(revolution["resolved"][when]["torque"].get<double>(),
                solid["resolved"][when]["torque"].get<double>(), 1e-6)
      << when;
  EXPECT_NEAR(revolution["resolved"]["at_rest"]["torque"].get<double>(),
              revolution["ring"]["tau_closed_form"].get<double>(), 1e-12);
}

TEST(RevolutionRun, MatAndElasticTable)
{
  // foot_contact.json: crown 0.003, k = 1e10, m = 1.2.
  EXPECT_NEAR(harmonic(run(lifted_on({})), 4), 0.0057527, 2e-5);
  // Hardwood, displacement harmonics of foot and disc in numpy.
  EXPECT_NEAR(harmonic(run(lifted_on({ "Table/Kind=elastic" })), 4), 0.087, 3e-3);
}

TEST(RevolutionRun, RoughTableUnderAStiffFoot)
{
  // A rigid ring on an exponential law carries exp(kappa cos theta): a_n / a_0 = 2 I_n / I_0 (kappa).
  double kappa = 1.2;
  for (unsigned int i = 0; i < 60; ++i)
    kappa *= 1.2 / (2 * std::cyl_bessel_i(1, kappa) / std::cyl_bessel_i(0, kappa));
  const auto summary = run(lifted_on(
    { "Table/Kind=rough", "Glass/Young modulus=70e15", "Glass/Crown radius=0", "Glass/Land width=2e-4" }));
  for (unsigned int n = 2; n <= 4; ++n)
    EXPECT_NEAR(harmonic(summary, n), 2 * std::cyl_bessel_i(n, kappa) / std::cyl_bessel_i(0, kappa), 1e-3)
      << n;
}

TEST(RevolutionRun, TerminalSpinInBalanceWithFriction)
{
  const std::vector<std::string> coupled = { "Contact/Body=revolution", "Load/Coupling=exact" };
  const auto without = run(coupled);
  EXPECT_NEAR(without["ring"]["omega_terminal"].get<double>(), -3.6490, 2e-4);
  EXPECT_NEAR(without["ring"]["tau_at_rest"].get<double>(), -0.003675, 1e-12);
  const auto with = run({ coupled[0], coupled[1], "Contact/Friction coupling=elastic" });
  EXPECT_NEAR(with["ring"]["omega_terminal"].get<double>(), -3.6475, 2e-4);
}

TEST(RevolutionRun, OrbitReversed)
{
  const auto forward = run({ "Contact/Body=revolution", "Load/Coupling=exact" });
  const auto backward =
    run({ "Contact/Body=revolution", "Load/Coupling=exact", "Motion/Orbit sense=clockwise" });
  EXPECT_NEAR(forward["ring"]["omega_terminal"].get<double>(),
              -backward["ring"]["omega_terminal"].get<double>(), 1e-9);
  EXPECT_NEAR(forward["ring"]["tau_at_rest"].get<double>(), -backward["ring"]["tau_at_rest"].get<double>(),
              1e-15);
  for (unsigned int n = 0; n <= 6; ++n)
  {
    EXPECT_NEAR(forward["load"]["a"][n].get<double>(), backward["load"]["a"][n].get<double>(), 1e-9) << n;
    EXPECT_NEAR(forward["load"]["b"][n].get<double>(), -backward["load"]["b"][n].get<double>(), 1e-9) << n;
  }
}

} // namespace stemware::test
