// The results of `converge` from a refinement made by hand, whose numbers are all different.
#include "fem/pipeline/result/verb_results.h"
#include "tests/fem/pipeline/result/hand_made_studies.h"

#include <gtest/gtest.h>

namespace stemware::pipeline
{
namespace
{

using namespace test;

Results made_convergence()
{
  const RefinementByHand by_hand;
  return convergence_results(Study(), by_hand.axes, by_hand.bands);
}

TEST(ConvergenceByHand, DataFile)
{
  EXPECT_EQ(file_lines(made_convergence(), "converge.csv"), R"(axis (): meridional_mesh | meridional_mesh
level (1): -1 | 0
size (1): 0 | 1
unknowns (1): 561 | 561
b_2/a_0 (1): 1.0701234567 | 1.0801234567
terminal spin (rad/s): 1.1301234567 | 1.1401234567
)");
}

TEST(ConvergenceByHand, Summary)
{
  const Results results = made_convergence();
  EXPECT_EQ(results.summary["refinement"]["meridional_mesh"]["figures"]["omega_terminal"].dump(),
            R"({"values":[1.1301234567,1.1401234567],"order":1.1501234567,"limit":1.1601234567,)"
            R"("bands":[0.0011701234567,0.0011801234567]})");
  const nlohmann::ordered_json &band = results.summary["error_bands"]["omega_terminal"];
  EXPECT_EQ(band["value"], 1.0401234567);
  EXPECT_EQ(band["band"], 0.0010501234567);
  EXPECT_EQ(band["unit"], "rad/s");
  EXPECT_EQ(band["richardson"], 1.0601234567);
  EXPECT_EQ(results.key_figures["omega_terminal_band"], 0.0010501234567);
}

} // namespace
} // namespace stemware::pipeline
