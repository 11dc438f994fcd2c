// Every kind of plot, drawn by gnuplot without a complaint, with its numbers in a file of the results.
#include "fem/pipeline/report/common_sections.h"
#include "fem/pipeline/report/plots/plots.h"
#include "fem/pipeline/report/render/table_renderers.h"
#include "fem/pipeline/support/text_file.h"
#include "tests/fem/pipeline/report/drawn_plots.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <sstream>

namespace stemware::pipeline
{
namespace
{

using test::draw;
using test::picture;
using test::ScratchFolder;
using test::words_of;

const double full_turn = 2 * std::acos(-1.);

/// A load that has left the table over a third of the rim.
const ring::RingStack lifted({ 1, 0, -0.4, 0, 0.05 }, { 0, -1.3, 0, 0.1, 0 }, 0.03);

/// The plots of a load at rest.
Document load_document(const ring::RingStack &load, const std::vector<fem::AzimuthLoad> &pointwise,
                       ring::OrbitSense sense, const std::vector<double> &band = {})
{
  Document document;
  add_load_plots(load, pointwise, band, sense, document);
  return document;
}

/// A table of the results from which plots are drawn.
void write_table(const std::string &name, const Table &table, const ScratchFolder &scratch)
{
  write_text_file(scratch / name, csv_table(table));
}

/// The columns of one of the blocks of data that two empty lines part.
std::vector<std::vector<double>> block_of(const Plot &plot, std::size_t index, const ScratchFolder &scratch)
{
  std::string text = plot.data;
  for (; index > 0; --index)
    text.erase(0, text.find("\n\n\n") + 3);
  write_text_file(scratch / "block.dat", text.substr(0, text.find("\n\n\n")) + "\n");
  return test::read_columns(scratch / "block.dat");
}

std::vector<std::vector<double>> data_of(const Plot &plot, const ScratchFolder &scratch)
{
  return test::read_columns(scratch / ("figures/" + plot.name + ".dat"));
}

TEST(Plots, Load)
{
  const ScratchFolder scratch;
  const std::vector<fem::AzimuthLoad> pointwise = { { 0, 1 }, { 1.5, 0 }, { 3, 1 }, { 4.5, 2 } };
  const Plot plot = picture(load_document(lifted, pointwise, ring::OrbitSense::counterclockwise), "load");
  EXPECT_EQ(draw(plot, scratch), "");
  const std::string words = words_of(plot, scratch);
  for (const char *name :
       { "first harmonic", "n ≤ 2", "n ≤ 3", "all harmonics", "under load", "mean, 33.3 N/m" })
    EXPECT_NE(words.find(name), std::string::npos) << name;
  EXPECT_NE(plot.script.find("side = 1."), std::string::npos); // the orbit's centre, to the left of v
  // The truncations over the mean, then the load as it was solved, closed.
  const auto columns = block_of(plot, 0, scratch);
  ASSERT_EQ(columns.size(), 5u);
  ASSERT_EQ(columns[0].size(), 361u);
  EXPECT_NEAR(columns[1][90], 1 - 1.3, 1e-12);             // first harmonic at 90 degrees
  EXPECT_NEAR(columns[3][90], 1 - 1.3 + 0.4 - 0.1, 1e-12); // three of them
  EXPECT_NEAR(columns[0].back(), full_turn, 1e-12);
  const auto solved = block_of(plot, 1, scratch);
  EXPECT_EQ(solved[1], (std::vector<double>{ 1, 0, 1, 2, 1 }));
  EXPECT_NEAR(solved[0].back(), full_turn, 1e-12);

  // Without lift-off the series is drawn.
  const Plot all = picture(load_document(lifted, {}, ring::OrbitSense::clockwise), "load");
  EXPECT_EQ(draw(all, scratch), "");
  EXPECT_NE(words_of(all, scratch).find("all, n ≤ 4"), std::string::npos);
  EXPECT_NE(all.script.find("side = -1."), std::string::npos);
  EXPECT_NEAR(block_of(all, 1, scratch)[1][90], 1 - 1.3 + 0.4 - 0.1 + 0.05, 1e-12);
}

TEST(Plots, LoadOfOneHarmonicWithoutSamples)
{
  const ScratchFolder scratch;
  const Document document = load_document(lifted.truncated(1), {}, ring::OrbitSense::clockwise);
  const Plot plot = picture(document, "load");
  EXPECT_EQ(draw(plot, scratch), "");
  const auto columns = block_of(plot, 1, scratch);
  EXPECT_LT(columns[1][90], 0); // formally: not under load
  EXPECT_GT(columns[1][270], 0);
  EXPECT_NE(words_of(plot, scratch).find("first harmonic"), std::string::npos);
  EXPECT_EQ(draw({ plot, picture(document, "line_load") }, scratch), "");
}

TEST(Plots, LineLoad)
{
  const ScratchFolder scratch;
  const Document document = load_document(lifted, {}, ring::OrbitSense::counterclockwise);
  const Plot load = picture(document, "load"), plot = picture(document, "line_load");
  EXPECT_EQ(draw({ load, plot }, scratch), "");
  EXPECT_EQ(plot.data_file, "figures/load.dat");
  // N/m: N/rad over the ring's radius.
  EXPECT_NE(plot.script.find("mean = " + std::to_string(1 / lifted.radius()).substr(0, 7)),
            std::string::npos);
  const std::string words = words_of(plot, scratch);
  for (const char *name : { "all harmonics", "first harmonic", "mean" })
    EXPECT_NE(words.find(name), std::string::npos) << name;
  // The orbit's centre lies to the left of v: at 90 degrees, which is to the left of 270 degrees in the
  // picture.
  EXPECT_LT(words.find("orbit's centre"), words.find("outside"));
  const Plot clockwise = picture(load_document(lifted, {}, ring::OrbitSense::clockwise), "line_load");
  EXPECT_EQ(draw({ load, clockwise }, scratch), "");
  const std::string other_words = words_of(clockwise, scratch);
  EXPECT_GT(other_words.find("orbit's centre"), other_words.find("outside"));
}

TEST(Plots, TruncationsAreDrawnWhereTheyCanBeSeen)
{
  // The third harmonic is 0.5 % of the mean, and a quarter of what is beyond the first.
  const ring::RingStack load({ 1, 0, 0.02, 0.005 }, { 0, 0.5, 0, 0 }, 0.03);
  const ScratchFolder scratch;
  const Document document = load_document(load, {}, ring::OrbitSense::clockwise);
  const Plot round = picture(document, "load"), higher = picture(document, "higher_harmonics");
  EXPECT_EQ(draw({ round, higher }, scratch), "");
  EXPECT_EQ(words_of(round, scratch).find("n ≤ 2"), std::string::npos);
  EXPECT_NE(words_of(higher, scratch).find("n ≤ 2"), std::string::npos);
}

TEST(Plots, HigherHarmonics)
{
  const ScratchFolder scratch;
  const Document document = load_document(lifted, {}, ring::OrbitSense::clockwise);
  const Plot load = picture(document, "load"), plot = picture(document, "higher_harmonics");
  EXPECT_EQ(draw({ load, plot }, scratch), "");
  const std::string words = words_of(plot, scratch);
  for (const char *name : { "n ≤ 2", "n ≤ 3", "all, n ≤ 4" })
    EXPECT_NE(words.find(name), std::string::npos) << name;
  EXPECT_NE(plot.script.find("a_1 = 0.; b_1 = -1.3\n"), std::string::npos); // what the first one takes away
  // As it was solved.
  const Document as_solved = load_document(lifted, { { 0, 1.25 }, { 1.5, 0 } }, ring::OrbitSense::clockwise);
  const Plot solved = picture(as_solved, "load"), higher = picture(as_solved, "higher_harmonics");
  EXPECT_EQ(draw({ solved, higher }, scratch), "");
  EXPECT_EQ(words_of(higher, scratch).find("all, n"), std::string::npos);
}

TEST(Plots, Spectrum)
{
  const ScratchFolder scratch;
  const auto spectrum = [](const ring::RingStack &load, const std::vector<double> &band)
  { return picture(load_document(load, {}, ring::OrbitSense::clockwise, band), "spectrum"); };
  const Plot plot = spectrum(lifted, { 0, 0.01, 0.01, 0.01, 0.01 });
  EXPECT_EQ(draw(plot, scratch), "");
  const auto columns = data_of(plot, scratch);
  ASSERT_EQ(columns.size(), 4u);
  EXPECT_NEAR(columns[1][1], 0.4, 1e-15);
  EXPECT_EQ(columns[3], (std::vector<double>{ 1, 1, 1, 1 }));
  EXPECT_EQ(words_of(plot, scratch).find("resolved"), std::string::npos);
  // n = 3, of amplitude 0.1, is smaller than its band; n = 4 has none, and is smaller than that of n = 3:
  // both are hollow.
  const Plot hollow = spectrum(lifted, { 0, 0.01, 0.01, 0.2, 0 });
  EXPECT_EQ(draw(hollow, scratch), "");
  EXPECT_EQ(data_of(hollow, scratch)[0], (std::vector<double>{ 1, 2, 3, 4 }));
  EXPECT_EQ(data_of(hollow, scratch)[3], (std::vector<double>{ 1, 1, 0, 0 }));
  EXPECT_NE(words_of(hollow, scratch).find("not resolved"), std::string::npos);
  EXPECT_NE(hollow.caption.find("Hollow"), std::string::npos);
  EXPECT_EQ(draw(spectrum(ring::RingStack({ 1, 0 }, { 0, 0 }, 1), {}), scratch), "");
}

/// The picture of the pressure of a foot of 30 mm.
Plot footprint_plot(const fem::PressureMap &footprint)
{
  Study study;
  study.glass.profile.contact_radius = 0.03;
  FootReport foot;
  foot.footprint = footprint;
  Document document;
  add_foot_plots(study, foot, document);
  return picture(document, "footprint");
}

TEST(Plots, Footprint)
{
  const ScratchFolder scratch;
  // Two cuts of three points, the first of each free of pressure.
  fem::PressureMap footprint;
  footprint.is_grid = true;
  for (const double azimuth : { 0., full_turn / 4 })
    footprint.cuts.push_back({ { 0.0299, azimuth, 0 }, { 0.03, azimuth, 2e3 }, { 0.0301, azimuth, 3e3 } });
  const Plot plot = footprint_plot(footprint);
  EXPECT_EQ(draw(plot, scratch), "");
  EXPECT_NE(words_of(plot, scratch).find("pressure (kPa)"), std::string::npos);
  // The first cut comes again after a whole turn; each has 24 places up to the edges of its pressure, here
  // the last points.
  const auto columns = data_of(plot, scratch);
  ASSERT_EQ(columns[0].size(), 72u);
  EXPECT_NEAR(columns[0][24], 90, 1e-4);
  EXPECT_NEAR(columns[0][71], 360, 1e-4);
  EXPECT_NEAR(columns[1][24], -100, 1e-3);
  EXPECT_NEAR(columns[1][47], 100, 1e-3);
  EXPECT_NEAR(columns[2][24], 0, 1e-12);
  EXPECT_NEAR(columns[2][47], 3, 1e-5);
  EXPECT_NEAR(columns[2][24 + 6], 2 * (200. * 6 / 23) / 100, 1e-4); // between the first two points
  // The mean of a polygon through 0, 2 and 3 kPa is 1.75 kPa; six places cut its corner.
  EXPECT_NE(plot.caption.find("Largest pressure 3 kPa at θ = 0°, mean 1.74 kPa; the contact is 200 µm wide."),
            std::string::npos)
    << plot.caption;

  footprint.is_grid = false;
  footprint.cuts[0][1].pressure = 4e6;
  const Plot points = footprint_plot(footprint);
  EXPECT_EQ(draw(points, scratch), "");
  EXPECT_NE(words_of(points, scratch).find("pressure (MPa)"), std::string::npos);
  EXPECT_EQ(data_of(points, scratch)[0].size(), 4u);
}

TEST(Plots, FootprintWithoutAnEdgeOrALoad)
{
  fem::PressureMap footprint;
  footprint.is_grid = true;
  footprint.has_edge = false;
  for (const double azimuth : { 0., full_turn / 4 })
    footprint.cuts.push_back({ { 0.0299, azimuth, 1e3 }, { 0.03, azimuth, 2e3 }, { 0.0301, azimuth, 1e3 } });
  EXPECT_NE(footprint_plot(footprint).caption.find(" µm wide, where 99 % of the load lie."),
            std::string::npos);
  // The first cut without a load: its places have no pressure.
  footprint.has_edge = true;
  for (fem::PressurePoint &point : footprint.cuts[0])
    point.pressure = 0;
  const Plot plot = footprint_plot(footprint);
  EXPECT_NE(plot.caption.find("the contact is 0 µm to 200 µm wide."), std::string::npos) << plot.caption;
  for (const std::string &text : { plot.caption, plot.script })
    EXPECT_EQ(text.find("nan"), std::string::npos) << text;
  EXPECT_EQ(plot.data.find("inf"), std::string::npos);
  EXPECT_EQ(plot.data.find("-nan"), std::string::npos);
  EXPECT_NE(plot.data.find(" nan\n"), std::string::npos);
  // No load at all: no mean.
  for (fem::PressurePoint &point : footprint.cuts[1])
    point.pressure = 0;
  EXPECT_NE(footprint_plot(footprint).caption.find("mean – kPa"), std::string::npos);
}

/// Rows with terminal spins, the last of which has all harmonics.
std::vector<SpinRow> two_rows()
{
  std::vector<SpinRow> rows(2);
  rows[0].harmonics = 1;
  rows[0].terminal = ring::TerminalSpin{ -3, -1, 1, true };
  rows[0].relative_change = 0.02;
  rows[1].harmonics = 4;
  rows[1].terminal = ring::TerminalSpin{ -3.5, -1, 1, true };
  rows[1].relative_change = 0;
  return rows;
}

/// Relative changes by the number of harmonics.
Table truncations_of(const std::vector<double> &changes)
{
  std::vector<double> harmonics(changes.size());
  std::iota(harmonics.begin(), harmonics.end(), 1.);
  return { "",
           { { { "harmonics" }, { harmonics.begin(), harmonics.end() } },
             { { "relative_change" }, { changes.begin(), changes.end() } } } };
}

/// The picture of the columns of truncations_of().
Plot truncation_plot()
{
  Document document;
  document.plots["truncation"] = { { "rounding", 1e-12 } };
  document.facts["columns"]["truncation"] = { { "relative_change", 2 }, { "bound", 3 } };
  return picture(document, "truncation");
}

TEST(Plots, TorqueAndTruncation)
{
  const ScratchFolder scratch;
  TorqueCurve curve;
  curve.omega = { -5, 5 };
  curve.slip_ratio = { -1, 1 };
  curve.friction = { { 1e-3, 0, 0 }, { -2e-3, 0, 0 } };
  curve.harmonics = { 1 };
  curve.truncations = { { 3e-3, -4e-3 } };
  curve.lean_torque = curve.grip_torque = curve.sum = { 0, 0 };
  Document document;
  add_torque_plot(curve, two_rows(), document);
  const Plot torque = picture(document, "torque");
  write_table("torque.csv", torque_table(curve), scratch);
  EXPECT_EQ(draw(torque, scratch), "");
  EXPECT_EQ(torque.data_file, "torque.csv");
  const std::string words = words_of(torque, scratch);
  for (const char *word : { "all, n ≤ 4", "first harmonic", "−v/R", "+v/R" })
    EXPECT_NE(words.find(word), std::string::npos) << word;
  EXPECT_NE(torque.script.find("terminal[2] = [-3., -3.5]"), std::string::npos) << torque.script;
  EXPECT_NE(torque.caption.find("±v/R = ±5 rad/s"), std::string::npos) << torque.caption;
  const Table truncations = truncations_of({ 0.02, 0 });
  write_table("truncation.csv", truncations, scratch);
  const Plot truncation = truncation_plot();
  EXPECT_EQ(draw(truncation, scratch), "");
  EXPECT_NE(words_of(truncation, scratch).find("terminal spin, relative change"), std::string::npos);
}

TEST(Plots, TruncationThatChangesNothing)
{
  const ScratchFolder scratch;
  write_table("truncation.csv", truncations_of({ 0 }), scratch);
  const Plot plot = truncation_plot();
  EXPECT_EQ(draw(plot, scratch), "");
  EXPECT_NE(words_of(plot, scratch).find("nothing to show"), std::string::npos);
}

/// How many points the plot's SVG shows.
std::size_t n_points(const Plot &plot, const ScratchFolder &scratch)
{
  const std::string svg = test::read_text(scratch / ("figures/" + plot.name + ".svg"));
  std::size_t n = 0;
  for (auto place = svg.find("<use "); place != std::string::npos; place = svg.find("<use ", place + 1))
    ++n;
  return n;
}

TEST(Plots, APlotAfterOneOfACsvFileHasAllItsRows)
{
  const ScratchFolder scratch;
  write_table("truncation.csv", truncations_of({ 0.02, 0 }), scratch);
  const Plot spectrum = picture(load_document(lifted, {}, ring::OrbitSense::clockwise), "spectrum");
  EXPECT_EQ(draw(spectrum, scratch), "");
  const std::size_t n_alone = n_points(spectrum, scratch);
  EXPECT_EQ(draw({ truncation_plot(), spectrum }, scratch), "");
  EXPECT_EQ(n_points(spectrum, scratch), n_alone);
}

TEST(Plots, ATemplateThatAsksForWhatThereIsNotCostsItsOwnPictureAlone)
{
  const ScratchFolder scratch;
  Document document = load_document(lifted, {}, ring::OrbitSense::clockwise);
  const Plot spectrum = picture(document, "spectrum");
  document.facts.erase("rim_load");
  const std::string complaint = draw({ picture(document, "line_load"), spectrum }, scratch);
  EXPECT_NE(complaint.find("asks for rim_load.side, which there is not"), std::string::npos) << complaint;
  EXPECT_GT(n_points(spectrum, scratch), 0u);
  EXPECT_FALSE(std::filesystem::exists(scratch / "figures/line_load.svg"));
}

TEST(Plots, SpinUp)
{
  const ScratchFolder scratch;
  Document document;
  add_spin_up_plot({ 0, 1, 2 },
                   { { "elastic foot", { 0, -1, -1.5 }, 1 }, { "the paper", { 0, -0.9, -1.4 }, 2 } },
                   two_rows().back(), {}, "From rest.", document);
  const Plot plot = picture(document, "spin_up");
  EXPECT_EQ(draw(plot, scratch), "");
  const std::string words = words_of(plot, scratch);
  EXPECT_NE(words.find("the paper"), std::string::npos);
  EXPECT_NE(words.find("turns per second"), std::string::npos);
  EXPECT_NE(words.find("−3.5 rad/s"), std::string::npos) << words; // the terminal spin
  EXPECT_EQ(plot.caption.find("From rest."), 0u) << plot.caption;
  document.facts["one_way"] = true;
  EXPECT_EQ(picture(document, "spin_up").caption.find(".."), std::string::npos);
}

TEST(Plots, Phases)
{
  const ScratchFolder scratch;
  PhaseStudy phases;
  phases.n_table_phases = 2;
  phases.phases = { { 0, 0 }, { 0, full_turn / 4 } };
  phases.torque_at_rest = { -1e-3, -2e-3 };
  phases.torque_at_terminal = { 1e-3, -1e-3 };
  Document document;
  document.plots["phases"] = { { "marked", "table" } };
  const Plot plot = picture(document, "phases");
  write_table("phases.csv", phase_table(phases), scratch);
  EXPECT_EQ(draw(plot, scratch), "");
  EXPECT_NE(words_of(plot, scratch).find("at the mean spin"), std::string::npos);
  EXPECT_NE(plot.caption.find("mark of the table"), std::string::npos);
}

/// Pictures of a grid with the terminal spin @p spin of each case, NaN for a case that has failed.
std::vector<Plot> plots_of_grid(const std::vector<std::string> &varied,
                                const std::function<double(double, double)> &spin)
{
  const CaseList list = cases_of_grid(varied);
  FinishedCases cases;
  for (std::size_t i = 0; i < list.cases.size(); ++i)
  {
    const double value = spin(std::stod(list.cases[i][0]), std::stod(list.cases[i].back()));
    cases[i] = { "", std::isnan(value) ? "It tips." : "" };
    if (!std::isnan(value))
      cases[i].values = { { "omega_terminal", value }, { "moment_ratio", 0.5 } };
  }
  Document document;
  add_sweep_plots(list, cases, document);
  std::vector<Plot> plots;
  for (const auto &drawn : document.facts["pictures"])
    plots.push_back(picture(document, drawn["name"], drawn["source"]));
  return plots;
}

TEST(Plots, Map)
{
  const ScratchFolder scratch;
  const std::vector<std::string> varied = { "Load/Moment ratio=0.2:0.9:8",
                                            "Motion/Orbit speed=0.1:0.8:8:log" };
  const auto is_failed = [](double x, double y) { return x == 0.4 && y > 0.7; };
  std::vector<Plot> plots =
    plots_of_grid(varied, [&](double x, double y) { return is_failed(x, y) ? std::nan("") : 10 * x + y; });
  ASSERT_EQ(plots.size(), 1u);
  plots[0].script += "set print \"figures/bounds.dat\"\nprint x_bound(0), x_bound(1), y_bound(1)\n";
  EXPECT_EQ(draw(plots, scratch), "");
  const auto columns = data_of(plots[0], scratch),
             bounds = test::read_columns(scratch / "figures/bounds.dat");
  ASSERT_EQ(columns.size(), 3u);
  EXPECT_EQ(columns[2].size(), 64u);
  EXPECT_NEAR(bounds[0][0], 0.15, 1e-9); // cells meet half-way
  EXPECT_NEAR(bounds[1][0], 0.25, 1e-9);
  EXPECT_NEAR(bounds[2][0], std::sqrt(columns[1][0] * columns[1][8]), 1e-9);
  EXPECT_EQ(std::count_if(columns[2].begin(), columns[2].end(), [](double x) { return std::isnan(x); }), 1);
  // Differences of the size of rounding are colours too; zero lies in the middle of a scale with both signs.
  EXPECT_EQ(draw(plots_of_grid(varied, [](double x, double) { return 1 + 1e-8 * x; }), scratch), "");
  plots = plots_of_grid(varied, [](double x, double) { return x - 0.25; });
  plots[0].script += "set print \"figures/scale.dat\"\nprint GPVAL_CB_MIN, GPVAL_CB_MAX\n";
  EXPECT_EQ(draw(plots, scratch), "");
  const auto scale = test::read_columns(scratch / "figures/scale.dat");
  EXPECT_NEAR(scale[0][0], -0.65, 1e-9);
  EXPECT_NEAR(scale[1][0], 0.65, 1e-9);
}

TEST(Plots, CurvesWithLogarithmicAxis)
{
  const ScratchFolder scratch;
  const std::vector<Plot> plots = plots_of_grid({ "Motion/Orbit speed=0.1:0.8:8:log" },
                                                [](double x, double) { return x > 0.5 ? std::nan("") : -x; });
  ASSERT_EQ(plots.size(), 1u);
  EXPECT_EQ(draw(plots, scratch), "");
  EXPECT_NE(plots[0].script.find("is_logarithmic = 1\n"), std::string::npos);
  EXPECT_NE(words_of(plots[0], scratch).find("all harmonics"), std::string::npos);
}

TEST(Plots, NoLineIsDrawnOverAJump)
{
  const std::vector<Plot> plots =
    plots_of_grid({ "Motion/Orbit speed=0.1:0.8:8" }, [](double x, double) { return x > 0.45 ? x : x - 5; });
  const std::string &data = plots.at(0).data;
  const std::string first = data.substr(0, data.find("\n\n\n"));
  std::istringstream lines(first);
  std::vector<std::string> rows;
  for (std::string line; std::getline(lines, line);)
    if (line[0] != '#')
      rows.push_back(line);
  ASSERT_EQ(rows.size(), 9u);
  EXPECT_NE(rows[4].find("0.45"), std::string::npos); // between 0.4 and 0.5
  EXPECT_NE(rows[4].find("nan"), std::string::npos);
}

} // namespace
} // namespace stemware::pipeline
