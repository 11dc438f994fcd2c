// Studies with a solid foot in balance with its friction. Oracle: the body of revolution, whose friction is a
// column of compliances.
#include "tests/fem/pipeline/program_runner.h"

#include <gtest/gtest.h>

#include <cmath>

namespace stemware::test
{
namespace
{

/// A flat land of 2 mm on a mat; full moment balance, tilt and friction in the foot are the defaults.
const char *flat_land = R"(
subsection Motion
  set Friction coefficient = 0.3
  set End time = 0.2
end
subsection Glass
  set Shape = step
  set Land width = 0.002
  set Crown radius = 0
end
subsection Table
  set Interface = Winkler
  set Substrate = rigid
  set Foundation modulus = 1e10
end
subsection Contact
  set Harmonics = 16
  set Azimuth lines = 64
  set Load harmonics = 8
  set Azimuthal cells = 24
  set Radial cells = 2
  set Foot layers = 1
end
)";

/// The terminal spin with all harmonics, by the verb that asks for no more than that.
double truncated_spin(const ScratchFolder &scratch, const std::vector<std::string> &settings)
{
  std::vector<std::string> arguments = { "truncate", scratch.write("flat.prm", flat_land), "--output",
                                         "results" };
  for (const std::string &setting : settings)
    arguments.insert(arguments.end(), { "--set", setting });
  const Ended ended = stemware(scratch, arguments);
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  return read_summary(scratch / "results")["truncation"].back()["omega_terminal"].get<double>();
}

TEST(SolidRun, TerminalSpinIsThatOfTheBodyOfRevolution)
{
  const ScratchFolder scratch;
  const auto spin = [&](const std::string &setting)
  { return truncated_spin(scratch, { "Contact/Body=" + setting }); };
  const double expected = spin("revolution");
  EXPECT_NEAR(spin("solid") / expected, 1, 1e-4);
  // What friction in the foot does.
  const double without = truncated_spin(scratch, { "Contact/Friction coupling=none" });
  EXPECT_GT(std::abs(without / expected - 1), 1e-3);
}

} // namespace
} // namespace stemware::test
