#include "tests/fem/pipeline/csv_table.h"
#include "tests/fem/pipeline/matchers.h"
#include "tests/fem/pipeline/program_runner.h"
#include "tests/verification/lifted_annulus.h"

#include <gtest/gtest.h>

namespace stemware::test
{
namespace
{

constexpr double land_inner = 0.020, land_outer = 0.040, crest_radius = 0.030, glass_weight = 10;

/// Returns a study as text: rigid foot on a mat, flat land between the radii 20 and 40 mm, weight 10 N.
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

TEST(Tipping, LiftedFlatLandAgreesWithTheClosedForm)
{
  const ScratchFolder scratch;
  scratch.write("wide.prm", wide_land("2.2"));
  for (const double ratio : { 1.5, 2.2, 2.5 })
  {
    const verification::LiftedAnnulus exact(land_inner, land_outer, ratio * crest_radius / 2);
    const double peak = glass_weight / exact.per_slope * (land_outer - exact.zero);
    const nlohmann::json summary =
      solved(scratch, { "run", "wide.prm", "--quick" }, { "Load/Moment ratio=" + std::to_string(ratio) });
    EXPECT_NEAR(summary["load"]["peak_pressure"].get<double>() / peak, 1, 2e-3) << ratio;
    EXPECT_NEAR(summary["load"]["contact_fraction"].get<double>(), exact.share, 2e-3) << ratio;
  }
}

TEST(Tipping, RunAndSweepUseTheSameTippingLimit)
{
  const ScratchFolder scratch;
  scratch.write("falls.prm", wide_land("2.7")); // above the tipping limit 2 * 40 mm / 30 mm
  const std::vector<std::string> run = { "run", "falls.prm", "--quick" };
  const Ended refused = stemware(scratch, run);
  EXPECT_EQ(refused.exit_code, 1) << refused.err;
  EXPECT_THAT(refused.err, testing::HasSubstr("2.66667"));
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
