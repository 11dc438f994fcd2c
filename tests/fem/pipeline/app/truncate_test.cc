#include "tests/fem/pipeline/program_runner.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace stemware::test
{
namespace
{

using Json = nlohmann::json;

Json summary_of(const std::string &verb, const std::vector<std::string> &settings = {})
{
  const ScratchFolder scratch;
  return solved(scratch,
                with_settings({ verb, scratch.write("study.prm", plain_study()) },
                              { "Motion/End time=0.2", "Load/Coupling=two-way" }),
                settings);
}

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

TEST(Truncate, RowsAgreeWithTheTruncationRowsOfTheCommandRun)
{
  const Json truncated = truncated_glass()["truncation"], run = summary_of("run")["truncation"];
  ASSERT_EQ(truncated.size(), run.size());
  for (std::size_t i = 0; i < run.size(); ++i)
  {
    EXPECT_EQ(truncated[i]["harmonics"], run[i]["harmonics"]);
    // Harmonics are accurate to 1e-11 of a_0 (ElasticFoot::accuracy()). Bounds below this accuracy consist of
    // rounding errors.
    const double rounding = 1e-11 * number(run[0], "bound");
    for (const char *key : { "tau_at_rest", "omega_terminal", "bound", "least_load" })
      EXPECT_NEAR(number(truncated[i], key), number(run[i], key),
                  std::max(1e-9 * std::abs(number(run[i], key)), rounding))
        << key << " of " << run[i]["harmonics"];
  }
}

TEST(Truncate, SpinsOfTheFirstHarmonicAndOfAllHarmonicsAgreeWithReferences)
{
  // Reference for all harmonics: independent program with contact and friction in balance at every spin.
  const double omega = -3.6490;
  const Json &rows = truncated_glass()["truncation"];
  EXPECT_NEAR(number(rows.back(), "omega_terminal"), omega, 2e-4);
  for (const char *key : { "relative_change", "bound" })
    EXPECT_EQ(number(rows.back(), key), 0) << key;
  // Reference for the first harmonic: ring of the contact radius. The tolerance allows for contact at
  // slightly different radii.
  EXPECT_NEAR(number(rows[0], "omega_terminal"), -3.67874799852576, 1e-3);
}

} // namespace stemware::test
