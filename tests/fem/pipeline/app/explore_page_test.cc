// `stemware explore` writes docs/explore.html.
#include "fem/pipeline/analysis/study_rows.h"
#include "fem/pipeline/coupling/make_foot.h"
#include "fem/pipeline/coupling/study_load.h"
#include "fem/pipeline/study/study_entries.h"
#include "tests/fem/pipeline/program_runner.h"

#include <gtest/gtest.h>

namespace stemware::test
{
namespace
{

namespace fs = std::filesystem;

nlohmann::json data_of(const std::string &page)
{
  return nlohmann::json::parse(between(page, "id=\"data\">", "</script>"));
}

TEST(ExplorePage, CommittedAnswersAgreeWithTheProgram)
{
  const std::string page = read_text(fs::path(STEMWARE_DOCS) / "explore.html");
  EXPECT_LT(page.size(), 1'800'000u);
  const nlohmann::json pairs = data_of(page)["pairs"];
  EXPECT_EQ(pairs.size(), 4u) << "the pairs that ./quickstart explore asks for";
  for (const auto &[name, pair] : pairs.items())
  {
    pipeline::Study study;
    for (const auto &value : pair["values"])
      pipeline::assign(pipeline::study_entries(study), "", value[0], value[1]);
    fem::ComplianceCache cache;
    const auto foot = pipeline::study_foot(study, pipeline::foot_maker(cache));
    const double omega =
      ring::answer(pipeline::find_load(study, foot), pipeline::spin_question(study)).terminal->omega;
    EXPECT_NEAR(pair["omega"].get<double>(), omega, 1e-9) << name;
    EXPECT_NEAR(pair["here"].get<double>(), omega,
                pair["band"].is_null() ? 1e-10 : pair["band"].get<double>())
      << name;
  }
}

} // namespace
} // namespace stemware::test
