#include "fem/pipeline/result/common_sections.h"
#include "fem/pipeline/study/data_files.h"
#include "tests/fem/pipeline/matchers.h"
#include "tests/fem/pipeline/program_runner.h"
#include "tests/fem/pipeline/refusal.h"

#include <gtest/gtest.h>

namespace stemware::pipeline
{
namespace
{

using test::ScratchFolder;

TEST(LoadFile, IsWrittenAndReadBackExactly)
{
  const ScratchFolder scratch;
  const ring::RingStack load({ 0.47, 0.1 / 3, -1e-7 }, { 0, -0.13, 2e-300 }, 0.0300007);
  const std::string text = load_file_text(load);
  const ring::RingStack again = read_load_file(scratch.write("harmonics.dat", text));
  ASSERT_EQ(again.n_harmonics(), 2u);
  for (unsigned int n = 0; n <= 2; ++n)
  {
    EXPECT_EQ(again.a(n), load.a(n));
    EXPECT_EQ(again.b(n), load.b(n));
  }
  EXPECT_EQ(again.radius(), load.radius());
}

TEST(LoadFile, ReadsSemicolonsDecimalCommasAndUnicodeMinusSigns)
{
  const ScratchFolder scratch;
  const ring::RingStack load =
    read_load_file(scratch.write("load.csv", "# ring radius: 0.03 (m)\n0;0,4;0\n1;−0,125;0,25\n"));
  EXPECT_EQ(load.a(0), 0.4);
  EXPECT_EQ(load.a(1), -0.125);
  EXPECT_EQ(load.b(1), 0.25);
}

TEST(LoadFile, RefusesInvalidLoads)
{
  const ScratchFolder scratch;
  const std::string radius = "# ring radius: 0.03 (m)\n";
  const std::vector<std::pair<std::string, std::string>> cases = {
    { "0 0.4 0\n1 0.1 0\n", "how large the ring is" },
    { "# ring radius: -0.03 (m)\n0 0.4 0\n1 0.1 0\n", "gives no radius" },
    { "# ring radius: nan (m)\n0 0.4 0\n1 0.1 0\n", "gives no radius" },
    { radius, "no first harmonic" },
    { radius + "0 0.4 0\n", "no first harmonic" },
    { radius + "0 -0.4 0\n1 0.1 0\n", "line 2" },
    { radius + "0 0.4 0\n2 0.1 0\n", "line 3" },
    { radius + "0 0.4 0\n1 nan 0\n", "line 3" },
    { radius + "0 0.4 0\n1 0.1\n", "line 3" },
  };
  for (const auto &[text, expected] : cases)
    EXPECT_THAT(test::sentence_of([&, &text = text] { read_load_file(scratch.write("load.dat", text)); }),
                testing::HasSubstr(expected))
      << text;
}

} // namespace
} // namespace stemware::pipeline
