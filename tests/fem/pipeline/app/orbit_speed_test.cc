#include "fem/pipeline/study/study_file.h"
#include "ring_model/load/constants.h"
#include "tests/fem/pipeline/matchers.h"
#include "tests/fem/pipeline/page_document.h"
#include "tests/fem/pipeline/program_runner.h"
#include "tests/fem/pipeline/refusal.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <string>
#include <tuple>

namespace stemware::test
{
namespace
{

/// Returns the columns time, v, dv/dt and omega of a run with the orbit speed file @p speeds. Sets @p steady
/// to omega at the constant orbit speed of the study.
std::vector<std::vector<double>> driven(const std::string &speeds, const std::vector<std::string> &settings,
                                        std::vector<double> *steady = nullptr)
{
  const ScratchFolder scratch;
  solved(scratch, { "run", "--set", "Motion/Orbit speed file=" + scratch.write("speeds.csv", speeds) },
         settings);
  if (steady)
    *steady = read_columns(scratch / "results/spin_up.csv")[1];
  return read_columns(scratch / "results/driven_spin_up.csv");
}

/// Returns omega at equally spaced times up to @p end [s], for a load of the first harmonic in moment balance
/// at v = v0 + a t. Sums friction over the rim, solves a linear system for a_1 and b_1, and integrates by the
/// classical Runge-Kutta method.
std::vector<double> integrated_ramp(double v0, double a, double end)
{
  const double m = 0.3, R = 0.03, mu = 0.3, offset = -0.05, h = 0.03, inertia = 3e-4;
  const double a0 = m * 9.81 / (2 * ring::pi);
  const unsigned int n = 720;
  const auto torque = [&](double t, double omega)
  {
    const double v = v0 + a * t;
    // Rows: friction under the loads 1, cos(theta) and sin(theta). Columns: forces in x and y, and torque.
    std::array<std::array<double, 3>, 3> unit = {};
    for (unsigned int i = 0; i < n; ++i)
    {
      const double theta = 2 * ring::pi * (i + 0.5) / n;
      const double x = v - omega * R * std::sin(theta), y = omega * R * std::cos(theta);
      const double f = mu * 2 * ring::pi / n / std::hypot(x, y);
      const std::array<double, 3> shape = { 1, std::cos(theta), std::sin(theta) };
      for (unsigned int k = 0; k < 3; ++k)
      {
        unit[k][0] -= f * shape[k] * x;
        unit[k][1] -= f * shape[k] * y;
        unit[k][2] += f * shape[k] * R * (std::sin(theta) * x - std::cos(theta) * y);
      }
    }
    // Moment balance: M_N = pi R (b_1, -a_1) = -offset m e_z x acceleration + h e_z x (friction force).
    const double ax = a, ay = v * v / 0.15;
    const double mx = offset * m * ay, my = -offset * m * ax, p = ring::pi * R;
    // Linear system with u = unit: a_1 (p + h u_1x) + b_1 h u_2x = -my - h a0 u_0x and a_1 h u_1y + b_1 (p +
    // h u_2y) = mx - h a0 u_0y.
    const double c11 = p + h * unit[1][0], c12 = h * unit[2][0], c21 = h * unit[1][1],
                 c22 = p + h * unit[2][1];
    const double r1 = -my - h * a0 * unit[0][0], r2 = mx - h * a0 * unit[0][1];
    const double det = c11 * c22 - c12 * c21;
    const double a1 = (r1 * c22 - r2 * c12) / det, b1 = (c11 * r2 - c21 * r1) / det;
    return a0 * unit[0][2] + a1 * unit[1][2] + b1 * unit[2][2];
  };
  std::vector<double> omegas = { 0 };
  constexpr unsigned int n_outputs = 200;
  // If the motion starts from rest, the damping rate of omega is proportional to 1 / v, i.e. to 1 / t. The
  // time steps are therefore proportional to t.
  double omega = 0, t = v0 > 0 ? 0 : 1e-6;
  for (unsigned int i = 1; i <= n_outputs; ++i)
  {
    for (const double next = end * i / n_outputs; next - t > 1e-12;)
    {
      const double dt = std::min({ next - t, end / n_outputs / 10, v0 > 0 ? end : t / 20 });
      const double k1 = torque(t, omega) / inertia, k2 = torque(t + dt / 2, omega + dt / 2 * k1) / inertia,
                   k3 = torque(t + dt / 2, omega + dt / 2 * k2) / inertia,
                   k4 = torque(t + dt, omega + dt * k3) / inertia;
      omega += dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
      t += dt;
    }
    omegas.push_back(omega);
  }
  return omegas;
}

double largest_difference(const std::vector<double> &one, const std::vector<double> &other)
{
  EXPECT_EQ(one.size(), other.size());
  double largest = 0;
  for (std::size_t i = 0; i < std::min(one.size(), other.size()); ++i)
    largest = std::max(largest, std::abs(one[i] - other[i]));
  return largest;
}

} // namespace

TEST(OrbitSpeed, AFileWithConstantSpeedGivesTheSameSpinsAsNoFile)
{
  std::vector<double> steady;
  const std::string constant = "# a motor\nt (s), v (cm/s)\n0, 35\n1, 35\n3, 35\n";
  const auto ring = driven(constant, { "Load/Source=first harmonic" }, &steady);
  EXPECT_LT(largest_difference(ring[3], steady), 1e-10 * 0.35 / 0.03);
  const auto foot = driven(constant, {}, &steady);
  EXPECT_LT(largest_difference(foot[3], steady), 1e-7 * 0.35 / 0.03);
}

TEST(OrbitSpeed, SpinUpFromRestAgreesWithAnotherIntegration)
{
  const std::vector<double> expected = integrated_ramp(0, 0.25, 1);
  const auto from_rest = [](const std::string &rows, std::vector<std::string> settings)
  {
    settings.insert(settings.end(), { "Motion/End time=1", "Motion/Orbit speed=0.2" });
    return driven("t (s), v (m/s)\n" + rows, settings)[3];
  };
  const std::string ramp = "0, 0\n1, 0.25\n", ring = "Load/Source=first harmonic";
  const std::vector<double> omegas = from_rest(ramp, { ring });
  EXPECT_LT(largest_difference(omegas, expected), 1e-7);
  // Nearly equal coefficients give Coulomb friction, by quadrature instead of kernels.
  EXPECT_LT(largest_difference(from_rest(ramp, { ring, "Motion/Friction law=Stribeck",
                                                 "Motion/Static friction coefficient=0.3000001" }),
                               omegas),
            1e-5);
  EXPECT_LT(largest_difference(from_rest(ramp, {}), expected), 0.05 * std::abs(expected.back()));
  const std::vector<double> later =
    driven("t (s), v (m/s)\n0, 0\n0.5, 0\n0.75, 0.0625\n1, 0.125\n1.5, 0.25\n",
           { ring, "Motion/End time=1.5", "Motion/Orbit speed=0.2" })[3];
  EXPECT_EQ(later[60], 0); // t = 0.45 s: the orbit speed is still 0
  EXPECT_NEAR(later.back() / expected.back(), 1, 0.02);
}

// Rigid flat land in full contact. Reference: tests/verification/driven_flat_land.py, which uses quadrature
// in two dimensions and another time integration.
TEST(OrbitSpeed, ErrorBandOfADrivenSpinContainsTheError)
{
  const ScratchFolder scratch;
  for (const auto &[rows, end, right] : { std::tuple("0, 0.2\n0.6, 0.35\n", "0.6", -2.222908755),
                                          std::tuple("0, 0.35\n0.8, 0.15\n", "0.8", -0.690948606) })
  {
    const std::string speeds = scratch.write("speeds.csv", std::string("t (s), v (m/s)\n") + rows);
    const auto summary = solved(scratch, { "run" },
                                { "Motion/Orbit speed file=" + speeds, std::string("Motion/End time=") + end,
                                  "Motion/Orbit speed=0.3", "Motion/Tilt=neglected", "Glass/Crown radius=0",
                                  "Glass/Young modulus=2e20", "Contact/Friction coupling=none",
                                  "Table/Interface=Winkler", "Table/Substrate=rigid" },
                                std::string("results_") + end);
    const auto &driven = summary["ring"]["driven"];
    const double band = driven["band_at_end"].get<double>();
    EXPECT_NEAR(driven["omega_at_end"].get<double>(), right, band) << rows;
    EXPECT_LT(band, 2e-5) << rows;
  }
}

TEST(OrbitSpeed, BreakawayAgreesWithStaticFrictionAndBadCoefficientsAreRefused)
{
  const ScratchFolder scratch;
  scratch.write("v.csv", "t (s), v (m/s)\n0, 0\n0.3, 0\n2, 0.5\n");
  const std::vector<std::string> command = { "run", "--set", "Motion/Orbit speed file=v.csv" };
  const auto breakaway = [&](const std::vector<std::string> &settings)
  { return solved(scratch, command, settings)["ring"]["driven"]["breakaway"]; };
  // The hand exerts the force mu N at the height h = R = 3 cm, so the moment ratio is 2 mu h / R = 2 mu.
  const std::string ring = "Load/Source=first harmonic";
  for (const auto &[settings, mu] :
       { std::pair(std::vector<std::string>{ ring }, 0.3),
         std::pair(std::vector<std::string>{ ring, "Motion/Breakaway friction=0.4" }, 0.4),
         std::pair(std::vector<std::string>{ ring, "Motion/Friction law=Stribeck",
                                             "Motion/Static friction coefficient=0.45" },
                   0.45) })
  {
    const nlohmann::json found = breakaway(settings);
    EXPECT_EQ(found["time"], 0.3);
    EXPECT_NEAR(found["force"].get<double>(), mu * 0.3 * 9.81, 1e-12);
    EXPECT_NEAR(found["moment_ratio"].get<double>(), 2 * mu, 1e-9);
  }
  // An elastic foot leans, and the weight of the leaning glass slightly increases the moment ratio.
  const double leaning = breakaway({ "Motion/Breakaway friction=0.4" })["moment_ratio"];
  EXPECT_GT(leaning, 0.8);
  EXPECT_LT(leaning, 0.8 * 1.01);
  for (const char *source : { "Load/Source=first harmonic", "Load/Source=contact" })
  {
    const Ended falls =
      stemware(scratch, with_settings(command, { source, "Motion/Breakaway friction=1.1" }));
    EXPECT_EQ(falls.exit_code, 1);
    EXPECT_THAT(falls.err, testing::HasSubstr("before the hand's force reaches"));
  }
  EXPECT_THAT(stemware(scratch, with_settings(command, { ring, "Motion/Breakaway friction=0.2" })).err,
              testing::HasSubstr("at least the coefficient of sliding"));
}

TEST(OrbitSpeed, ReportsTheSpinChangeFromLinearToCubicInterpolationOfTheSpeeds)
{
  // The table `dense` has many rows on the polygon through `rows`, so the cubic interpolation of `dense`
  // nearly equals the polygon.
  const std::vector<std::pair<double, double>> rows = { { 0, 0.1 },  { 0.3, 0.18 }, { 0.6, 0.29 },
                                                        { 1, 0.35 }, { 1.4, 0.33 }, { 1.7, 0.24 },
                                                        { 2, 0.15 } };
  std::ostringstream given, dense;
  for (std::ostringstream *file : { &given, &dense })
    *file << std::setprecision(12) << "t (s), v (m/s)\n";
  constexpr unsigned int n = 40;
  for (std::size_t i = 0; i + 1 < rows.size(); ++i)
    for (unsigned int k = 0; k < n; ++k)
      dense << rows[i].first + (rows[i + 1].first - rows[i].first) * k / n << ", "
            << rows[i].second + (rows[i + 1].second - rows[i].second) * k / n << '\n';
  dense << "2, 0.15\n";
  for (const auto &[time, speed] : rows)
    given << time << ", " << speed << '\n';

  const ScratchFolder scratch;
  const nlohmann::json said =
    solved(scratch, { "run" },
           { "Load/Source=first harmonic",
             "Motion/Orbit speed file=" + scratch.write("v.csv", given.str()) })["ring"]["driven"];
  const std::vector<double> cubic = read_columns(scratch / "results/driven_spin_up.csv")[3],
                            lines = driven(dense.str(), { "Load/Source=first harmonic" })[3];
  const double most = largest_difference(cubic, lines), at_end = std::abs(cubic.back() - lines.back());
  EXPECT_GT(most, 1e-2); // larger than the error band [rad/s]
  EXPECT_NEAR(said["interpolation_change"].get<double>() / most, 1, 0.02);
  EXPECT_NEAR(said["interpolation_change_at_end"].get<double>(), at_end, 0.02 * most);
  EXPECT_THAT(page_document(scratch / "results")["words"]["driven"].get<std::string>(),
              testing::HasSubstr("monotone cubic"));
}

TEST(OrbitSpeed, NamesTheErrorOfABadFile)
{
  const ScratchFolder scratch;
  const auto refused =
    [&](const std::string &text, const std::string &why, std::vector<std::string> more = {})
  {
    more.push_back("Motion/Orbit speed file=" + scratch.write("speeds.csv", text));
    EXPECT_THAT(sentence_of([&] { pipeline::read_study("", more); }), testing::HasSubstr(why));
  };
  const std::string good = "t (s), v (m/s)\n0, 0.2\n2, 0.5\n";
  refused("", "has no rows");
  refused("0, 0.2\n", "has one row");
  refused("t (s), v (m/s)\n0, 0.2\n0, 0.5\n", "line 3");
  refused("t (s), v (m/s)\n0, 0.2\n2, -1\n", "greater than 0");
  refused("t (s), v (m/s)\n0, 0.2\n1, 0\n2, 0.3\n", "line 3");
  // With the hand 5 cm below the centre of mass and Closure::paper, the glass tips at acceleration / gravity
  // = 32 mm / 5 cm (outer radius of the land / distance), i.e. v = 0.9704 m/s.
  refused("t (s), v (m/s)\n0, 0.2\n2, 1.2\n", "v = 0.97", { "Motion/Closure=paper" });
  refused("t (s), v (m/s)\n0, 0.2\n1, 0.5\n", "does not reach t = 2 s");
  refused(good, "Load/Coupling = two-way", { "Load/Moment ratio=0.3" });
  const Ended missing = stemware(scratch, { "run", "--set", "Motion/Orbit speed file=none.csv" });
  EXPECT_EQ(missing.exit_code, 1);
  EXPECT_EQ(names_in(scratch.path()), std::vector<std::string>{ "speeds.csv" });
}

} // namespace stemware::test
