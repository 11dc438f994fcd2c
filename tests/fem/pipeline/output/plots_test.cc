// Every kind of plot, drawn by gnuplot without a complaint, with its numbers in the file beside it.
#include "fem/pipeline/output/plots/foot_plots.h"
#include "fem/pipeline/output/plots/plots.h"
#include "fem/pipeline/output/render/report.h"
#include "tests/fem/pipeline/program_runner.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace stemware::pipeline
{
namespace
{

using test::read_text;
using test::ScratchFolder;

const double full_turn = 2 * std::acos(-1.);

/// A load that has left the table over a third of the rim.
const ring::RingStack lifted({ 1, 0, -0.4, 0, 0.05 }, { 0, -1.3, 0, 0.1, 0 }, 0.03);

/// Draws the plot alone and says what went wrong.
std::string draw(const Plot &plot, const ScratchFolder &scratch)
{
  testing::internal::CaptureStderr();
  write_report({ "A plot", "", { { "The plot", "", { plot } } } }, scratch.path());
  return testing::internal::GetCapturedStderr();
}

/// What the text of the plot's SVG says, markup left out.
std::string words_of(const Plot &plot, const ScratchFolder &scratch)
{
  const std::string svg = read_text(scratch / ("figures/" + plot.name + ".svg"));
  std::string words;
  bool inside = true;
  for (const char character : svg)
    if (character == '<' || character == '>')
      inside = character == '>';
    else if (inside)
      words += character;
  return words;
}

std::vector<std::vector<double>> data_of(const Plot &plot, const ScratchFolder &scratch)
{
  return test::read_columns(scratch / ("figures/" + plot.name + ".dat"));
}

TEST(Plots, Load)
{
  const ScratchFolder scratch;
  const std::vector<fem::AzimuthLoad> pointwise = { { 0, 1 }, { 1.5, 0 }, { 3, 1 }, { 4.5, 2 } };
  const Plot plot = load_plot(lifted, pointwise, ring::OrbitSense::counterclockwise);
  EXPECT_EQ(draw(plot, scratch), "");
  const std::string words = words_of(plot, scratch);
  for (const char *name : { "first harmonic", "n ≤ 2", "n ≤ 3", "all harmonics" })
    EXPECT_NE(words.find(name), std::string::npos) << name;
  EXPECT_NE(plot.script.find("side = 1;"), std::string::npos); // the orbit's centre, to the left of v
  // One block for each of three series, the load as it was solved, then the arc: both closed, the latter
  // interrupted where nothing is carried.
  const auto columns = data_of(plot, scratch);
  ASSERT_EQ(columns[0].size(), 3u * 361 + 5 + 5);
  EXPECT_NEAR(columns[1][90], 1 - 1.3, 1e-12);                       // first harmonic at 90 degrees
  EXPECT_NEAR(columns[1][2 * 361 + 90], 1 - 1.3 + 0.4 - 0.1, 1e-12); // three of them
  const std::vector<double> solved(columns[1].begin() + 3 * 361, columns[1].begin() + 3 * 361 + 5);
  EXPECT_EQ(solved, (std::vector<double>{ 1, 0, 1, 2, 1 }));
  EXPECT_EQ(columns[1][3 * 361 + 5], 1);
  EXPECT_TRUE(std::isnan(columns[1][3 * 361 + 6]));
  EXPECT_NEAR(columns[0].back(), full_turn, 1e-12);

  // Without lift-off the series is drawn.
  EXPECT_EQ(draw(load_plot(lifted, {}, ring::OrbitSense::clockwise), scratch), "");
  EXPECT_NE(words_of(plot, scratch).find("all, n ≤ 4"), std::string::npos);
  EXPECT_NEAR(data_of(plot, scratch)[1][3 * 361 + 90], 1 - 1.3 + 0.4 - 0.1 + 0.05, 1e-12);
}

TEST(Plots, LoadOfOneHarmonicWithoutSamples)
{
  const ScratchFolder scratch;
  const Plot plot = load_plot(lifted.truncated(1), {}, ring::OrbitSense::clockwise);
  EXPECT_EQ(draw(plot, scratch), "");
  const auto columns = data_of(plot, scratch);
  EXPECT_TRUE(std::isnan(columns[1][361 + 90])); // formally negative there
  EXPECT_EQ(columns[1][361 + 270], 1);
}

TEST(Plots, LineLoad)
{
  const ScratchFolder scratch;
  const Plot plot = line_load_plot(lifted, {}, ring::OrbitSense::counterclockwise);
  EXPECT_EQ(draw(plot, scratch), "");
  // N/m: N/rad over the ring's radius. All harmonics, the first, the mean.
  const auto columns = data_of(plot, scratch);
  ASSERT_EQ(columns[0].size(), 2u * 361 + 2);
  const double radius = lifted.radius();
  EXPECT_NEAR(columns[1][90], (1 - 1.3 + 0.4 - 0.1 + 0.05) / radius, 1e-9);
  EXPECT_NEAR(columns[1][361 + 90], (1 - 1.3) / radius, 1e-9);
  EXPECT_NEAR(columns[1].back(), 1 / radius, 1e-9);
  EXPECT_NE(plot.script.find("90\\norbit's centre"), std::string::npos); // to the left of v
  EXPECT_NE(line_load_plot(lifted, {}, ring::OrbitSense::clockwise).script.find("270\\norbit's centre"),
            std::string::npos);
  EXPECT_NE(words_of(plot, scratch).find("orbit's centre"), std::string::npos);
}

TEST(Plots, TruncationsAreDrawnWhereTheyCanBeSeen)
{
  // The third harmonic is 0.5 % of the mean, and a quarter of what is beyond the first.
  const ring::RingStack load({ 1, 0, 0.02, 0.005 }, { 0, 0.5, 0, 0 }, 0.03);
  EXPECT_EQ(load_plot(load, {}, ring::OrbitSense::clockwise).script.find("n ≤ 2"), std::string::npos);
  EXPECT_NE(higher_harmonics_plot(load).script.find("n ≤ 2"), std::string::npos);
}

TEST(Plots, HigherHarmonics)
{
  const ScratchFolder scratch;
  const Plot plot = higher_harmonics_plot(lifted);
  EXPECT_EQ(draw(plot, scratch), "");
  EXPECT_NEAR(data_of(plot, scratch)[1][2 * 361 + 90], 0.4 - 0.1 + 0.05, 1e-12);
  // As it was solved, at 0 and 1.5 and after a whole turn.
  EXPECT_EQ(draw(higher_harmonics_plot(lifted, { { 0, 1.25 }, { 1.5, 0 } }), scratch), "");
  const auto columns = data_of(plot, scratch);
  ASSERT_EQ(columns[1].size(), 2u * 361 + 3);
  EXPECT_NEAR(columns[1][2 * 361], 0.25, 1e-12);
  EXPECT_NEAR(columns[0][2 * 361 + 1], 1.5 * 360 / full_turn, 1e-12);
}

TEST(Plots, Spectrum)
{
  const ScratchFolder scratch;
  const Plot plot = spectrum_plot(lifted, { 0, 0.01, 0.01, 0.01, 0.01 });
  EXPECT_EQ(draw(plot, scratch), "");
  const auto columns = data_of(plot, scratch);
  ASSERT_EQ(columns.size(), 3u);
  EXPECT_NEAR(columns[1][1], 0.4, 1e-15);
  // n = 3, of amplitude 0.1, is smaller than its band; n = 4 has none, and is smaller than that of n = 3:
  // both are hollow, and stand in a block of their own.
  const Plot hollow = spectrum_plot(lifted, { 0, 0.01, 0.01, 0.2, 0 });
  EXPECT_EQ(draw(hollow, scratch), "");
  EXPECT_EQ(data_of(plot, scratch)[0], (std::vector<double>{ 1, 2, 3, 4 }));
  EXPECT_NE(hollow.script.find("pt 6 title \"not resolved\""), std::string::npos) << hollow.script;
  EXPECT_EQ(plot.script.find("pt 6"), std::string::npos);
  EXPECT_EQ(draw(spectrum_plot(ring::RingStack({ 1, 0 }, { 0, 0 }, 1)), scratch), "");
}

TEST(Plots, Footprint)
{
  const ScratchFolder scratch;
  // Two cuts of three points, the first of each free of pressure.
  fem::PressureMap footprint;
  footprint.is_grid = true;
  for (const double azimuth : { 0., full_turn / 4 })
    footprint.cuts.push_back({ { 0.0299, azimuth, 0 }, { 0.03, azimuth, 2e3 }, { 0.0301, azimuth, 3e3 } });
  const Plot plot = footprint_plot(footprint, 0.03);
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
  const Plot points = footprint_plot(footprint, 0.03);
  EXPECT_EQ(draw(points, scratch), "");
  EXPECT_NE(words_of(points, scratch).find("pressure (MPa)"), std::string::npos);
  EXPECT_EQ(data_of(points, scratch)[0].size(), 4u);
}

/// A strip of parabolic pressure whose half-width goes from 0.2 to 0.1 mm: the edges between the points of
/// the grid are found, and the mean is two thirds of the largest pressure of each cut.
TEST(Plots, FootprintOfAParabolicPressureEndsBetweenThePoints)
{
  fem::PressureMap footprint;
  footprint.is_grid = true;
  const auto half_width = [](double azimuth) { return 1.5e-4 + 0.5e-4 * std::cos(azimuth); };
  for (unsigned int c = 0; c < 72; ++c)
  {
    const double azimuth = full_turn * c / 72, b = half_width(azimuth);
    footprint.cuts.emplace_back();
    for (int i = -16; i <= 16; ++i)
    {
      const double x = 2.5e-4 * i / 16;
      footprint.cuts.back().push_back({ 0.03 + x, azimuth, 9e4 * std::max(0., 1 - x * x / (b * b)) });
    }
  }
  const Plot plot = footprint_plot(footprint, 0.03);
  const ScratchFolder scratch;
  EXPECT_EQ(draw(plot, scratch), "");
  const auto columns = data_of(plot, scratch);
  ASSERT_EQ(columns[0].size(), 73u * 24);
  for (unsigned int c = 0; c < 72; ++c)
    for (const std::size_t edge : { 24 * c, 24 * c + 23 })
      EXPECT_NEAR(std::abs(columns[1][edge]), 1e6 * half_width(full_turn * c / 72), 5) << c;
  const auto mean = plot.caption.find("Largest pressure 90 kPa at θ = 0°, mean ");
  ASSERT_NE(mean, std::string::npos) << plot.caption;
  EXPECT_NEAR(std::stod(plot.caption.substr(plot.caption.find("mean ") + 5)), 60, 1) << plot.caption;
}

/// On a rough table the pressure of a crowned rim is a bell, which ends nowhere: the contact is as wide as
/// what carries 99 % of the load, 2 x 2.5758 standard deviations, whatever the map shows beyond; the mean is
/// 0.99 sqrt(2 pi) / 5.1517 of the largest pressure.
TEST(Plots, FootprintWithoutAnEdgeIsAsWideAsNinetyNinePercentOfTheLoad)
{
  const double deviation = 40e-6;
  for (const double reach : { 3.6, 6. })
  {
    fem::PressureMap footprint;
    footprint.is_grid = true;
    footprint.has_edge = false;
    for (unsigned int c = 0; c < 72; ++c)
    {
      footprint.cuts.emplace_back();
      for (int i = -16; i <= 16; ++i)
      {
        const double x = reach * i / 16;
        footprint.cuts.back().push_back(
          { 0.03 + deviation * x, full_turn * c / 72, 9e4 * std::exp(-x * x / 2) });
      }
    }
    const auto width = fem::contact_width(footprint.cuts.front(), false);
    ASSERT_TRUE(width);
    EXPECT_NEAR((width->outer - width->inner) / deviation, 5.1517, 0.1) << reach;
    const auto [inner, outer] = loaded_band(footprint);
    EXPECT_NEAR(inner, width->inner, 1e-15);
    EXPECT_NEAR(outer, width->outer, 1e-15);
    const Plot plot = footprint_plot(footprint, 0.03);
    const ScratchFolder scratch;
    EXPECT_EQ(draw(plot, scratch), "");
    EXPECT_NEAR(data_of(plot, scratch)[1][23] * 1e-6 / deviation, 5.1517 / 2, 0.05);
    EXPECT_NEAR(std::stod(plot.caption.substr(plot.caption.find("mean ") + 5)), 90 * 0.99 * 2.5066 / 5.1517,
                1);
    EXPECT_NE(plot.caption.find(" µm wide, where 99 % of the load lie."), std::string::npos) << plot.caption;
  }
}

/// A land that is loaded up to its end at some azimuths and not at all at others, with a point alone at its
/// end: nothing is divided by nothing. The pressure is 60 kPa on the outer half of the land, on half of the
/// rim.
TEST(Plots, FootprintAtTheEndOfTheLandHasAMean)
{
  fem::PressureMap footprint;
  footprint.is_grid = true;
  for (unsigned int c = 0; c < 36; ++c)
  {
    footprint.cuts.emplace_back();
    for (unsigned int i = 0; i < 33; ++i)
      // Radii whose sum with a share of their difference rounds to beyond them.
      footprint.cuts.back().push_back({ 0.0292807 + 0.0008256591 * i / 32, full_turn * c / 36,
                                        c < 18 ? (i >= 16 ? 6e4 : 0.) : (c == 30 && i == 32 ? 6e4 : 0.) });
  }
  const Plot plot = footprint_plot(footprint, 0.03);
  // Half of the first interval is taken for the fall to zero.
  EXPECT_NEAR(std::stod(plot.caption.substr(plot.caption.find("mean ") + 5)), 60 * 16.25 / 16.5, 0.3);
  EXPECT_NE(plot.caption.find("the contact is 0 µm to 426 µm wide."), std::string::npos) << plot.caption;
  for (const std::string &text : { plot.caption, plot.script })
    EXPECT_EQ(text.find("nan"), std::string::npos) << text;
  EXPECT_EQ(plot.data.find("inf"), std::string::npos);
  EXPECT_EQ(plot.data.find("-nan"), std::string::npos);
  EXPECT_NE(plot.data.find(" nan\n"), std::string::npos); // where there is no load
  // No load at all: no mean.
  for (auto &cut : footprint.cuts)
    for (fem::PressurePoint &point : cut)
      point.pressure = 0;
  EXPECT_NE(footprint_plot(footprint, 0.03).caption.find("mean – kPa"), std::string::npos);
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

TEST(Plots, TorqueAndTruncation)
{
  const ScratchFolder scratch;
  TorqueCurve curve;
  curve.omega = { -5, 5 };
  curve.slip_ratio = { -1, 1 };
  curve.friction = { { 1e-3, 0, 0 }, { -2e-3, 0, 0 } };
  curve.harmonics = { 1 };
  curve.truncations = { { 3e-3, -4e-3 } };
  const Plot torque = torque_plot(curve, two_rows());
  EXPECT_EQ(draw(torque, scratch), "");
  const auto columns = data_of(torque, scratch);
  EXPECT_EQ(columns[0], (std::vector<double>{ -5, 5, -5, 5, -3, -3.5 }));
  EXPECT_EQ(columns[1], (std::vector<double>{ 1, -2, 3, -4, 0, 0 })); // mN m
  EXPECT_NE(words_of(torque, scratch).find("+v/R"), std::string::npos);
  EXPECT_NE(torque.caption.find("±v/R = ±5 rad/s"), std::string::npos) << torque.caption;
  EXPECT_EQ(draw(truncation_plot(two_rows()), scratch), "");
  EXPECT_EQ(data_of(truncation_plot(two_rows()), scratch)[1], std::vector<double>{ 0.02 });
}

TEST(Plots, TruncationThatChangesNothing)
{
  const ScratchFolder scratch;
  EXPECT_EQ(draw(truncation_plot({ two_rows()[1] }), scratch), "");
}

TEST(Plots, SpinUp)
{
  const ScratchFolder scratch;
  const Plot plot = spin_up_plot(
    { { "elastic foot", { 0, 1, 2 }, { 0, -1, -1.5 } }, { "the paper", { 0, 1, 2 }, { 0, -0.9, -1.4 } } },
    two_rows().back());
  EXPECT_EQ(draw(plot, scratch), "");
  const std::string words = words_of(plot, scratch);
  EXPECT_NE(words.find("the paper"), std::string::npos);
  EXPECT_NE(words.find("turns per second"), std::string::npos);
  EXPECT_NE(words.find("−3.5 rad/s"), std::string::npos) << words; // the terminal spin
}

TEST(Plots, Phases)
{
  const ScratchFolder scratch;
  PhaseStudy phases;
  phases.n_table_phases = 2;
  phases.phases = { { 0, 0 }, { 0, full_turn / 4 } };
  phases.torque_at_rest = { -1e-3, -2e-3 };
  phases.torque_at_terminal = { 1e-3, -1e-3 };
  const Plot plot = phase_plot(phases);
  EXPECT_EQ(draw(plot, scratch), "");
  const auto columns = data_of(plot, scratch);
  EXPECT_NEAR(columns[0][1], 90, 1e-12); // the glass is flat: by the mark of the table
  EXPECT_EQ(columns[1], (std::vector<double>{ -1, -2, 1, -1 }));
  EXPECT_NE(plot.caption.find("mark of the table"), std::string::npos);
}

TEST(Plots, Convergence)
{
  const ScratchFolder scratch;
  Curve curve = {
    "a_2 / a_0", { 8, 16, 32 }, { 1e-2, 1e-3, 0 }, CurveStyle::line_and_points, { 2e-2, 2e-3, 1e-4 }
  };
  curve.is_error = true;
  const Plot plot = convergence_plot(
    { "mesh", "Refinement.", { "cells", true }, { "|a_2 - limit| / a_0", true }, { curve } });
  EXPECT_EQ(draw(plot, scratch), "");
  EXPECT_EQ(data_of(plot, scratch)[2], (std::vector<double>{ 2e-2, 2e-3, 1e-4 }));
}

TEST(Plots, Map)
{
  const ScratchFolder scratch;
  const double failed = std::numeric_limits<double>::quiet_NaN();
  ValueMap map = {
    "map",       "Two parameters.", { "moment ratio m" }, { "modulus (Pa/m)", true },
    "ω (rad/s)", { 0.2, 0.4, 0.8 }, { 1e9, 2e9, 4e9 },    { { 1, 2, 3 }, { 2, failed, 4 }, { 3, 4, 5 } }
  };
  EXPECT_EQ(draw(map_plot(map), scratch), "");
  const auto columns = data_of(map_plot(map), scratch);
  EXPECT_EQ(columns[2].size(), 9u);
  EXPECT_NEAR(columns[3][0], 0.1, 1e-15); // cells meet half-way
  EXPECT_NEAR(columns[4][0], 0.3, 1e-15);
  EXPECT_NEAR(columns[6][0], std::sqrt(2.) * 1e9, 1);
  EXPECT_NE(map_plot(map).script.find("set cbrange [1:5]"), std::string::npos);
  map.values = { { 1, 1, 1 }, { 1, 1, 1 }, { 1, 1, 1 } }; // no colours and no contours to choose
  EXPECT_EQ(draw(map_plot(map), scratch), "");
}

TEST(Plots, Tornado)
{
  const ScratchFolder scratch;
  const Plot plot =
    tornado_plot("tornado", "Sensitivities.", "change of ω (rad/s)",
                 { { "Glass/Young modulus", -0.1, 0.1 }, { "Motion/Orbit speed", -0.6, 0.5 } });
  EXPECT_EQ(draw(plot, scratch), "");
  EXPECT_EQ(data_of(plot, scratch)[1], (std::vector<double>{ -0.1, -0.6 })); // the longest on top
}

TEST(Plots, ScatterWithBandAndLogarithmicAxes)
{
  const ScratchFolder scratch;
  Curve curve = { "samples", { 1e9, 3e9, 5e9 }, { -3, -3.1, -3.2 }, CurveStyle::points, { 0.1, 0.1, 0.1 } };
  EXPECT_EQ(
    draw(curve_plot({ "scatter", "Samples.", { "k (Pa/m)", true, std::pair(1e9, 6e9) }, { "ω" }, { curve } }),
         scratch),
    "");
  curve.style = CurveStyle::line;
  EXPECT_EQ(draw(curve_plot({ "line", "A line.", { "k (Pa/m)", true }, { "ω" }, { curve } }), scratch), "");
}

} // namespace
} // namespace stemware::pipeline
