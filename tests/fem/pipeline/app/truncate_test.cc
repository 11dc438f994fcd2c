// `stemware truncate`: fewer and fewer harmonics, in balance with their own friction, or of the load of rest.
#include "ring_model/first_harmonic_ring.h"
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

/// The terminal spin of a first harmonic on a ring of this radius in closed form, closure `full`.
double first_harmonic_spin(double radius)
{
  return ring::FirstHarmonicRing(ring::Closure::full, ring::Motion(), radius).terminal_spin().omega;
}

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
  const auto spin_up = read_columns(scratch / "run/spin_up.csv");
  const auto by_harmonics = read_columns(results() / "spin_up.csv");
  ASSERT_EQ(by_harmonics.size(), run.size() + 1);
  for (std::size_t i = 0; i < spin_up[0].size(); ++i)
    EXPECT_NEAR(by_harmonics.back()[i], spin_up[1][i], 1e-7) << "t = " << spin_up[0][i];
}

TEST(Truncate, FirstHarmonicInBalanceOnAThinRing)
{
  const ScratchFolder scratch;
  const Json first = summary_of(
    scratch, "truncate",
    { "Glass/Land width=2e-4", "Glass/Crown radius=0", "Glass/Young modulus=7e13" })["truncation"][0];
  EXPECT_NEAR(number(first, "omega_terminal"), -3.67875, 1e-4); // docs/theory/closures.md
}

TEST_F(TruncatedGlass, FromTheFormalFirstHarmonicToTheStudyItself)
{
  const Json summary = TruncatedGlass::summary();
  const double omega = -3.6490; // issue of the fast body: contact and friction in balance at every spin
  const Json &rows = summary["truncation"];
  EXPECT_NEAR(number(rows.back(), "omega_terminal"), omega, 2e-4);
  for (const char *key : { "relative_change", "spin_up_deviation", "bound" })
    EXPECT_EQ(number(rows.back(), key), 0) << key;
  // The first harmonic alone, in balance: that of a ring of the contact radius, but for where the foot
  // touches.
  EXPECT_NEAR(number(rows[0], "omega_terminal"), first_harmonic_spin(0.03), 1e-3);
  // The one effect of harmonics.
  const double effect = number(rows.back(), "omega_terminal") - number(rows[0], "omega_terminal");
  EXPECT_GT(std::abs(effect), 1e-3);
  EXPECT_NEAR(number(summary["harmonic_effect"], "absolute"), effect, 1e-12);
  EXPECT_NEAR(number(summary["harmonic_effect"], "relative"), effect / number(rows[0], "omega_terminal"),
              1e-12);
}

TEST(Truncate, BoundHoldsAndDeviationsShrink)
{
  const ScratchFolder scratch;
  const Json summary = summary_of(scratch, "truncate", { "Motion/Centre of mass height=0.1" }); // lift-off
  const Json &rows = summary["truncation"];
  EXPECT_NEAR(summary["torque_at"][1].get<double>(), number(rows.back(), "omega_terminal"), 1e-9);
  double deviation = 1;
  for (const Json &row : rows)
  {
    // There the torque of all harmonics vanishes: what is left is that of the harmonics left out.
    const double torque = std::abs(row["torque"][1].get<double>());
    EXPECT_LE(torque, number(row, "bound") + 1e-13) << row["harmonics"];
    EXPECT_TRUE(row["harmonics"] != 1 || torque > 1e-6); // the bound bounds something
    if (row["harmonics"] == 1 || row["harmonics"] == 3 || row["harmonics"] == 8)
    {
      EXPECT_LT(number(row, "spin_up_deviation"), deviation / 2) << row["harmonics"];
      deviation = number(row, "spin_up_deviation");
    }
  }
  // m > 1: the first harmonic alone would have to pull, and says so.
  EXPECT_EQ(rows[0]["pulls"], true);
  EXPECT_LT(number(rows[0], "load_minimum"), 0);
}

TEST(Truncate, OneWayRowsByPlainQuadrature)
{
  // A static study with lift-off: the load is the same at every spin.
  const ScratchFolder scratch;
  const Json summary =
    summary_of(scratch, "truncate", { "Load/Moment ratio=1.3", "Load/Coupling=one-way", "Contact/Rings=1" });
  const auto spin_up = read_columns(scratch / "truncate/spin_up.csv");
  const Json &rows = summary["truncation"];
  ASSERT_EQ(spin_up.size(), rows.size() + 1);
  const std::vector<double> omega = summary["torque_at"].get<std::vector<double>>();
  EXPECT_NEAR(omega[0], omega[1] / 2, 1e-12);
  double largest = 0;
  for (const std::size_t row : { rows.size() - 1, std::size_t(0), std::size_t(1), std::size_t(2) })
  {
    const PlainRing ring(summary["load"], rows[row]["harmonics"].get<unsigned int>());
    EXPECT_NEAR(number(rows[row], "tau_at_rest"), ring.torque(0), 1e-15);
    for (std::size_t i = 0; i < omega.size(); ++i)
      EXPECT_NEAR(rows[row]["torque"][i].get<double>(), ring.torque(omega[i]), 1e-14) << row;
    EXPECT_NEAR(ring.torque(number(rows[row], "omega_terminal")), 0, 5e-14) << row;
    EXPECT_NEAR(number(rows[row], "pulling_share"), ring.pulling_share(), 2e-5) << row; // its kinks

    // omega(t) by the classical Runge-Kutta method, I_z d omega / dt = tau_z.
    double spin = 0, deviation = 0;
    for (std::size_t i = 0; i + 1 < spin_up[0].size(); ++i)
    {
      const double step = (spin_up[0][i + 1] - spin_up[0][i]) / 3.0e-4;
      const double k1 = ring.torque(spin), k2 = ring.torque(spin + step * k1 / 2),
                   k3 = ring.torque(spin + step * k2 / 2), k4 = ring.torque(spin + step * k3);
      spin += step * (k1 + 2 * k2 + 2 * k3 + k4) / 6;
      EXPECT_NEAR(spin_up[row + 1][i + 1], spin, 1e-8) << row;
      deviation = std::max(deviation, std::abs(spin_up[row + 1][i + 1] - spin_up.back()[i + 1]));
    }
    EXPECT_NEAR(number(rows[row], "spin_up_deviation"), deviation, 1e-12) << row;
    largest = std::max(largest, deviation);
  }
  EXPECT_GT(largest, 0.01);
  // The first harmonic alone pulls on the arc where 1 + m cos < 0.
  const double m = std::hypot(summary["load"]["a"][1].get<double>(), summary["load"]["b"][1].get<double>()) /
                   summary["load"]["a"][0].get<double>();
  EXPECT_GT(m, 1.2);
  EXPECT_NEAR(number(rows[0], "pulling_share"), (std::sqrt(m * m - 1) - std::acos(1 / m)) / std::acos(-1.),
              1e-12);
  EXPECT_NEAR(number(rows[0], "load_minimum"), summary["load"]["a"][0].get<double>() * (1 - m), 1e-12);
}

TEST(Truncate, TorqueAtChosenSpins)
{
  const ScratchFolder scratch;
  auto words = arguments(scratch, "truncate", {});
  words.insert(words.end(), { "--at", "0", "--at", "-5", "--json", "--quiet" });
  const Ended ended = stemware(scratch, words);
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  const Json summary = read_summary(scratch / "truncate");
  EXPECT_EQ(summary["torque_at"], Json::array({ 0., -5. }));
  for (const Json &row : summary["truncation"])
  {
    // mu M_Nx, which lies in the first harmonic.
    EXPECT_NEAR(row["torque"][0].get<double>(), -0.003675, 1e-12);
    EXPECT_GT(row["torque"][1].get<double>(), 0); // beyond the terminal spin
  }
  const Json line = Json::parse(ended.out);
  EXPECT_EQ(line["verb"], "truncate");
  EXPECT_EQ(line["omega_terminal"], summary["truncation"].back()["omega_terminal"]);
  EXPECT_EQ(line["harmonic_effect"], summary["harmonic_effect"]["absolute"]);
  EXPECT_TRUE(std::filesystem::exists(scratch / line["report"].get<std::string>()));
}

TEST(Truncate, OneWayAndTwoWayAreOneWithoutFrictionInTheBalance)
{
  const ScratchFolder scratch;
  const std::vector<std::string> settings = { "Motion/Closure=paper", "Contact/Friction coupling=none" };
  std::vector<std::string> one_way = settings;
  one_way.push_back("Load/Coupling=one-way");
  const Json rows = summary_of(scratch, "truncate", settings)["truncation"];
  const Json kept = summary_of(scratch, "truncate", one_way)["truncation"];
  ASSERT_EQ(rows.size(), kept.size());
  for (std::size_t i = 0; i < rows.size(); ++i)
    EXPECT_NEAR(number(rows[i], "omega_terminal"), number(kept[i], "omega_terminal"), 1e-10);
  EXPECT_NEAR(number(rows[0], "omega_terminal"), -3.12056, 1e-3);
}

TEST(Truncate, TheStudysOwnLoadMayBeThatOfRest)
{
  const ScratchFolder scratch;
  const Json truncated = summary_of(scratch, "truncate", { "Load/Coupling=one-way" });
  const Json run = summary_of(scratch, "run", { "Load/Coupling=one-way" });
  EXPECT_NEAR(number(truncated["truncation"].back(), "omega_terminal"), number(run["ring"], "omega_terminal"),
              1e-9);
  EXPECT_NE(read_text(scratch / "truncate/report.html").find("One-way: the load of rest"), std::string::npos);
}

TEST_F(TruncatedGlass, ReportHasTheAnswerAndTheFigures)
{
  const std::string page = read_text(results() / "report.html");
  for (const char *figure :
       { "waterfall", "load", "spectrum", "terminal_spin", "torque", "spin_up", "deviation" })
  {
    EXPECT_NE(page.find(std::string("<figure id=\"") + figure + "\""), std::string::npos) << figure;
    for (const char *kind : { ".svg", ".pdf", ".gp" })
      EXPECT_TRUE(std::filesystem::exists(results() / "figures" / (std::string(figure) + kind)))
        << figure << kind;
  }
  // The console: no line too wide, no colours.
  std::istringstream lines(ended().out);
  for (std::string line; std::getline(lines, line);)
    EXPECT_LE(line.size(), 100u) << line;
  EXPECT_EQ(ended().out.find('\x1b'), std::string::npos);
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

TEST(Truncate, BadRequestsAreRefusedInOneSentence)
{
  const ScratchFolder scratch;
  for (const auto &[further, sentence] :
       { std::pair(std::vector<std::string>{ "--at", "fast" }, "\"fast\" is not a spin"),
         { { "--at", "nan" }, "\"nan\" is not a spin" },
         { { "--at", "1e9" }, "give a number between -1e6 and 1e6" },
         { { "--vary", "Motion/Mass=1:2:3" }, "--vary" },
         { { "--set", "Motion/Closure=best" }, "Closure" },
         { { "--set", "Glass/Rim waviness=3: 2e-6" }, "Glass/Rim waviness makes the load depend" },
         { { "--set", "Table/Waviness=3: 2e-6" }, "Table/Waviness makes the load depend" },
         { { "--set", "Motion/Centre of mass height=0.2" }, "tips" } })
  {
    auto words = arguments(scratch, "truncate", {});
    words.insert(words.end(), further.begin(), further.end());
    const Ended ended = stemware(scratch, words);
    EXPECT_EQ(ended.exit_code, 1) << sentence;
    EXPECT_NE(ended.err.find(sentence), std::string::npos) << ended.err;
    EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 1) << ended.err;
    EXPECT_FALSE(std::filesystem::exists(scratch / "truncate"));
  }
}

} // namespace stemware::test
