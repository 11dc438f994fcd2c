// The report of `run`: the answer with the numbers of summary.json, every figure, nothing from outside.
#include "tests/fem/pipeline/matchers.h"
#include "tests/fem/pipeline/program_runner.h"

#include <boost/algorithm/string/replace.hpp>
#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fmt/format.h>
#include <memory>
#include <sstream>
#include <thread>

namespace stemware::test
{
namespace
{

namespace fs = std::filesystem;

/// Arguments of a run of the glass as a body of revolution whose foot lifts off, with a short spin-up.
std::vector<std::string> lifted_run(const ScratchFolder &scratch,
                                    const std::string &moment = "Load/Moment ratio=1.3")
{
  std::vector<std::string> arguments = { "run", scratch.write("study.prm", plain_study()), "--output",
                                         "results" };
  for (const std::string &setting :
       { std::string("Contact/Body=revolution"), moment, std::string("Motion/Closure=paper"),
         std::string("Motion/End time=0.2"), std::string("Motion/Euler step=0.01") })
    arguments.insert(arguments.end(), { "--set", setting });
  return arguments;
}

/// One such run, whose results all tests read and none changes.
class RunReport : public testing::Test
{
protected:
  static void SetUpTestSuite() { shared = std::make_unique<Run>(); }
  static void TearDownTestSuite() { shared.reset(); }
  void SetUp() override { ASSERT_EQ(shared->ended.exit_code, 0) << shared->ended.err; }

  static fs::path results() { return shared->scratch / "results"; }
  static std::string html() { return read_text(results() / "report.html"); }
  static const Ended &ended() { return shared->ended; }

private:
  struct Run
  {
    const ScratchFolder scratch;
    const Ended ended = stemware(scratch, lifted_run(scratch));
  };
  static inline std::unique_ptr<Run> shared;
};

/// Runs the same glass on a first-harmonic load, which needs neither finite elements nor MPI.
Ended run_first_harmonic(const ScratchFolder &scratch, const std::string &moment = "Load/Moment ratio=1.3")
{
  std::vector<std::string> arguments = lifted_run(scratch, moment);
  arguments.insert(arguments.end(), { "--set", "Load/Source=first harmonic" });
  return stemware(scratch, arguments);
}

/// The number in front of "\u00b1 band" in @p text, and the band; both as printed.
std::pair<double, double> with_band(const std::string &printed)
{
  const std::string text = boost::replace_all_copy(printed, "\u2212", "-");
  const auto sign = text.find(" \u00b1 ");
  if (sign == std::string::npos)
    return { std::nan(""), std::nan("") };
  const auto begin = text.find_last_of(" \n", sign - 1) + 1;
  return { std::stod(text.substr(begin)), std::stod(text.substr(sign + std::string(" \u00b1 ").size())) };
}

std::string per_cent(double change)
{
  char text[32];
  std::snprintf(text, sizeof(text), "%.3g\u00a0%%", 100 * std::abs(change));
  return text;
}

const std::vector<std::string> figures = {
  "waterfall", "effects",       "harmonic_torque", "load",    "line_load", "higher_harmonics", "spectrum",
  "torque",    "spin_up",       "truncation",      "section", "rim",       "foot_from_above",  "footprint",
  "slip",      "section_stress"
};

TEST_F(RunReport, AnswersWithTheNumbersOfTheSummary)
{
  const auto summary = read_summary(results());
  const std::string answer = between(html(), "<p class=\"answer\">", "</p>");
  const double omega = summary["ring"]["omega_terminal"];
  const double band = summary["error_bands"]["omega_terminal"]["band"];
  const double effect = summary["harmonic_effect"]["relative"];
  // What is printed contains what is meant, and not much more.
  for (const std::string &text : { answer, ended().out })
  {
    const auto [value, printed_band] = with_band(text);
    EXPECT_LE(std::abs(value - omega) + band, printed_band * (1 + 1e-9)) << text;
    EXPECT_LE(printed_band, 1.2 * band) << text;
  }
  EXPECT_THAT(answer, testing::HasSubstr("load beyond the first"));
  EXPECT_THAT(answer, testing::HasSubstr(per_cent(effect) + (effect > 0 ? " faster" : " slower")));
  EXPECT_THAT(answer, testing::HasSubstr("(one-way)")); // its moment is given
  EXPECT_THAT(ended().out,
              testing::HasSubstr("\nReport    " + fs::absolute(results() / "report.html").string() + "\n"));
}

TEST_F(RunReport, HasEveryFigureAndLinksThatLead)
{
  EXPECT_EQ(ended().err, "");
  const std::string page = html();
  for (const std::string &name : figures)
  {
    for (const char *extension : { ".svg", ".pdf", ".gp" })
      EXPECT_GT(fs::file_size(results() / "figures" / (name + extension)), 0u) << name << extension;
    const std::string figure = between(page, "<figure id=\"" + name + "\">", "</figure>");
    for (const char *part : { "<svg", "figcaption", "\">data</a>" })
      EXPECT_THAT(figure, testing::HasSubstr(part)) << name << part;
  }
  EXPECT_EQ(all_between(page, "<figure id=\"", "\"").size(),
            figures.size() + 2); // and two drawings in the head
  const auto links = all_between(page, "<a href=\"", "\"");
  EXPECT_GT(links.size(), 4 * figures.size());
  for (const std::string &link : links)
    EXPECT_TRUE(fs::exists(results() / link)) << link;
  EXPECT_EQ(read_summary(results())["files"].get<std::vector<std::string>>(), names_in(results()));
}

TEST_F(RunReport, StandsAloneAndIsWellFormed)
{
  std::string page = html();
  std::istringstream stream(page);
  boost::property_tree::ptree tree;
  EXPECT_NO_THROW(boost::property_tree::read_xml(stream, tree));
  EXPECT_EQ(page.rfind("<!DOCTYPE html>", 0), 0u);
  // Names of XML's vocabularies are not addresses: nothing is loaded from them.
  for (const char *vocabulary : { "http://www.w3.org/2000/svg", "http://www.w3.org/1999/xlink" })
    for (auto at = page.find(vocabulary); at != std::string::npos; at = page.find(vocabulary))
      page.erase(at, std::string(vocabulary).size());
  for (const char *address : { "http:", "https:", "src=", "@import", "url(h", "//", "<script" })
    EXPECT_THAT(page, testing::Not(testing::HasSubstr(address)));
}

TEST_F(RunReport, SaysWhichParametersDiffer)
{
  const std::string page = html(), study = between(page, "<h2>The study</h2>", "</section>");
  EXPECT_THAT(study, testing::HasSubstr("Load/Moment ratio"));
  EXPECT_THAT(study, testing::Not(testing::HasSubstr("Motion/Mass")));
  EXPECT_THAT(between(page, "<h2>All parameters</h2>", "</details>"), testing::HasSubstr("Motion/Mass"));
}

TEST(FirstHarmonicReport, OfAGlassThatDoesNotSpinUp)
{
  const ScratchFolder scratch;
  const Ended ended = run_first_harmonic(scratch, "Load/Moment ratio=0");
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_EQ(ended.err, "");
  const std::string html = read_text(scratch / "results/report.html");
  EXPECT_THAT(html, testing::HasSubstr("The glass does not spin up."));
  EXPECT_THAT(html, testing::HasSubstr("<figure id=\"torque\">"));
  for (const char *of_the_spin : { "spin_up", "waterfall", "effects", "truncation" })
    EXPECT_THAT(html, testing::Not(testing::HasSubstr(std::string("<figure id=\"") + of_the_spin + "\">")))
      << of_the_spin;
}

/// Another PATH for a while.
class Programs
{
public:
  explicit Programs(const std::string &path)
      : before(std::getenv("PATH"))
  {
    ::setenv("PATH", path.c_str(), 1);
  }
  ~Programs() { ::setenv("PATH", before.c_str(), 1); }

private:
  std::string before;
};

TEST(FirstHarmonicReport, IsWrittenWithoutGnuplot)
{
  const ScratchFolder scratch;
  Ended ended;
  {
    const Programs none((scratch / "nowhere").string());
    ended = run_first_harmonic(scratch);
  }
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_EQ(all_between(ended.err, "gnuplot-nox", ")").size(), 1u) << ended.err; // said once, in advance
  const std::string html = read_text(scratch / "results/report.html");
  EXPECT_THAT(html, testing::HasSubstr("gnuplot-nox"));
  EXPECT_EQ(html.find("<svg", html.find("<section>")), std::string::npos); // drawings of the head need none
  for (const std::string &link : all_between(html, "<a href=\"", "\""))
    EXPECT_TRUE(fs::exists(scratch / "results" / link)) << link;
  // What is missing can be drawn later.
  const Ended drawn = RunningProgram({ "/bin/sh", "-c", "gnuplot figures/*.gp" }, scratch / "results").end();
  EXPECT_EQ(drawn.exit_code, 0) << drawn.err;
  for (const char *name : { "load", "torque", "spin_up" })
    EXPECT_TRUE(fs::exists(scratch / "results/figures" / (name + std::string(".svg")))) << name;
}

TEST(FirstHarmonicReport, TemplatesOfTheSharedFolderComeBeforeThoseThatAreCompiledIn)
{
  const ScratchFolder scratch;
  fs::create_directory(scratch / "bin");
  fs::copy_file(STEMWARE_PROGRAM, scratch / "bin/stemware");
  fs::create_directories(scratch / "share/stemware/plots");
  scratch.write("share/stemware/plots/torque.gp",
                "# My torque.\nload \"figures/style.gnuplot\"\neval from_csv\nset ylabel \"mine\"\n"
                "set xlabel sprintf(\"N %.2f\", {{load.normal_force}})\n"
                "plot \"spin_up.csv\" using 1:2 with lines title kept(n_all)\n");
  std::vector<std::string> command = lifted_run(scratch);
  command.insert(command.begin(), (scratch / "bin/stemware").string());
  command.insert(command.end(), { "--set", "Load/Source=first harmonic" });
  const Ended ended = RunningProgram(command, scratch.path()).end();
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_EQ(ended.err, "");
  const std::string figure =
    between(read_text(scratch / "results/report.html"), "<figure id=\"torque\">", "</figure>");
  const double force = read_summary(scratch / "results")["load"]["normal_force"];
  for (const std::string &own :
       { std::string("My torque."), std::string(">mine</"), std::string("href=\"spin_up.csv\">data</a>"),
         fmt::format(FMT_STRING(">N {:.2f}</"), force) })
    EXPECT_THAT(figure, testing::HasSubstr(own)) << own << '\n' << figure;
  EXPECT_TRUE(fs::exists(scratch / "results/figures/spin_up.svg")); // which has no template there
}

} // namespace
} // namespace stemware::test
