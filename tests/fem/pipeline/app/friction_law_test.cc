#include "tests/fem/pipeline/matchers.h"
#include "tests/fem/pipeline/program_runner.h"

#include <gtest/gtest.h>

#include <cmath>

namespace stemware::test
{
namespace
{

using Settings = std::vector<std::string>;

Settings with_law(const std::string &kinetic, const std::string &fixed, const std::string &decay_speed,
                  const std::string &viscous = "0")
{
  return { "Motion/Friction law=Stribeck", "Motion/Friction coefficient=" + kinetic,
           "Motion/Static friction coefficient=" + fixed, "Motion/Friction decay speed=" + decay_speed,
           "Motion/Viscous friction=" + viscous };
}

nlohmann::json quick_run(const Settings &settings)
{
  return solved(ScratchFolder(), { "run", "--quick" }, settings);
}

double spin_of(const nlohmann::json &summary)
{
  return summary["ring"]["omega_terminal"];
}

double spin_without(const nlohmann::json &summary, const std::string &name)
{
  for (const nlohmann::json &row : summary["without"])
    if (row["name"] == name)
      return row["omega_terminal"];
  ADD_FAILURE() << "no row " << name;
  return 0;
}

} // namespace

TEST(FrictionLawStudy, EqualCoefficientsGiveCoulombFriction)
{
  const nlohmann::json coulomb = quick_run({});
  const auto expect_equal = [&](const nlohmann::json &stribeck)
  {
    EXPECT_NEAR(spin_of(stribeck), spin_of(coulomb), 1e-10 * std::abs(spin_of(coulomb)));
    EXPECT_NEAR(stribeck["ring"]["tau_at_rest"].get<double>(), coulomb["ring"]["tau_at_rest"].get<double>(),
                1e-13);
    for (unsigned int n = 0; n <= 8; ++n)
      for (const char *part : { "a", "b" })
        EXPECT_NEAR(stribeck["load_at_terminal"][part][n].get<double>(),
                    coulomb["load_at_terminal"][part][n].get<double>(), 1e-10)
          << part << n;
  };
  expect_equal(quick_run(with_law("0.3", "0.3", "0.1")));
  // If the coefficients differ by rounding, the Stribeck law is integrated by quadrature, and the friction
  // that deforms the foot is computed point by point.
  expect_equal(quick_run(with_law("0.3", "0.300000000000001", "0.1")));
}

TEST(FrictionLawStudy, ViscousFrictionAgreesWithTheClosedForm)
{
  // Closed form: the torque of viscous friction is proportional to v M_x - omega N <r^2>, with the moment M_x
  // of the load and its mean square radius <r^2>. With Closure::paper, omega = v M_x / (N <r^2>).
  Settings viscous = with_law("3e-11", "3e-11", "0.1", "1 s/m");
  viscous.push_back("Motion/Closure=paper");
  const double v = 0.35, N = 0.3 * 9.81, moment = -0.05 * 0.3 * v * v / 0.15;
  const nlohmann::json elastic = quick_run(viscous);
  double square = 0, force = 0;
  const nlohmann::json &load = elastic["load_at_terminal"];
  for (std::size_t j = 0; j < load["radii"].size(); ++j)
  {
    const double a0 = load["rings"][j]["a"][0];
    square += a0 * std::pow(load["radii"][j].get<double>(), 2);
    force += a0;
  }
  EXPECT_NEAR(spin_of(elastic) / (v * moment / (N * square / force)), 1, 1e-9);
  viscous.push_back("Load/Source=first harmonic");
  EXPECT_NEAR(spin_of(quick_run(viscous)) / (v * moment / (N * 0.03 * 0.03)), 1, 2e-10);
  // With Closure::full, (M_x, M_y) = (M - h T_y, h T_x). T: friction force. M: moment without friction. h:
  // height of the hand.
  viscous[5] = "Motion/Closure=full";
  const double h = 0.03, R = 0.03;
  double omega = 0;
  for (unsigned int i = 0; i < 200; ++i)
  {
    // Balance for the viscous coefficient 1 s/m: M_x = M - h T_y, M_y = h T_x, T_x = -(v N - omega M_x), T_y
    // = omega M_y, omega = v M_x / (N R^2).
    const double a = h * omega, moment_x = (moment + a * h * v * N) / (1 + a * a);
    omega = v * moment_x / (N * R * R);
  }
  EXPECT_NEAR(spin_of(quick_run(viscous)) / omega, 1, 1e-9);
}

TEST(FrictionLawStudy, RunTruncateAndSweepUseTheStribeckLawAndOneVariantOmitsIt)
{
  const Settings law = with_law("0.2", "0.5", "0.3 m/s");
  const nlohmann::json run = solved(ScratchFolder(), { "run" }, law);
  const double spin = spin_of(run), mu = 0.2 + 0.3 * std::exp(-std::pow(0.35 / 0.3, 2));
  // At zero spin, every point slips with the orbit speed.
  EXPECT_NEAR(run["ring"]["tau_at_rest"].get<double>() / (mu * run["load"]["moment"][0].get<double>()), 1,
              1e-9);
  const nlohmann::json truncated = solved(ScratchFolder(), { "truncate" }, law);
  EXPECT_NEAR(truncated["truncation"].back()["omega_terminal"].get<double>(), spin, 1e-9 * std::abs(spin));

  // The variant without the Stribeck law uses the friction coefficient at the orbit speed.
  const nlohmann::json constant =
    solved(ScratchFolder(), { "run" }, { "Motion/Friction coefficient=" + nlohmann::json(mu).dump() });
  EXPECT_NEAR(spin_without(run, "dependence of friction on slip"), spin_of(constant), 1e-8);
  EXPECT_GT(std::abs(spin), 1.1 * std::abs(spin_of(constant)));
  EXPECT_EQ(run["budget"][1]["name"], "friction law");
  EXPECT_NEAR(run["budget"][0]["omega_terminal"].get<double>(),
              constant["budget"][0]["omega_terminal"].get<double>(), 1e-10);

  const ScratchFolder scratch;
  solved(scratch, { "sweep", "--vary", "Motion/Mass=0.3,0.4" }, law, "swept");
  const std::string spin_text = nlohmann::json(spin).dump().substr(0, 10);
  EXPECT_THAT(read_text(scratch / "swept/sweep.csv"), testing::HasSubstr(spin_text));
}

} // namespace stemware::test
