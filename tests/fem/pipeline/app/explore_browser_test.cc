// The committed page in a real browser, on a desk and on a phone: five moves of sliders beside the program.
#include "fem/pipeline/analysis/study_rows.h"
#include "fem/pipeline/coupling/study_load.h"
#include "fem/pipeline/study/study_entries.h"
#include "tests/fem/pipeline/browser.h"

#include <gtest/gtest.h>

#include <utility>

namespace stemware::test
{
namespace
{

namespace fs = std::filesystem;

const std::vector<std::pair<std::string, std::string>> moves = { { "Motion/Friction coefficient", "0.2" },
                                                                 { "Motion/Orbit speed", "0.25" },
                                                                 { "Motion/Force offset", "-0.03" },
                                                                 { "Motion/Centre of mass height", "0.1" },
                                                                 { "Table/Foundation modulus", "1e11" } };

/// A page that opens @p page in a frame of each width, makes the moves there one after the other, and
/// replaces itself by what it finds. It is not loaded before: a frame in it that nobody closes holds it open.
std::string moving_page(const std::string &page)
{
  return R"(<!DOCTYPE html><meta charset="utf-8"><body><script>
)" + axe_script() +
         R"(
const holder = document.createElement("iframe");
document.body.append(holder);
holder.contentDocument.open();
(async () => {
  const found = {};
  for (const width of [1100, 400]) {
    const frame = document.createElement("iframe");
    frame.style = "border:0;height:900px;width:" + width + "px";
    frame.srcdoc = )" +
         script_string(page) + R"(;
    document.body.append(frame);
    while (!frame.contentWindow.started)
      await new Promise(r => setTimeout(r, 20));
    const omega = [];
    let last;
    for (const [path, value] of )" +
         nlohmann::json(moves).dump() + R"() {
      last = await frame.contentWindow.move(path, value);
      omega.push(last.omega);
    }
    found[width] = { omega: omega, errors: last.errors, text: last.text, width: frame.contentDocument.documentElement.scrollWidth,
                     serious: await serious(frame.contentWindow) };
    frame.remove();
  }
  const closing = holder.contentDocument;
  document.body.textContent = "MEASURED" + JSON.stringify(found) + "MEASURED";
  closing.close();
})();
</script></body>)";
}

TEST(ExplorePage, MovesInABrowserGiveTheProgramsSpins)
{
  const ScratchFolder scratch;
  const std::string page =
    scratch.write("moving.html", moving_page(read_text(fs::path(STEMWARE_DOCS) / "explore.html")));
  const Ended ended = chromium(scratch, { "--dump-dom", "file://" + page });
  const nlohmann::json found = nlohmann::json::parse(between(ended.out, "MEASURED", "MEASURED"));
  pipeline::Study study;
  fem::ComplianceCache cache;
  for (std::size_t i = 0; i < moves.size(); ++i)
  {
    pipeline::assign(pipeline::study_entries(study), "", moves[i].first, moves[i].second);
    const auto foot = pipeline::study_foot(study, cache);
    const double omega =
      pipeline::spin_row(*pipeline::find_load(study, foot), pipeline::spin_question(study)).terminal->omega;
    for (const char *const width : { "1100", "400" })
      EXPECT_NEAR(found[width]["omega"][i].get<double>(), omega, 1e-10) << moves[i].first << ", " << width;
  }
  for (const char *const width : { "1100", "400" })
  {
    EXPECT_TRUE(found[width]["errors"].empty()) << found[width]["errors"];
    EXPECT_EQ(found[width]["serious"], nlohmann::json::array()) << found[width]["serious"].dump(1);
    EXPECT_LE(found[width]["width"].get<int>(), std::stoi(width)) << "the page has to be scrolled sideways";
    EXPECT_NE(found[width]["text"].get<std::string>().find("rad/s"), std::string::npos);
  }
}

} // namespace
} // namespace stemware::test
