#include "ring_model/load/constants.h"
#include "tests/fem/pipeline/browser.h"
#include "tests/fem/pipeline/matchers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace stemware::test
{
namespace
{

namespace fs = std::filesystem;

struct Opened
{
  std::string name;
  std::vector<std::string> arguments;
};

std::ostream &operator<<(std::ostream &stream, const Opened &report)
{
  return stream << report.name;
}

const std::vector<Opened> &opened()
{
  static const std::string resting = "Load/Coupling=one-way";
  static const std::vector<Opened> reports = {
    { "run", { "run", "study.prm" } },
    { "truncate", { "truncate", "study.prm" } },
    { "converge", { "converge", "study.prm", "--levels", "2", "--set", resting } },
    { "sweep",
      { "sweep", "study.prm", "--set", resting, "--vary", "Motion/Friction coefficient=0.2:0.4:5" } },
    { "sweep_of_maps",
      { "sweep", "study.prm", "--set", "Load/Source=first harmonic", "--vary",
        "Motion/Force offset=-0.075:-0.055:5", "--vary", "Motion/Orbit speed=0.3:0.4:5" } },
  };
  return reports;
}

struct State : Opened
{
  std::string answer; ///< text that the answer contains
  /// Figures that the report shows, and figures that it must not show.
  std::vector<std::string> figures = {}, missing = {};
};

const std::vector<State> &states()
{
  const auto plain = [](const std::vector<std::string> &settings) {
    return with_settings({ "run", "study.prm" }, settings);
  };
  const auto quick = [](const std::vector<std::string> &settings) {
    return with_settings({ "run", "--quick" }, settings);
  };
  const auto of_verb = [](std::size_t i, const std::string &answer, const std::vector<std::string> &figures) {
    return State{ opened().at(i), answer, figures };
  };
  static const std::vector<State> all = {
    of_verb(0, "turns once", { "glass", "scene", "orbits", "waterfall", "effects", "torque_of_harmonics" }),
    of_verb(1, "first harmonic only", { "torque_changes", "truncation", "orbits" }),
    of_verb(2, "Richardson value", { "convergence" }),
    of_verb(3, "5 cases", { "omega_terminal", "harmonic_effect" }),
    of_verb(4, "25 cases", { "omega_terminal", "tau_at_rest" }),
    { { "balanced", quick({}) }, "Quick run", { "spin_up", "slip_at_end" }, { "waterfall" } },
    { { "falling", quick({ "Motion/Centre of mass height=0.138", "Motion/Force offset=-0.05",
                           "Contact/Azimuth lines=64", "Contact/Harmonics=8" }) },
      "tips over",
      { "footprint_at_end" },
      { "slip_at_end", "truncation" } },
    { { "wavy", plain({ "Glass/Rim waviness=3: 1e-6" }) }, "turns once", { "phases", "waterfall" } },
    { { "tensile", plain({ "Load/Source=first harmonic", "Load/Moment ratio=1.3" }) },
      "given moment",
      { "load", "spin_up" },
      { "footprint" } },
    { { "lifted", plain({ "Load/Moment ratio=1.3" }) }, "turns once", { "waterfall", "foot_from_above" } },
    { { "at_rest", plain({ "Load/Source=first harmonic", "Load/Moment ratio=0" }) },
      "does not spin up",
      { "torque", "load" },
      { "spin_up", "waterfall", "effects", "truncation" } },
    { { "driven", quick({ "Motion/Orbit speed file=speeds.csv" }) },
      "turns once",
      { "driven_spin_up", "orbit_speed" } },
    { { "load_file", plain({ "Load/Source=file", "Load/File=load.dat" }) },
      "given load",
      { "load", "waterfall" },
      { "footprint" } },
    { { "mesh", plain({ "Contact/Body=solid", "Contact/Mesh file=flat_foot.msh" }) },
      "turns once",
      { "footprint", "waterfall" },
      { "section_stress" } },
    { { "gripped", plain({ "Motion/Grip torque=1" }) }, "hold", { "torque" }, { "waterfall" } },
    { { "clockwise", quick({ "Motion/Orbit sense=clockwise", "Load/Coupling=one-way" }) },
      "counter-clockwise, against its orbit",
      { "orbits", "glass" } },
    { { "several_spins",
        quick({ "Load/Source=first harmonic", "Motion/Friction law=Stribeck",
                "Motion/Static friction coefficient=1", "Motion/Friction coefficient=0.2",
                "Motion/Friction decay speed=0.3", "Motion/Force offset=-0.01", "Motion/Closure=paper" }) },
      "turns once",
      { "torque" } },
    { { "truncate_one_harmonic", { "truncate", "--set", "Load/Source=first harmonic" } },
      "one harmonic",
      { "load" } },
    { { "sweep_that_fails",
        { "sweep", "study.prm", "--set", "Glass/Shape=profile", "--set", "Glass/Land width=0.0017", "--set",
          "Glass/Profile file=own_profile.csv", "--vary", "Glass/Profile file=own_profile.csv,broken.csv",
          "--vary", "Motion/Mass=0.2,0.3" } },
      "2 of 4 cases failed" },
    { { "sweep_of_a_list", { "sweep", "--set", "Load/Source=first harmonic", "--cases", "cases.csv" } },
      "In 2 cases",
      {},
      { "omega_terminal" } },
  };
  return all;
}

/// Runs the program, opens its report in the browser and returns the page. Expects that the console prints
/// the answer of the report.
nlohmann::json opened_state(const ScratchFolder &scratch, const State &state)
{
  std::vector<std::string> arguments = state.arguments;
  arguments.insert(arguments.end(), { "--output", "results" });
  const Ended run = stemware(scratch, arguments);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_LT(fs::file_size(scratch / "results/report.html"), 350'000u);
  const nlohmann::json page = reports_in_browser(scratch, { "results/report.html" })["results/report.html"];
  EXPECT_THAT(in_one_line(run.out), testing::HasSubstr(in_one_line(page["answer"])));
  return page;
}

/// Returns, for each azimuth, the sum of the signed distances of the footprint's points from the rim [um] and
/// the number of points.
std::map<std::string, std::pair<double, int>> distances_of(const nlohmann::json &rows)
{
  std::map<std::string, std::pair<double, int>> found;
  for (std::size_t i = 1; i < rows.size(); ++i)
  {
    auto &[sum, n] = found[rows[i][1].get<std::string>()];
    sum += std::stod(rows[i][2].get<std::string>());
    ++n;
  }
  return found;
}

class BrowserStates : public testing::TestWithParam<State>
{
};

TEST_P(BrowserStates, ShowTheExpectedFiguresWithoutDefects)
{
  const ScratchFolder scratch;
  scratch.write("study.prm", plain_study());
  scratch.write("speeds.csv", "t (s), v (m/s)\n0, 0.3\n100, 0.35\n");
  scratch.write("load.dat", "# ring radius: 0.03 (m)\n0 0.4684 0\n1 0 -0.1\n2 0.01 0\n");
  scratch.write("broken.csv", "r (m), z (m)\n0, 0\n");
  scratch.write("own_profile.csv", read_text(fs::path(STEMWARE_COOKBOOKS) / "own_profile.csv"));
  scratch.write("cases.csv", "Motion/Mass\n0.2\n0.3\n");
  scratch.write("flat_foot.msh", read_text(fs::path(STEMWARE_DOCS) / "../meshes/flat_foot.msh"));
  const nlohmann::json page = opened_state(scratch, GetParam());
  EXPECT_EQ(page["flaws"], nlohmann::json::array()) << page["flaws"].dump(1);
  EXPECT_THAT(page["answer"].get<std::string>(), testing::HasSubstr(GetParam().answer));
  for (const std::string &figure : GetParam().figures)
    EXPECT_TRUE(page["figures"].contains(figure)) << figure;
  for (const std::string &figure : GetParam().missing)
    EXPECT_FALSE(page["figures"].contains(figure)) << figure;
  // The pressure on a rounded rim is symmetric about the contact radius, even at the onset of lift-off.
  if (GetParam().name == "falling")
  {
    const double width = read_summary(scratch / "results")["load"]["contact_width"].get<double>() * 1e6;
    const auto distances = distances_of(page["figures"]["footprint"]);
    EXPECT_GT(distances.size(), 10u);
    for (const auto &[azimuth, found] : distances)
      EXPECT_NEAR(found.first / found.second, 0, 0.05 * width) << azimuth;
  }
}

INSTANTIATE_TEST_SUITE_P(Report, BrowserStates, testing::ValuesIn(states()),
                         [](const auto &info) { return info.param.name; });

TEST(Reports, AxeCoreIsInstalledLong)
{
  EXPECT_TRUE(fs::exists(STEMWARE_AXE))
    << "The tests of the pages did not check their accessibility. Install npm, then: ./quickstart test";
}

TEST(Reports, ArePrintedToPdfWithoutErrors)
{
  const ScratchFolder scratch;
  ASSERT_EQ(stemware(scratch, { "run", "--quick", "--output", "results" }).exit_code, 0);
  const fs::path pdf = scratch / "report.pdf";
  const Ended print = chromium(
    scratch, { "--print-to-pdf=" + pdf.string(), "file://" + (scratch / "results/report.html").string() });
  EXPECT_EQ(print.exit_code, 0) << print.err;
  EXPECT_THAT(print.err, testing::Not(testing::HasSubstr(":CONSOLE")));
  const std::string printed = read_text(pdf);
  EXPECT_EQ(printed.rfind("%PDF", 0), 0u);
  EXPECT_GT(printed.size(), 20000u); // an empty page is smaller
}

std::vector<std::pair<double, double>> points_of(const nlohmann::json &rows, const std::string &name)
{
  std::vector<std::pair<double, double>> points;
  for (const auto &row : rows)
    if (row[0] == name)
      points.emplace_back(std::stod(row.at(1).get<std::string>()), std::stod(row.at(2).get<std::string>()));
    else if (!points.empty())
      break;
  return points;
}

/// Expects that each of @p points equals (x, @p factor y) of a row of the columns @p x and @p y, to the six
/// digits that a figure has.
void expect_rows(const std::vector<std::pair<double, double>> &points, const std::vector<double> &x,
                 const std::vector<double> &y, double factor)
{
  EXPECT_GE(points.size(), 2u);
  const double scale =
    *std::max_element(y.begin(), y.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
  for (const auto &[at, value] : points)
  {
    const auto next = std::min_element(
      x.begin(), x.end(), [at = at](double a, double b) { return std::abs(a - at) < std::abs(b - at); });
    EXPECT_NEAR(*next, at, 1e-5 * std::abs(x.back()));
    EXPECT_NEAR(y[static_cast<std::size_t>(next - x.begin())] * factor, value,
                1e-5 * std::abs(factor * scale))
      << at;
  }
}

TEST(Reports, FiguresAndTablesShowTheNumbersOfTheResultsFiles)
{
  const ScratchFolder scratch;
  scratch.write("study.prm", plain_study());
  const nlohmann::json page = opened_state(scratch, { { "run", { "run", "study.prm" } }, "" });
  const nlohmann::json &figures = page["figures"];
  const auto torque = read_columns(scratch / "results/torque.csv"),
             spin_up = read_columns(scratch / "results/spin_up.csv"),
             load = read_columns(scratch / "results/load.csv");
  expect_rows(points_of(figures["torque"], "all harmonics"), torque[0], torque[2], 1e3); // in mN m
  expect_rows(points_of(figures["spin_up"], "all harmonics"), spin_up[0], spin_up[1], 1);
  std::vector<double> degrees = load[0];
  for (double &angle : degrees)
    angle *= 180 / ring::pi;
  const auto summary = read_summary(scratch / "results");
  expect_rows(points_of(figures["line_load"], "first harmonic"), degrees, load[2],
              1 / summary["load"]["ring_radius"].get<double>());
  const nlohmann::json &budget = summary["budget"];
  const nlohmann::json &bars = figures["waterfall"];
  const auto ends_at = [&](double omega)
  {
    return std::any_of(bars.begin() + 1, bars.end(),
                       [&](const nlohmann::json &row)
                       { return std::abs(std::stod(row[1].get<std::string>()) - omega) < 1e-8; });
  };
  for (std::size_t i = 1; i < budget.size(); ++i)
    if (budget[i]["name"] != "harmonics" && !budget[i]["difference"].is_null())
    {
      EXPECT_TRUE(ends_at(budget[i]["omega_terminal"])) << budget[i];
    }
  const nlohmann::json &rows = page["tables"]["The complete model without one effect at a time"];
  const nlohmann::json &without = summary["without"];
  ASSERT_EQ(rows.size(), without.size() + 1);
  for (std::size_t i = 0; i < without.size(); ++i)
  {
    EXPECT_EQ(rows[i + 1][0], without[i]["name"]);
    if (without[i]["omega_terminal"].is_number())
    {
      EXPECT_NEAR(std::stod(in_one_line(rows[i + 1][1])), without[i]["omega_terminal"].get<double>(),
                  5.01e-4);
    }
    else
    {
      EXPECT_EQ(rows[i + 1][1], "\u2013");
    }
  }
}

TEST(Reports, FormattedNumbersParseToTheirValues)
{
  // The page shows exponents as in 9.3 · 10⁻¹⁰.
  const std::string script = "const { shown } = await import(" +
                             script_string("file://" + fs::path(STEMWARE_DOCS).parent_path().string() +
                                           "/fem/pipeline/page/js/words.js") +
                             R"();
  const raised = "⁰¹²³⁴⁵⁶⁷⁸⁹";
  const read = text => {
    if (/e/.test(text)) return Number(text.replace("−", "-"));
    const [, sign, mantissa, , minus, digits] = text.match(/^\+?(−?)([\d.]*)( · )?(?:10(⁻?)([⁰¹²³⁴⁵⁶⁷⁸⁹]+))?$/);
    const power = digits ? Number([...digits].map(c => raised.indexOf(c)).join("")) : 0;
    return (sign ? -1 : 1) * Number((mantissa || "1") + "e" + (minus ? "-" : "") + power);
  };
  const wrong = [];
  for (let power = -300; power <= 300; ++power)
    for (const digits of [1, 1.5, 2.00001, 7.21346, 9.3202, 9.99999951])
      for (const [kind, error] of [[".6g", 6e-6], [".2g", 0.06], ["#.3g", 6e-3], ["+.4g", 6e-4], [".1e", 0.06]])
        for (const sign of [-1, 1]) {
          const value = sign * digits * 10 ** power, text = shown(value, kind);
          if (!(Math.abs(read(text) / value - 1) <= error)) wrong.push([value, kind, text]);
        }
  return wrong.slice(0, 5);)";
  const ScratchFolder scratch;
  EXPECT_EQ(found_in_browser(scratch, script), nlohmann::json::array());
}

/// Returns reports whose study or input files have names with the hostile text @p place.
std::vector<Opened> hostile_reports(const std::string &place)
{
  std::vector<Opened> reports = opened();
  for (Opened &report : reports)
    std::replace(report.arguments.begin(), report.arguments.end(), std::string("study.prm"), place + ".prm");
  const std::vector<std::string> profile = { "--set", "Glass/Shape=profile", "--set",
                                             "Glass/Land width=0.0017" };
  const std::vector<std::pair<std::string, std::vector<std::string>>> further = {
    { "profile", { "run", "--quick", "--set", "Glass/Profile file=" + place + ".csv" } },
    { "load", { "run", "--quick", "--set", "Load/Source=file", "--set", "Load/File=" + place + ".dat" } },
    { "speeds", { "run", "--quick", "--set", "Motion/Orbit speed file=" + place + " speeds.csv" } },
    { "mesh_file",
      { "run", "--quick", "--set", "Table/Substrate=rigid", "--set", "Contact/Body=solid", "--set",
        "Contact/Mesh file=" + place + ".msh" } },
    { "profiles",
      { "sweep", "--set", "Glass/Profile file=" + place + ".csv", "--vary",
        "Glass/Profile file=" + place + ".csv," + place + " broken.csv", "--vary", "Motion/Mass=0.2,0.3" } },
  };
  for (const auto &[name, arguments] : further)
  {
    reports.push_back({ name, arguments });
    if (name.rfind("profile", 0) == 0)
      reports.back().arguments.insert(reports.back().arguments.end(), profile.begin(), profile.end());
  }
  for (Opened &report : reports)
    report.arguments.insert(report.arguments.end(), { "--output", report.name });
  return reports;
}

TEST(Reports, HostileTextRunsNoScript)
{
  const ScratchFolder scratch;
  const std::string place = hostile_text();
  scratch.write(place + ".prm", plain_study());
  scratch.write(place + ".csv", read_text(fs::path(STEMWARE_DOCS) / "cookbooks/own_profile.csv"));
  scratch.write(place + " broken.csv", "r (m), z (m)\n0, 0\n");
  scratch.write(place + ".dat", "# ring radius: 0.03 (m)\n0 0.4684 0\n1 0.1 0\n2 0.01 0\n");
  scratch.write(place + " speeds.csv", "t (s), v (m/s)\n0, 0.3\n100, 0.35\n");
  scratch.write(place + ".msh", read_text(fs::path(STEMWARE_DOCS) / "../meshes/flat_foot.msh"));
  std::vector<std::string> pages;
  std::set<std::string> with_an_entry; // reports that show the hostile text; study names are not shown
  for (const Opened &report : hostile_reports(place))
  {
    SCOPED_TRACE(report.name);
    const Ended ended = stemware(scratch, report.arguments);
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
    const std::string page = report.name + "/report.html", bare = report.name + "/bare.html";
    scratch.write(bare, without_policy(read_text(scratch / page)));
    pages.insert(pages.end(), { page, bare });
    for (const std::string &argument : report.arguments)
      if (argument.find("=" + place) != std::string::npos)
        with_an_entry.insert({ page, bare });
  }
  EXPECT_GE(with_an_entry.size(), 10u);
  const nlohmann::json shown = opened_in_browser(scratch, pages);
  for (const std::string &page : pages)
  {
    EXPECT_FALSE(shown[page]["ran"].get<bool>()) << page;
    EXPECT_NE(shown[page]["answer"], "") << page;
    if (with_an_entry.count(page) == 1)
    {
      EXPECT_NE(shown[page]["words"].get<std::string>().find("dataset.ran=1"), std::string::npos) << page;
    }
  }
  for (const auto &file : fs::recursive_directory_iterator(scratch.path()))
    EXPECT_NE(file.path().filename(), "PWN") << file.path();
}

} // namespace
} // namespace stemware::test
