// `stemware truncate`: fewer and fewer harmonics, in balance with their own friction, or of the load of rest.
#include "tests/fem/pipeline/program_runner.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace stemware::test
{
namespace
{

using Json = nlohmann::json;

/// The default glass in balance at every spin.
Json summary_of(const std::string &verb, const std::vector<std::string> &settings = {})
{
  const ScratchFolder scratch;
  return solved(scratch,
                with_settings({ verb, scratch.write("study.prm", plain_study()) },
                              { "Motion/End time=0.2", "Load/Coupling=two-way" }),
                settings);
}

/// Solved once.
const Json &truncated_glass()
{
  static const Json summary = summary_of("truncate");
  return summary;
}

double number(const Json &row, const std::string &key)
{
  return row[key].get<double>();
}

} // namespace

TEST(Truncate, RowsAreThoseOfRun)
{
  const Json truncated = truncated_glass()["truncation"], run = summary_of("run")["truncation"];
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

TEST(Truncate, FromTheFormalFirstHarmonicToTheStudyItself)
{
  const Json &summary = truncated_glass();
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

TEST(Truncate, AGlassThatFallsOnTheWay)
{
  // Other code, fold over the lean at fixed spins: no balance of this height between -9.09 and -9.34 rad/s.
  const Json summary = summary_of("truncate", { "Glass/Young modulus=7e16", "Contact/Friction coupling=none",
                                                "Motion/Tilt=included", "Motion/Centre of mass height=0.1346",
                                                "Motion/Force offset=-0.05" });
  EXPECT_NEAR(number(summary["fall"], "omega"), -9.0916, 0.015);
  EXPECT_NEAR(number(summary["fall"], "moment_ratio"), 1.9, 0.05);
  const Json &all = summary["truncation"].back();
  EXPECT_TRUE(all["omega_terminal"].is_null());
  EXPECT_TRUE(summary["harmonic_effect"]["absolute"].is_null());
  EXPECT_NEAR(number(all, "tau_at_rest"), -3.687e-3, 2e-6); // between the heights 0.134 and 0.1438
}

} // namespace stemware::test
