// Reports: one page that stands alone, pictures that can be drawn again, and neither lost without the other.
#include "fem/pipeline/report/plot.h"
#include "fem/pipeline/report/render/marked_text.h"
#include "fem/pipeline/report/render/table_renderers.h"
#include "fem/pipeline/report/results.h"
#include "tests/fem/pipeline/program_runner.h"

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <set>
#include <sstream>
#include <thread>

namespace stemware::pipeline
{
namespace
{

using test::all_files;
using test::read_text;
using test::ScratchFolder;

/// A report with two plots, which borrow the same parts of gnuplot's, and characters that mean something to
/// HTML.
Report small_report()
{
  const std::string data = "# parabola\n# 1: x (1)\n# 2: y (1)\n0 0\n1 1\n2 4\n";
  const Plot first = { "first", "τ_z & \"more\"",
                       "load 'figures/style.gnuplot'\nset title " + gnuplot_text("<τ_z> & {more}_1") +
                         "\nplot data with linespoints title 'λ(θ)'",
                       data };
  const Plot second = { "second", "twice", "width = 400; load 'figures/style.gnuplot'\nplot data with points",
                        data };
  const Table table = table_of(
    { { { "name of it", "x < y" }, { "a_2", "1.5" } }, { { "name of it", "spin_up" }, { "a_2", "-2e-3" } } },
    "", "", "numbers");
  return { "A <title>",
           "The answer is -3.5 ± 0.1 rad/s & no more.",
           { { "Section", "One.\n\nTwo, see τ_z.", { first, second }, { table } },
             { "Files", "", {}, {}, { { "summary.json", "everything" } }, true } } };
}

/// The PATH of this process, changed for a while.
class PathChange
{
public:
  explicit PathChange(const std::string &path)
      : before(std::getenv("PATH"))
  {
    ::setenv("PATH", path.c_str(), 1);
  }
  ~PathChange() { ::setenv("PATH", before.c_str(), 1); }

private:
  std::string before;
};

boost::property_tree::ptree parse(const std::string &html)
{
  std::istringstream stream(html);
  boost::property_tree::ptree tree;
  boost::property_tree::read_xml(stream, tree);
  return tree;
}

TEST(Report, HasPlotsInEveryFormAndOnePage)
{
  const ScratchFolder scratch;
  testing::internal::CaptureStderr();
  write_report(small_report(), scratch.path());
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  std::set<std::string> names;
  for (const auto &[name, content] : all_files(scratch.path()))
    names.insert(name);
  EXPECT_EQ(names, (std::set<std::string>{ "figures/first.dat", "figures/first.gp", "figures/first.pdf",
                                           "figures/first.svg", "figures/second.dat", "figures/second.gp",
                                           "figures/second.pdf", "figures/second.svg",
                                           "figures/style.gnuplot", "report.html" }));
  EXPECT_EQ(read_text(scratch / "figures/first.pdf").substr(0, 5), "%PDF-");
}

TEST(Report, IsWellFormedAndEscapedOnce)
{
  const ScratchFolder scratch;
  write_report(small_report(), scratch.path());
  const auto page = parse(read_text(scratch / "report.html")).get_child("html");
  EXPECT_EQ(page.get<std::string>("head.title"), "A <title>");
  EXPECT_EQ(page.get<std::string>("body.main.h1"), "A <title>");
  EXPECT_EQ(page.get<std::string>("body.main.p"), "The answer is \u22123.5 ± 0.1\u00a0rad/s & no more.");
  const auto &figure = page.get_child("body.main.section.div.figure");
  EXPECT_EQ(figure.get<std::string>("svg.<xmlattr>.aria-label"), "τ_z & \"more\"");
  EXPECT_EQ(figure.get<std::string>("figcaption.sub"), "z");
}

TEST(Report, PicturesDoNotShareTheirParts)
{
  const ScratchFolder scratch;
  write_report(small_report(), scratch.path());
  const std::string html = read_text(scratch / "report.html");
  std::set<std::string> ids;
  std::size_t n_ids = 0;
  for (std::size_t at = html.find(" id="); at != std::string::npos; at = html.find(" id=", at + 1), ++n_ids)
    ids.insert(html.substr(at + 5, html.find(html[at + 4], at + 5) - at - 5));
  EXPECT_EQ(ids.size(), n_ids);
  EXPECT_TRUE(ids.count("first-gpDot") && ids.count("second-gpDot"));
  for (std::size_t at = html.find("href='#"); at != std::string::npos; at = html.find("href='#", at + 1))
    EXPECT_EQ(ids.count(html.substr(at + 7, html.find('\'', at + 7) - at - 7)), 1u);
}

/// The texts of an SVG or HTML without its elements.
std::string without_tags(const std::string &marked)
{
  std::string text;
  bool is_tag = false;
  for (const char character : marked)
  {
    is_tag = character == '<' || (is_tag && character != '>');
    if (!is_tag && character != '>')
      text += character;
  }
  return plain_text(text);
}

TEST(Report, TextsOfAPictureRunNoCommand)
{
  const ScratchFolder scratch;
  const std::string words = "`touch PWN` $(touch PWN) '; system('touch PWN'); x='";
  const std::string others = "\"; system(\"touch PWN\"); x=\" @x {/Bold b} a^2 ~ab & \\ %s";
  const std::string lines = "x\nsystem 'touch PWN'\n";
  Plot plot = { "words", "The words.", "load 'figures/style.gnuplot'\nx = 'macro'\n", "0 0\n1 1\n" };
  plot.script += "array names[1] = [" + gnuplot_text(others) + "]\nset title " + gnuplot_text(words) +
                 "\nset xlabel " + gnuplot_text(lines) + "\nplot data with lines title names[1]";
  EXPECT_EQ(draw_plots({ plot }, scratch.path()), "");
  for (const auto &[name, content] : all_files(scratch.path()))
    EXPECT_EQ(name.find("PWN"), std::string::npos) << name;
  const std::string drawn = without_tags(read_text(scratch / "figures/words.svg"));
  for (const std::string &shown : { words, others, std::string("x system 'touch PWN'") })
    EXPECT_NE(drawn.find(shown), std::string::npos) << shown << '\n' << drawn;
}

TEST(Report, TextsOfAnyLengthAreWritten)
{
  const ScratchFolder scratch;
  const std::string digits(300000, '1'), letters(300000, 'a');
  EXPECT_EQ(in_form(digits + "e-06", "cell"), digits + " · 10<sup>\u22126</sup>");
  EXPECT_EQ(in_form("1e+006 of 2.5e-10", "cell"), "10<sup>6</sup> of 2.5 · 10<sup>\u221210</sup>");
  EXPECT_EQ(in_form("1.e, e-3, 2e, 3e-, x1e5", "cell"), "1.e, e-3, 2e, 3e-, x1e5");
  EXPECT_EQ(in_form("1e-0", "cell"), "10<sup>\u22120</sup>");
  Plot drawing = { "long", "caption", "" };
  drawing.drawing = "<svg viewBox=\"0 0 1 1\"><title>" + letters + "</title><text>shown</text></svg>";
  write_report({ letters, letters, { { letters, letters, { drawing }, {} } } }, scratch.path());
  const std::string html = read_text(scratch / "report.html");
  EXPECT_NE(html.find(" viewBox=\"0 0 1 1\""), std::string::npos);
  EXPECT_NE(html.find("<text>shown</text></svg>"), std::string::npos);
  EXPECT_EQ(html.find("<title>", html.find("<body>")), std::string::npos);
}

TEST(Report, IsTheSameTwice)
{
  const ScratchFolder scratch;
  std::filesystem::create_directory(scratch / "a");
  std::filesystem::create_directory(scratch / "b");
  write_report(small_report(), scratch / "a");
  std::this_thread::sleep_for(std::chrono::milliseconds(1100)); // a PDF knows the second at which it was made
  write_report(small_report(), scratch / "b");
  EXPECT_EQ(all_files(scratch / "a"), all_files(scratch / "b"));
}

TEST(Report, IsWrittenWithoutGnuplot)
{
  const ScratchFolder scratch;
  const PathChange no_programs(scratch.path().string());
  EXPECT_NE(missing_plotter().find("gnuplot-nox"), std::string::npos);
  testing::internal::CaptureStderr();
  write_report(small_report(), scratch.path());
  EXPECT_EQ(testing::internal::GetCapturedStderr(), ""); // missing_plotter() has said it before the work
  const std::string html = read_text(scratch / "report.html");
  EXPECT_NE(html.find("gnuplot-nox"), std::string::npos);
  EXPECT_EQ(html.find("<svg"), std::string::npos);
  EXPECT_TRUE(std::filesystem::exists(scratch / "figures/first.gp"));
  EXPECT_FALSE(std::filesystem::exists(scratch / "figures/first.svg"));
}

TEST(Report, APlotThatFailsCostsTheOthersNothing)
{
  const ScratchFolder scratch;
  Report report = small_report();
  report.sections[0].plots[0].script = "plot 'no such file'";
  testing::internal::CaptureStderr();
  write_report(report, scratch.path());
  const std::string complaint = testing::internal::GetCapturedStderr();
  EXPECT_NE(complaint.find("figures/first.svg"), std::string::npos) << complaint;
  EXPECT_NE(complaint.find("no such file"), std::string::npos) << complaint;
  EXPECT_EQ(complaint.find("second"), std::string::npos) << complaint;
  EXPECT_FALSE(std::filesystem::exists(scratch / "figures/first.svg"));
  EXPECT_FALSE(std::filesystem::exists(scratch / "figures/first.pdf"));
  EXPECT_TRUE(std::filesystem::exists(scratch / "figures/second.svg"));
  EXPECT_TRUE(std::filesystem::exists(scratch / "figures/second.pdf"));
  const std::string html = read_text(scratch / "report.html");
  EXPECT_NE(html.find("no such file"), std::string::npos);
  EXPECT_EQ(html.find("id=\"first-"), std::string::npos);
  parse(html);
}

TEST(Report, NumbersHaveATrueMinusAndPowersOfTen)
{
  EXPECT_EQ(with_true_minus("-3.5 (-2) ω=-1 x-2 --at one-way <b>-0.1"),
            "\u22123.5 (\u22122) ω=\u22121 x-2 --at one-way <b>\u22120.1");
  Quantity shown = { "n", "n", "1", "n" };
  shown.digits = "#.1e";
  const std::string html = html_table({ "", { { shown, { -3.4e-6, 2e12 } } } });
  EXPECT_NE(html.find("<td class=\"number\">\u22123.4 · 10<sup>\u22126</sup></td>"), std::string::npos)
    << html;
  EXPECT_NE(html.find("<td class=\"number\">2.0 · 10<sup>12</sup></td>"), std::string::npos) << html;
  EXPECT_NE(html_table(table_of({ { { "word", "1e-06" } } })).find(">10<sup>\u22126</sup><"),
            std::string::npos);
  EXPECT_NE(html_table(table_of({ { { "word", "spin 2e-06.prm" } } })).find("2e-06.prm"), std::string::npos);
}

TEST(Report, FormulasOfAPlainText)
{
  EXPECT_EQ(html_formula("τ_z, a_10 < z_CM; spin_up.csv"),
            "τ<sub>z</sub>, a<sub>10</sub> &lt; z<sub>CM</sub>; spin_up.csv");
}

} // namespace
} // namespace stemware::pipeline
