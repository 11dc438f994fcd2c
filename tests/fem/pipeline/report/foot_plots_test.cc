// The pictures of the foot: what they are drawn from, and that gnuplot draws them without a complaint.
#include "fem/contact/footprint.h"
#include "fem/pipeline/report/plots/plots.h"
#include "tests/fem/pipeline/report/drawn_plots.h"

#include <gtest/gtest.h>

#include <cmath>

namespace stemware::pipeline
{
namespace
{

using test::draw;
using test::picture;
using test::ScratchFolder;

/// A plate of 2 mm to r = 34 mm under a stem of 5 mm to z = 12 mm, in four cells.
const std::vector<fem::SectionPolygon> plate = {
  { { 0, 0 }, { 0.005, 0 }, { 0.005, 0.002 }, { 0, 0.002 } },
  { { 0.005, 0 }, { 0.020, 0 }, { 0.020, 0.002 }, { 0.005, 0.002 } },
  { { 0.020, 0 }, { 0.034, 0 }, { 0.034, 0.002 }, { 0.020, 0.002 } },
  { { 0, 0.002 }, { 0.005, 0.002 }, { 0.005, 0.012 }, { 0, 0.012 } },
};

/// Under pressure where cos(theta) > 0, 0.1 mm to both sides of r = 30 mm.
fem::PressureMap half_loaded(bool is_grid)
{
  fem::PressureMap map;
  map.is_grid = is_grid;
  for (unsigned int i = 0; i < 8; ++i)
  {
    map.cuts.emplace_back();
    for (const double offset : { -2e-4, -1e-4, 1e-4, 2e-4 })
      map.cuts.back().push_back(
        { 0.030 + offset, i * M_PI / 4,
          std::abs(offset) < 1.5e-4 ? 2e3 * std::max(0., std::cos(i * M_PI / 4)) : 0 });
  }
  return map;
}

/// The plots of a foot of 30 mm with a crown of 2.5 mm, or of one from a mesh, whose crown is not known.
Document foot_document(bool is_grid, const ring::Motion &motion = {}, const std::string &mesh_file = "")
{
  Study study;
  study.glass.profile.contact_radius = 0.030;
  study.glass.profile.crown_radius = 0.0025;
  study.contact.mesh_file = mesh_file;
  study.motion.orbit = motion;
  FootReport foot;
  foot.footprint = half_loaded(is_grid);
  foot.section = plate;
  Document document;
  add_foot_plots(study, foot, document);
  return document;
}

bool svg_says(const Plot &plot, const ScratchFolder &scratch, const std::string &words)
{
  return test::read_text(scratch / ("figures/" + plot.name + ".svg")).find(words) != std::string::npos;
}

TEST(FootPlots, LengthsAreThoseOfTheSection)
{
  const fem::SectionLengths lengths = fem::lengths_of(plate, 0.030);
  EXPECT_EQ(lengths.outer_radius, 0.034);
  EXPECT_EQ(lengths.height, 0.012);
  EXPECT_NEAR(lengths.thickness, 0.002, 1e-15);
  EXPECT_EQ(lengths.stem_radius, 0.005);
  const fem::ContactWidth band = fem::loaded_band(half_loaded(true));
  EXPECT_NEAR(band.inner, 0.02985, 1e-15); // half-way to the point without pressure
  EXPECT_NEAR(band.outer, 0.03015, 1e-15);
}

TEST(FootPlots, SectionShowsItsLengths)
{
  const ScratchFolder scratch;
  const Plot plot = picture(foot_document(true), "section");
  EXPECT_EQ(draw(plot, scratch), "");
  for (const char *words : { "R = 30 mm", "foot 34 mm", "12 mm", "2 mm", "crown 2.5 mm", "cut, held" })
    EXPECT_TRUE(svg_says(plot, scratch, words)) << words;
  const auto columns = test::read_columns(scratch / "figures/section.dat");
  EXPECT_EQ(columns[0].size(), 4u * 5); // closed polygons
  EXPECT_EQ(columns[0][6], 20);         // mm
}

TEST(FootPlots, RimIsLiftedByItsCrown)
{
  const ScratchFolder scratch;
  const Document document = foot_document(true);
  const Plot plot = picture(document, "rim");
  EXPECT_EQ(draw({ picture(document, "section"), plot }, scratch), "");
  EXPECT_TRUE(svg_says(plot, scratch, "under load 0.3 mm"));
  // The cells of the section, lifted by the crown in gnuplot; without one they stay where they are.
  EXPECT_EQ(plot.data_file, "figures/section.dat");
  EXPECT_NE(plot.script.find("crown = 2.5\n"), std::string::npos);
  EXPECT_NE(plot.caption.find("crown"), std::string::npos);
  const std::string lifted = test::read_text(scratch / "figures/rim.svg");
  const Document flat = foot_document(true, {}, "foot.msh");
  EXPECT_EQ(draw({ picture(flat, "section"), picture(flat, "rim") }, scratch), "");
  EXPECT_NE(test::read_text(scratch / "figures/rim.svg"), lifted);
  EXPECT_EQ(picture(flat, "rim").caption.find("crown"), std::string::npos);
}

TEST(FootPlots, FromAboveTheOrbitsCentreIsAboveWhereTheOrbitIsCounterClockwise)
{
  const ScratchFolder scratch;
  ring::Motion motion;
  for (const bool is_grid : { true, false })
  {
    const Document document = foot_document(is_grid, motion);
    const Plot plot = picture(document, "foot_from_above");
    EXPECT_EQ(draw({ picture(document, "footprint"), plot }, scratch), "");
    EXPECT_TRUE(svg_says(plot, scratch, "150 mm from here"));
    const int enlarged = is_grid ? 20 : 35; // a grid is drawn to where its pressure ends
    EXPECT_NE(plot.caption.find(std::to_string(enlarged) + " times larger"), std::string::npos)
      << plot.caption;
    EXPECT_NE(plot.script.find("magnification = " + std::to_string(enlarged) + "."), std::string::npos);
    EXPECT_EQ(plot.data_file, "figures/footprint.dat");
    const auto columns = test::read_columns(scratch / "figures/footprint.dat");
    // A grid has nine cuts of 24 places each from 29.85 to 30.15 mm, half-way to the points without pressure;
    // else the points under pressure are drawn, those at 90 degrees by rounding.
    ASSERT_EQ(columns[0].size(), is_grid ? 9u * 24 : 8u);
    const std::size_t last = is_grid ? 47 : 3; // of the second cut
    EXPECT_NEAR(columns[0][last], 45, 1e-6);
    EXPECT_NEAR(columns[1][last], is_grid ? 150 : 100, 1e-6);
    EXPECT_NEAR(columns[2][last], is_grid ? 0 : 2 / std::sqrt(2.), 1e-4); // kPa
    EXPECT_NEAR(columns[2][is_grid ? 24 + 12 : 2], 2 / std::sqrt(2.), 1e-4);
    EXPECT_TRUE(!is_grid || std::isnan(columns[2][4 * 24 + 1]));
  }
  // Seen from above, as in the picture of the load, the left of the motion lies upwards.
  const auto height_of_text = [&]
  {
    const Document document = foot_document(true, motion);
    EXPECT_EQ(draw({ picture(document, "footprint"), picture(document, "foot_from_above") }, scratch), "");
    const std::string svg = test::read_text(scratch / "figures/foot_from_above.svg");
    const auto place = svg.rfind("translate(", svg.find("150 mm from here"));
    return std::stod(svg.substr(svg.find(',', place) + 1)); // from above
  };
  const double above = height_of_text();
  motion.orbit_sense = ring::OrbitSense::clockwise;
  EXPECT_LT(above, height_of_text() - 50);
}

} // namespace
} // namespace stemware::pipeline
