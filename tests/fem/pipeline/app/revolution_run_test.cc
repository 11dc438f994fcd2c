// The body of revolution, and contact in balance with friction at every spin, through the program.
#include "tests/fem/pipeline/matchers.h"
#include "tests/fem/pipeline/program_runner.h"

#include <gtest/gtest.h>

#include <cmath>

namespace stemware::test
{
namespace
{

/// Runs the default glass in a folder of its own; the spin-up is cut short, which nothing else depends on.
class GlassRun
{
public:
  explicit GlassRun(const std::vector<std::string> &settings, bool quick = true)
  {
    std::vector<std::string> arguments = { "run", scratch.write("study.prm", plain_study()), "--output",
                                           "results" };
    if (quick)
      arguments.push_back("--quick");
    for (const char *setting : { "Motion/End time=0.02", "Motion/Euler step=0.01" })
      arguments.insert(arguments.end(), { "--set", setting });
    for (const std::string &setting : settings)
      arguments.insert(arguments.end(), { "--set", setting });
    ended = stemware(scratch, arguments);
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
  }

  nlohmann::json summary() const { return read_summary(scratch / "results"); }
  std::vector<std::vector<double>> table(const std::string &name) const
  {
    return read_columns(scratch / "results" / name);
  }
  const std::string &terminal() const { return ended.out; }

private:
  const ScratchFolder scratch;
  Ended ended;
};

nlohmann::json run(const std::vector<std::string> &settings)
{
  return GlassRun(settings).summary();
}

double harmonic(const nlohmann::json &summary, unsigned int n)
{
  const auto &load = summary["load"];
  return std::hypot(load["a"][n].get<double>(), load["b"][n].get<double>()) / load["a"][0].get<double>();
}

std::vector<std::string> lifted_on(const std::vector<std::string> &table)
{
  std::vector<std::string> settings = { "Load/Moment ratio=1.2" };
  settings.insert(settings.end(), table.begin(), table.end());
  return settings;
}

} // namespace

TEST(RevolutionRun, AgreesWithTheSolidBody)
{
  const auto revolution = run({ "Load/Moment ratio=1.2" });
  const auto solid = run({ "Contact/Body=solid", "Load/Moment ratio=1.2", "Contact/Azimuthal cells=24" });
  EXPECT_EQ(revolution["contact"]["body"], "revolution");
  EXPECT_EQ(solid["contact"]["body"], "solid");
  for (unsigned int n = 2; n <= 6; ++n)
    EXPECT_NEAR(harmonic(revolution, n), harmonic(solid, n), 1e-4) << "n = " << n;
  for (const std::size_t i : { 0, 1 })
    EXPECT_NEAR(revolution["ring"]["force_at_terminal"][i].get<double>(),
                solid["ring"]["force_at_terminal"][i].get<double>(), 1e-4)
      << i;
  EXPECT_NEAR(revolution["ring"]["tau_at_rest"].get<double>(),
              revolution["ring"]["tau_closed_form"].get<double>(), 1e-12);
}

TEST(RevolutionRun, RealFootIsThatOfCubicElementsOnRefinedCells)
{
  // Twice refined cells (stemware::fem, not this program) say 0.166935; the step's harmonic is 0.16800.
  EXPECT_NEAR(harmonic(run({ "Glass/Shape=foot", "Load/Moment ratio=1.2" }), 2), 0.166935, 2e-5);
}

TEST(RevolutionRun, MatAndElasticTable)
{
  // foot_contact.json: crown 0.003, k = 1e10, m = 1.2.
  EXPECT_NEAR(harmonic(run(lifted_on({})), 4), 0.0057527, 2e-5);
  // Hardwood, displacement harmonics of foot and disc in numpy.
  EXPECT_NEAR(harmonic(run(lifted_on({ "Table/Interface=hard", "Table/Substrate=elastic" })), 4), 0.087,
              3e-3);
}

TEST(RevolutionRun, RoughTableUnderAStiffFoot)
{
  // A rigid ring on an exponential law carries exp(kappa cos theta): a_n / a_0 = 2 I_n / I_0 (kappa).
  double kappa = 1.2;
  for (unsigned int i = 0; i < 60; ++i)
    kappa *= 1.2 / (2 * std::cyl_bessel_i(1, kappa) / std::cyl_bessel_i(0, kappa));
  const auto summary = run(lifted_on({ "Table/Interface=rough", "Glass/Young modulus=70e15",
                                       "Glass/Crown radius=0", "Glass/Land width=2e-4" }));
  for (unsigned int n = 2; n <= 4; ++n)
    EXPECT_NEAR(harmonic(summary, n), 2 * std::cyl_bessel_i(n, kappa) / std::cyl_bessel_i(0, kappa), 1e-3)
      << n;
}

TEST(RevolutionRun, TerminalSpinInBalanceWithFriction)
{
  const auto without = run({ "Load/Coupling=two-way" });
  EXPECT_NEAR(without["ring"]["omega_terminal"].get<double>(), -3.6490, 2e-4);
  EXPECT_NEAR(without["ring"]["tau_at_rest"].get<double>(), -0.003675, 1e-12);
  EXPECT_EQ(without["contact"]["friction_coupling"], "none");
  const auto with = run({ "Load/Coupling=two-way", "Contact/Friction coupling=elastic" });
  EXPECT_NEAR(with["ring"]["omega_terminal"].get<double>(), -3.6475, 2e-4);
  EXPECT_EQ(with["contact"]["friction_coupling"], "elastic");
}

TEST(RevolutionRun, WhereTheSpinDoesNotMatterOneContactSolutionIsEnough)
{
  const auto one_way = run({ "Motion/Closure=paper" });
  const auto two_way = run({ "Motion/Closure=paper", "Load/Coupling=two-way" });
  EXPECT_TRUE(two_way["coupling"].is_null());
  EXPECT_EQ(two_way["ring"], one_way["ring"]);
  ASSERT_EQ(two_way["truncation"].size(), one_way["truncation"].size());
  for (std::size_t i = 0; i < one_way["truncation"].size(); ++i)
    EXPECT_NEAR(two_way["truncation"][i]["omega_terminal"].get<double>(),
                one_way["truncation"][i]["omega_terminal"].get<double>(), 1e-10);
  // Friction that deforms the foot turns with the spin.
  const auto turning =
    run({ "Motion/Closure=paper", "Load/Coupling=two-way", "Contact/Friction coupling=elastic",
          "Contact/Harmonics=4", "Contact/Azimuth lines=32" });
  EXPECT_GE(turning["coupling"]["contact_solutions"].get<int>(),
            turning["coupling"]["balanced_spins"].get<int>());
  EXPECT_GT(turning["coupling"]["balanced_spins"].get<int>(), 10);
}

TEST(RevolutionRun, HardTablesTakeFrictionIntoAccount)
{
  const GlassRun hard({ "Table/Interface=hard", "Table/Substrate=elastic",
                        "Contact/Friction coupling=elastic", "Contact/Harmonics=8", "Load/Moment ratio=0.5",
                        "Load/Moment direction=0" });
  EXPECT_EQ(hard.summary()["contact"]["friction_coupling"], "elastic");
  EXPECT_THAT(hard.terminal(), testing::HasSubstr("Friction  deforms the foot"));
  // 0.0256 with 16 harmonics; without friction it is below 5e-4.
  EXPECT_NEAR(hard.summary()["load"]["a"][2].get<double>() / hard.summary()["load"]["a"][0].get<double>(),
              0.0256, 0.001);
  const GlassRun solid({ "Table/Interface=hard", "Contact/Body=solid", "Contact/Azimuthal cells=16",
                         "Contact/Degree=1", "Contact/Radial cells=2", "Contact/Foot layers=1" });
  EXPECT_EQ(solid.summary()["contact"]["friction_coupling"], "none");
  EXPECT_THAT(solid.terminal(), testing::HasSubstr("Friction  does not deform the foot"));
}

TEST(RevolutionRun, PointwiseLoadAndFootprintShowTheLoad)
{
  const double pi = std::acos(-1.);
  const GlassRun lifted({ "Load/Moment ratio=1.5" });
  const auto summary = lifted.summary();
  const auto lines = lifted.table("load_lines.csv");
  const std::size_t n_lines = lines[0].size();
  ASSERT_EQ(n_lines, 128u);
  double force = 0, moment = 0, loaded = 0;
  for (std::size_t i = 0; i < n_lines; ++i)
  {
    force += lines[1][i] * 2 * pi / static_cast<double>(n_lines);
    moment += lines[1][i] * std::sin(lines[0][i]) * 2 * pi / static_cast<double>(n_lines);
    loaded += lines[1][i] > 0 ? 1 : 0;
    // The crest lies at -pi/2; pi/2 is in the air.
    if (std::abs(lines[0][i] - pi / 2) < 0.2)
    {
      EXPECT_EQ(lines[1][i], 0) << lines[0][i];
    }
  }
  EXPECT_NEAR(force, 2.943, 1e-9);
  EXPECT_NEAR(moment / pi, summary["load"]["b"][1].get<double>(), 1e-9);
  // The contact ends between two lines.
  EXPECT_NEAR(loaded / static_cast<double>(n_lines), summary["load"]["contact_fraction"].get<double>(),
              1. / static_cast<double>(n_lines));
  EXPECT_EQ(summary["load"]["contact_fraction"], summary["load"]["azimuth_fraction"]);

  // The footprint is a grid of lines and radii; its pressure adds up to the load of each line.
  const auto print = lifted.table("footprint.csv");
  const std::size_t n_radii = print[0].size() / n_lines;
  ASSERT_EQ(n_radii * n_lines, print[0].size());
  for (std::size_t i = 0; i < n_lines; ++i)
  {
    double density = 0;
    for (std::size_t k = i * n_radii; k + 1 < (i + 1) * n_radii; ++k)
    {
      EXPECT_NEAR(print[1][k], lines[0][i], 1e-6);
      density +=
        (print[2][k] * print[0][k] + print[2][k + 1] * print[0][k + 1]) / 2 * (print[0][k + 1] - print[0][k]);
    }
    EXPECT_NEAR(density, lines[1][i], 0.02 * summary["load"]["a"][0].get<double>()) << lines[0][i];
  }
}

} // namespace stemware::test
