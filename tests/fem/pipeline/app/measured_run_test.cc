// Measured spin-ups are loaded into the live page from tables of several formats.
#include "ring_model/load/constants.h"
#include "tests/fem/pipeline/browser.h"
#include "tests/fem/pipeline/matchers.h"

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace stemware::test
{
namespace
{

/// Returns a script that opens @p page and loads @p tables (file name to text) with @p units (file name to
/// unit). For each table, the script returns the status, the offered columns and the drawn points.
std::string measured_script(const std::string &page, const nlohmann::ordered_json &tables,
                            const std::map<std::string, std::string> &units)
{
  return framed(page, 400) + R"(
  const wait = async until => { while (!until()) await new Promise(r => setTimeout(r, 20)); };
  await wait(() => frame.contentWindow?.started && frame.contentDocument.body.dataset.rested);
  const shown = frame.contentWindow, root = shown.document, $ = id => root.getElementById(id);
  const blobs = [];
  shown.URL.createObjectURL = blob => (blobs.push(blob), "data:,");
  shown.HTMLAnchorElement.prototype.click = () => {};
  const points = async () => {
    root.querySelectorAll("#live_spin figcaption button.file")[2].click();
    const rows = (await blobs.pop().text()).trim().split("\r\n").map(row => row.split(","));
    return rows.filter(row => row[0] == "measured").map(row => row.slice(1).map(Number));
  };
  const found = {}, units = )" +
         nlohmann::json(units).dump() + R"(;
  for (const [name, text] of Object.entries()" +
         nlohmann::json(tables).dump() + R"()) {
    const files = new shown.DataTransfer();
    files.items.add(new shown.File([text], name));
    $("measured").files = files.files;
    $("measured").dispatchEvent(new shown.Event("change"));
    await wait(() => $("measured-status").textContent.startsWith(name));
    if (units[name]) {
      $("measured-unit").value = units[name];
      $("measured-unit").dispatchEvent(new shown.Event("change"));
    }
    found[name] = { status: $("measured-status").textContent, hidden: $("measured-choice").hidden, points: await points(),
                    columns: [...$("measured-column").options].map(option => option.text) };
  }
  found.width = root.documentElement.scrollWidth;
  found.ran = Boolean(window.ran);
  return found;)";
}

TEST(ExplorePage, DrawsMeasuredRunsOfFourFileFormatsAndRefusesAFileWithoutNumbers)
{
  using Points = std::vector<std::pair<double, double>>;
  const std::string hostile = "<img src=x onerror=parent.ran=1>.csv";
  const nlohmann::ordered_json tables = {
    // File of the app phyphox with decimal commas. The column with the largest range is offered first.
    { "phone.csv", "\"Time (s)\";\"x (rad/s)\";\"y (rad/s)\";\"z (rad/s)\"\n"
                   "2,00;0,1;0,0;0\n2,50;0,2;0,1;-1,5\n3,00;0,1;0,0;-2,25E0\n" },
    { "degrees.csv", "t,omega\n0,0\n1,-180\n" },
    // Angles from a film, with a title line and an incomplete row.
    { "film.txt", "mass_A\nt\ttheta\n0\t0\n0.5\t-90\n1\t-270\n1.5\t\n2\t-810\n" },
    { "radians.txt", "0 0\n0.5 -1\n1 -4\n" },
    { hostile, "no numbers\nhere\n" }
  };
  const std::map<std::string, std::string> units = {
    { "phone.csv", "rad/s" }, { "degrees.csv", "°/s" }, { "film.txt", "°" }, { "radians.txt", "rad" }
  };
  const std::map<std::string, Points> expected = {
    { "phone.csv", { { 0, 0 }, { 0.5, -1.5 }, { 1, -2.25 } } },
    { "degrees.csv", { { 0, 0 }, { 1, -ring::pi } } },
    { "film.txt", { { 0.5, -1.5 * ring::pi }, { 1, -8. / 3 * ring::pi } } },
    { "radians.txt", { { 0.5, -4 } } }
  };
  const ScratchFolder scratch;
  ASSERT_EQ(stemware(scratch, { "explore", "--output", "page.html" }).exit_code, 0);
  const nlohmann::json found =
    found_in_browser(scratch, measured_script(read_text(scratch / "page.html"), tables, units));
  for (const auto &[name, points] : expected)
  {
    SCOPED_TRACE(name);
    const auto drawn = found[name]["points"].get<Points>();
    ASSERT_EQ(drawn.size(), points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      EXPECT_NEAR(drawn[i].first, points[i].first, 1e-12);
      EXPECT_NEAR(drawn[i].second, points[i].second, 1e-12);
    }
  }
  EXPECT_EQ(found["phone.csv"]["columns"], nlohmann::json({ "z (rad/s)", "x (rad/s)", "y (rad/s)" }));
  EXPECT_EQ(found["film.txt"]["columns"], nlohmann::json({ "theta" }));
  EXPECT_EQ(found["radians.txt"]["columns"], nlohmann::json({ "column 2" }));
  EXPECT_THAT(found["phone.csv"]["status"].get<std::string>(), testing::HasSubstr("3 points in 1\u00a0s"));
  EXPECT_THAT(found[hostile]["status"].get<std::string>(), testing::HasSubstr("no two columns of numbers"));
  EXPECT_TRUE(found[hostile]["hidden"].get<bool>());
  EXPECT_EQ(found[hostile]["points"], nlohmann::json::array());
  EXPECT_LE(found["width"].get<int>(), 400);
  EXPECT_FALSE(found["ran"].get<bool>());
}

} // namespace
} // namespace stemware::test
