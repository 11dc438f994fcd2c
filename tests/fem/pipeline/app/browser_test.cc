// The report in a real browser, on a phone and on a desk. Built where Debian's Chromium is installed.
#include "tests/fem/pipeline/program_runner.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

namespace stemware::test
{
namespace
{

namespace fs = std::filesystem;

/// A page that shows @p html in a frame of @p width pixels and replaces itself by what it measures there: for
/// each figure its width, height and number of visible texts, and the width of all that is in the page.
std::string measuring_page(const std::string &html, unsigned int width)
{
  std::string quoted = nlohmann::json(html).dump();
  for (auto at = quoted.find("</"); at != std::string::npos; at = quoted.find("</", at + 3))
    quoted.insert(at + 1, "\\");
  return R"(<!DOCTYPE html><meta charset="utf-8"/><body><iframe style="border:0;height:800px;width:)" +
         std::to_string(width) + R"(px"></iframe><script>
const frame = document.querySelector("iframe");
frame.onload = () => {
  const page = frame.contentDocument;
  const figures = Array.from(page.querySelectorAll("figure")).map(figure => {
    const svg = figure.querySelector("svg"), box = svg.getBoundingClientRect();
    const texts = Array.from(svg.querySelectorAll("text")).filter(text => text.getBoundingClientRect().width > 0);
    return { name: figure.id, width: box.width, height: box.height, texts: texts.length };
  });
  const measured = { figures: figures, width: page.documentElement.scrollWidth };
  document.body.textContent = "MEASURED" + JSON.stringify(measured) + "MEASURED";
  console.log("the browser has measured");
};
frame.srcdoc = )" +
         quoted + ";</script></body>";
}

/// Measures of a report, and a check that the browser had nothing to complain about.
nlohmann::json measure(const ScratchFolder &scratch, const fs::path &report, unsigned int width)
{
  const std::string page = scratch.write("measure.html", measuring_page(read_text(report), width));
  const Ended ended =
    RunningProgram({ STEMWARE_CHROMIUM, "--headless", "--no-sandbox", "--disable-gpu",
                     "--disable-dev-shm-usage", "--no-first-run", "--hide-scrollbars", "--disable-extensions",
                     "--disable-background-networking", "--user-data-dir=" + (scratch / "profile").string(),
                     "--enable-logging=stderr", "--window-size=1280,1000", "--dump-dom", "file://" + page },
                   scratch.path())
      .end();
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  // Our own message shows that messages of the page would be seen.
  std::size_t n_messages = 0;
  for (auto at = ended.err.find(":CONSOLE"); at != std::string::npos; at = ended.err.find(":CONSOLE", at + 1))
    ++n_messages;
  EXPECT_EQ(n_messages, 1u) << ended.err;
  EXPECT_NE(ended.err.find("the browser has measured"), std::string::npos) << ended.err;
  const auto begin = ended.out.find("MEASURED");
  if (begin == std::string::npos)
    throw std::runtime_error("the browser has measured nothing: " + ended.out.substr(0, 500));
  return nlohmann::json::parse(
    ended.out.substr(begin + 8, ended.out.find("MEASURED", begin + 8) - begin - 8));
}

class Browser : public testing::TestWithParam<unsigned int>
{
};

TEST_P(Browser, ShowsEveryFigureAndNothingWiderThanThePage)
{
  const ScratchFolder scratch;
  const Ended run =
    stemware(scratch, { "run", scratch.write("study.prm", "# defaults\n"), "--output", "results", "--set",
                        "Contact/Body=revolution", "--set", "Motion/Closure=paper" });
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto measured = measure(scratch, scratch / "results/report.html", GetParam());
  EXPECT_EQ(measured["width"].get<double>(), GetParam()) << "the page has to be scrolled sideways";
  EXPECT_GE(measured["figures"].size(), 6u);
  for (const auto &figure : measured["figures"])
  {
    EXPECT_GT(figure["width"].get<double>(), 0.85 * std::min(GetParam(), 500u)) << figure;
    EXPECT_LE(figure["width"].get<double>(), GetParam()) << figure;
    EXPECT_GT(figure["height"].get<double>(), 0.5 * figure["width"].get<double>()) << figure;
    EXPECT_GE(figure["texts"].get<unsigned int>(), 5u) << figure; // labels and keys
  }
}

INSTANTIATE_TEST_SUITE_P(Report, Browser, testing::Values(390u, 1200u),
                         [](const auto &info) { return std::to_string(info.param) + "px"; });

} // namespace
} // namespace stemware::test
