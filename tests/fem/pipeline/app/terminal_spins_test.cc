// All terminal spins of a study, with their stability.
#include "tests/fem/pipeline/matchers.h"
#include "tests/fem/pipeline/page_document.h"
#include "tests/fem/pipeline/program_runner.h"

#include <gtest/gtest.h>

#include <cmath>

namespace stemware::test
{
namespace
{

struct Zero
{
  double omega;
  bool stable;
};

/// Zeros of the torque of the paper's first harmonic under Stribeck's law, by a sum over the rim, a scan and
/// bisection.
std::vector<Zero> zeros_of_the_ring(double mass, double offset, double fixed, double kinetic, double decay)
{
  const double R = 0.03, v = 0.35, pi = std::acos(-1.), N = mass * 9.81;
  const double b1 = offset * mass * v * v / 0.15 / (pi * R);
  const auto torque = [&](double omega)
  {
    const unsigned int n = 4000;
    double sum = 0;
    for (unsigned int i = 0; i < n; ++i)
    {
      const double theta = 2 * pi * (i + 0.5) / n, sine = std::sin(theta);
      const double slip = std::hypot(v - omega * R * sine, omega * R * std::cos(theta));
      const double mu = kinetic + (fixed - kinetic) * std::exp(-std::pow(slip / decay, 2));
      sum += mu * (N / (2 * pi) + b1 * sine) * (v * sine - omega * R) / slip;
    }
    return sum * R * 2 * pi / n;
  };
  std::vector<Zero> zeros;
  const double end = 1.5 * v / R, step = 0.05;
  double before = torque(-end);
  for (double omega = -end; omega < end; omega += step)
  {
    const double after = torque(omega + step);
    if (before * after < 0)
    {
      double lower = omega, upper = omega + step;
      while (upper - lower > 1e-10)
        ((torque((lower + upper) / 2) < 0) == (before < 0) ? lower : upper) = (lower + upper) / 2;
      zeros.push_back({ lower, before > 0 });
    }
    before = after;
  }
  return zeros;
}

} // namespace

TEST(TerminalSpins, AreAllFoundWithTheirStability)
{
  const ScratchFolder scratch;
  const nlohmann::json ring = solved(scratch, { "run", "--quick" },
                                     { "Load/Source=first harmonic", "Motion/Friction law=Stribeck",
                                       "Motion/Static friction coefficient=1",
                                       "Motion/Friction coefficient=0.2", "Motion/Friction decay speed=0.3",
                                       "Motion/Force offset=-0.01", "Motion/Closure=paper" })["ring"];
  const std::vector<Zero> expected = zeros_of_the_ring(0.3, -0.01, 1, 0.2, 0.3);
  ASSERT_EQ(expected.size(), 3u);
  ASSERT_EQ(ring["terminal_spins"].size(), 3u) << ring;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const nlohmann::json &found = ring["terminal_spins"][i];
    EXPECT_NEAR(found["omega"].get<double>(), expected[i].omega, 1e-7);
    EXPECT_EQ(found["stable"].get<bool>(), expected[i].stable);
    EXPECT_EQ(found["from_rest"].get<bool>(), i == 0);
  }
  EXPECT_EQ(ring["terminal_spins"][0]["omega"], ring["omega_terminal"]);
  EXPECT_THAT(page_document(scratch / "results")["words"]["several_spins"].get<std::string>(),
              testing::HasSubstr("3 spins, 2 of them stable"));
}

} // namespace stemware::test
