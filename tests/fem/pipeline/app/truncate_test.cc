// `stemware truncate`: fewer and fewer harmonics, in balance with their own friction, or of the load of rest.
#include "tests/fem/pipeline/program_runner.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <sstream>

namespace stemware::test
{
namespace
{

using Json = nlohmann::json;

/// The default glass, in balance at every spin unless @p settings say otherwise.
std::vector<std::string> arguments(const ScratchFolder &scratch, const std::string &verb,
                                   const std::vector<std::string> &settings)
{
  std::vector<std::string> all = { verb,       scratch.write("study.prm", plain_study()),
                                   "--output", verb,
                                   "--set",    "Motion/End time=0.2" };
  for (const std::string &setting : settings)
    all.insert(all.end(), { "--set", setting });
  if (std::none_of(settings.begin(), settings.end(),
                   [](const std::string &setting) { return setting.rfind("Load/Coupling=", 0) == 0; }))
    all.insert(all.end(), { "--set", "Load/Coupling=two-way" });
  return all;
}

Json summary_of(const ScratchFolder &scratch, const std::string &verb,
                const std::vector<std::string> &settings = {})
{
  const Ended ended = stemware(scratch, arguments(scratch, verb, settings));
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  return read_summary(scratch / verb);
}

double number(const Json &row, const std::string &key)
{
  return row[key].get<double>();
}

/// The default glass truncated, whose results several tests read and none changes.
class TruncatedGlass : public testing::Test
{
protected:
  static void SetUpTestSuite() { shared = std::make_unique<Run>(); }
  static void TearDownTestSuite() { shared.reset(); }
  void SetUp() override { ASSERT_EQ(shared->ended.exit_code, 0) << shared->ended.err; }

  static std::filesystem::path results() { return shared->scratch / "truncate"; }
  static Json summary() { return read_summary(results()); }
  static const Ended &ended() { return shared->ended; }

private:
  struct Run
  {
    const ScratchFolder scratch;
    const Ended ended = stemware(scratch, arguments(scratch, "truncate", {}));
  };
  static inline std::unique_ptr<Run> shared;
};

/// A load at rest with its first @p n harmonics, and its friction by plain quadrature: every point of the
/// ring by itself, no kernel.
class PlainRing
{
public:
  PlainRing(const Json &load, unsigned int n)
      : a(load["a"].get<std::vector<double>>())
      , b(load["b"].get<std::vector<double>>())
      , radius(number(load, "ring_radius"))
  {
    if (n + 1 < a.size())
    {
      a.resize(n + 1);
      b.resize(n + 1);
    }
  }

  double load(double theta) const
  {
    double sum = a[0];
    for (std::size_t n = 1; n < a.size(); ++n)
      sum +=
        a[n] * std::cos(static_cast<double>(n) * theta) + b[n] * std::sin(static_cast<double>(n) * theta);
    return sum;
  }

  /// tau_z = -mu R int lambda (e_theta . v_rel) / |v_rel| dtheta for the default glass.
  double torque(double omega) const
  {
    double sum = 0;
    for (unsigned int i = 0; i < n_points; ++i)
    {
      const double theta = spacing * i;
      const double x = 0.35 - omega * radius * std::sin(theta), y = omega * radius * std::cos(theta);
      sum += load(theta) * (x * std::sin(theta) - y * std::cos(theta)) / std::hypot(x, y);
    }
    return 0.30 * radius * sum * spacing;
  }

  /// What it pulls with over its weight.
  double pulling_share() const
  {
    double sum = 0;
    for (unsigned int i = 0; i < n_points; ++i)
      sum += std::max(0., -load(spacing * i));
    return sum / (a[0] * n_points);
  }

private:
  static constexpr unsigned int n_points = 512;
  const double spacing = 2 * std::acos(-1.) / n_points;
  std::vector<double> a, b;
  double radius;
};

} // namespace

TEST_F(TruncatedGlass, RowsAreThoseOfRun)
{
  const ScratchFolder scratch;
  const Json truncated = summary()["truncation"];
  const Json run = summary_of(scratch, "run")["truncation"];
  ASSERT_EQ(truncated.size(), run.size());
  for (std::size_t i = 0; i < run.size(); ++i)
  {
    EXPECT_EQ(truncated[i]["harmonics"], run[i]["harmonics"]);
    // Harmonics are good to 1e-11 of a_0 (ElasticFoot::accuracy()): bounds below that have no digits.
    const double rounding = 1e-11 * number(run[0], "bound");
    for (const char *key : { "tau_at_rest", "omega_terminal", "bound", "load_minimum" })
      EXPECT_NEAR(number(truncated[i], key), number(run[i], key),
                  std::max(1e-9 * std::abs(number(run[i], key)), rounding))
        << key << " of " << run[i]["harmonics"];
  }
}

TEST_F(TruncatedGlass, FromTheFormalFirstHarmonicToTheStudyItself)
{
  const Json summary = TruncatedGlass::summary();
  const double omega = -3.6490; // issue of the fast body: contact and friction in balance at every spin
  const Json &rows = summary["truncation"];
  EXPECT_NEAR(number(rows.back(), "omega_terminal"), omega, 2e-4);
  for (const char *key : { "relative_change", "bound" })
    EXPECT_EQ(number(rows.back(), key), 0) << key;
  // The first harmonic alone, in balance: that of a ring of the contact radius, but for where the foot
  // touches.
  EXPECT_NEAR(number(rows[0], "omega_terminal"), -3.67874799852576, 1e-3);
  // The one effect of harmonics.
  const double effect = number(rows.back(), "omega_terminal") - number(rows[0], "omega_terminal");
  EXPECT_GT(std::abs(effect), 1e-3);
  EXPECT_NEAR(number(summary["harmonic_effect"], "absolute"), effect, 1e-12);
  EXPECT_NEAR(number(summary["harmonic_effect"], "relative"), effect / number(rows[0], "omega_terminal"),
              1e-12);
}

TEST(Truncate, OneWayRowsByPlainQuadrature)
{
  // A static study with lift-off: the load is the same at every spin.
  const ScratchFolder scratch;
  const Json summary =
    summary_of(scratch, "truncate", { "Load/Moment ratio=1.3", "Load/Coupling=one-way", "Contact/Rings=1" });
  const Json &rows = summary["truncation"];
  for (const std::size_t row : { rows.size() - 1, std::size_t(0), std::size_t(1), std::size_t(2) })
  {
    const PlainRing ring(summary["load"], rows[row]["harmonics"].get<unsigned int>());
    EXPECT_NEAR(number(rows[row], "tau_at_rest"), ring.torque(0), 1e-15);
    EXPECT_NEAR(ring.torque(number(rows[row], "omega_terminal")), 0, 5e-14) << row;
    EXPECT_NEAR(number(rows[row], "pulling_share"), ring.pulling_share(), 2e-5) << row; // its kinks
  }
  // The first harmonic alone pulls on the arc where 1 + m cos < 0.
  const double m = std::hypot(summary["load"]["a"][1].get<double>(), summary["load"]["b"][1].get<double>()) /
                   summary["load"]["a"][0].get<double>();
  EXPECT_GT(m, 1.2);
  EXPECT_NEAR(number(rows[0], "pulling_share"), (std::sqrt(m * m - 1) - std::acos(1 / m)) / std::acos(-1.),
              1e-12);
  EXPECT_NEAR(number(rows[0], "load_minimum"), summary["load"]["a"][0].get<double>() * (1 - m), 1e-12);
}

TEST(Truncate, AGlassThatFallsOnTheWay)
{
  // Other code, fold over the lean at fixed spins: no balance of this height between -9.09 and -9.34 rad/s.
  const ScratchFolder scratch;
  const Json summary = summary_of(scratch, "truncate",
                                  { "Glass/Young modulus=7e16", "Contact/Friction coupling=none",
                                    "Motion/Tilt=included", "Motion/Centre of mass height=0.1346" });
  EXPECT_NEAR(number(summary["fall"], "omega"), -9.0916, 0.015);
  EXPECT_NEAR(number(summary["fall"], "moment_ratio"), 1.9, 0.05);
  const Json &all = summary["truncation"].back();
  EXPECT_TRUE(all["omega_terminal"].is_null());
  EXPECT_TRUE(summary["harmonic_effect"]["absolute"].is_null());
  EXPECT_NEAR(number(all, "tau_at_rest"), -3.687e-3, 2e-6); // between the heights 0.134 and 0.1438
}

TEST(Truncate, LoadsThatDoNotSpinOrHaveOneHarmonic)
{
  const ScratchFolder scratch;
  const Json rest =
    summary_of(scratch, "truncate", { "Load/Moment ratio=0", "Load/Coupling=one-way" })["truncation"];
  EXPECT_NEAR(number(rest[0], "omega_terminal"), 0, 1e-9);
  EXPECT_TRUE(rest[0]["relative_change"].is_null());
  const Json one =
    summary_of(scratch, "truncate", { "Load/Source=first harmonic", "Load/Coupling=one-way" })["truncation"];
  ASSERT_EQ(one.size(), 1u);
  EXPECT_NEAR(number(one[0], "omega_terminal"), -3.67874799852576, 1e-10);
}

} // namespace stemware::test
