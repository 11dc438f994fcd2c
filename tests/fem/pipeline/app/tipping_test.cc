// A glass on a flat land tips at the border of the land. The oracle is the pressure of a rigid annulus on a
// mat, integrated over chords.
#include "tests/fem/pipeline/csv_table.h"
#include "tests/fem/pipeline/matchers.h"
#include "tests/fem/pipeline/program_runner.h"

#include <gtest/gtest.h>

#include <cmath>

namespace stemware::test
{
namespace
{

constexpr double land_inner = 0.020, land_outer = 0.040, crest_radius = 0.030, glass_weight = 10;

/// A rigid foot with a land from 20 to 40 mm on a mat, under 10 N.
std::string wide_land(const std::string &moment_ratio)
{
  return "subsection Motion\n  set Mass = 1\n  set Gravity = 10\nend\n"
         "subsection Glass\n  set Shape = step\n  set Foot radius = 41 mm\n  set Land width = 20 mm\n"
         "  set Crown radius = 0\n  set Young modulus = 7e16\nend\n"
         "subsection Table\n  set Interface = Winkler\n  set Substrate = rigid\n  set Foundation modulus = "
         "1e9\nend\n"
         "subsection Contact\n  set Friction coupling = none\nend\n"
         "subsection Load\n  set Moment direction = 0\n  set Moment ratio = " +
         moment_ratio + "\nend\n";
}

/// Area, static moment and second moment of the annulus beyond the line x = @p line, about that line's x.
struct Segment
{
  explicit Segment(double line)
  {
    constexpr int n = 200000; // midpoints in the angle, in which the chord of the outer circle is smooth
    const double first = std::acos(std::max(-1., line / land_outer));
    for (int i = 0; i < n; ++i)
    {
      const double angle = first * (i + 0.5) / n, x = land_outer * std::cos(angle);
      const double hole = std::sqrt(std::max(0., land_inner * land_inner - x * x));
      const double strip =
        2 * (land_outer * std::sin(angle) - hole) * land_outer * std::sin(angle) * first / n;
      area += strip;
      first_moment += (x - line) * strip;
      about_axis += x * (x - line) * strip;
    }
  }
  double area = 0, first_moment = 0, about_axis = 0;
};

/// Line of zero pressure under a load at the distance @p lever from the axis, by bisection.
double zero_line(double lever)
{
  double low = -10 * land_outer, high = land_outer * (1 - 1e-9);
  for (int i = 0; i < 100; ++i)
  {
    const double middle = (low + high) / 2;
    const Segment segment(middle);
    (segment.about_axis / segment.first_moment < lever ? low : high) = middle;
  }
  return low;
}

TEST(Tipping, AFlatLandStandsUpToItsOuterBorder)
{
  const ScratchFolder scratch;
  scratch.write("wide.prm", wide_land("2.2"));
  for (const double ratio : { 1.5, 2.2, 2.5 })
  {
    const double line = zero_line(ratio * crest_radius / 2);
    const Segment segment(line);
    const double peak = glass_weight / segment.first_moment * (land_outer - line);
    const nlohmann::json summary =
      solved(scratch, { "run", "wide.prm", "--quick" }, { "Load/Moment ratio=" + std::to_string(ratio) });
    EXPECT_NEAR(summary["load"]["peak_pressure"].get<double>() / peak, 1, 2e-3) << ratio;
    EXPECT_NEAR(summary["load"]["contact_fraction"].get<double>(), segment.area / Segment(-land_outer).area,
                2e-3)
      << ratio;
  }
}

TEST(Tipping, EntriesOptionsAndSweepsAskOneFunction)
{
  const ScratchFolder scratch;
  scratch.write("falls.prm", wide_land("2.7")); // beyond 2 * 40 / 30
  const std::vector<std::string> run = { "run", "falls.prm", "--quick" };
  const Ended refused = stemware(scratch, run);
  EXPECT_EQ(refused.exit_code, 1) << refused.err;
  EXPECT_THAT(refused.err, testing::HasSubstr("2.66667"));
  EXPECT_NEAR(solved(scratch, run, { "Load/Moment ratio=1.99" })["load"]["moment_ratio"].get<double>(), 1.99,
              1e-9)
    << "--set mends what the file says";
  const Ended swept = stemware(
    scratch, { "sweep", "falls.prm", "--vary", "Load/Moment ratio=1.5,2.6,2.7", "--output", "swept" });
  EXPECT_EQ(swept.exit_code, 0) << swept.err;
  const CsvTable table(sorted_by_case(read_text(scratch / "swept/sweep.csv")));
  ASSERT_EQ(table.n_rows(), 3u);
  for (std::size_t row = 0; row < 3; ++row)
    EXPECT_EQ(table.text(row, "status"), table.text(row, "Load/Moment ratio") == "2.7" ? "tips" : "ok")
      << row;
}

} // namespace
} // namespace stemware::test
