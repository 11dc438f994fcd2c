// Share of the land under pressure and largest pressure of rigid feet on a mat, against closed forms of
// chords through the land, and against the quadrature of a rigid ring by other code.
#include "fem/contact/line_integral.h"
#include "fem/contact/rigid_foot.h"
#include "tests/fem/revolution/revolution_case.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

using namespace stemware::revolution_tests;

namespace
{

constexpr double pi = 3.14159265358979323846;

/// A plane land of straight lines, of which only the geometry counts.
class PlaneLand
{
public:
  /// @p across: from the left end of the line to its right, its breadth [m].
  void add_line(const Eigen::RowVector2d &begin, const Eigen::RowVector2d &end,
                const Eigen::RowVector2d &across_begin, const Eigen::RowVector2d &across_end,
                double azimuth_width)
  {
    ContactLine line;
    line.position << begin, (begin + end) / 2, end;
    line.transverse_tangent << across_begin, (across_begin + across_end) / 2, across_end;
    line.gap.setZero();
    line.shape = Eigen::Matrix3d::Identity();
    line.samples_are_nodes = true;
    for (unsigned int i = 0; i < 3; ++i)
      line.nodes.push_back(3 * static_cast<unsigned int>(surface.lines.size()) + i);
    line.azimuth = std::atan2(line.position(1, 1), line.position(1, 0));
    line.azimuth_width = azimuth_width;
    surface.lines.push_back(line);
  }

  const ContactSurface &finished()
  {
    const auto n = static_cast<Eigen::Index>(3 * surface.lines.size());
    surface.node_position.resize(n, 2);
    for (std::size_t l = 0; l < surface.lines.size(); ++l)
      surface.node_position.middleRows<3>(static_cast<Eigen::Index>(3 * l)) = surface.lines[l].position;
    surface.node_gap = surface.node_area = Eigen::VectorXd::Zero(n);
    for (const ContactLine &line : surface.lines)
      add_node_areas(line, surface.node_area);
    return surface;
  }

  ContactSurface surface;
};

/// The annulus between two radii on @p n_lines azimuths; a disc if @p inner is 0.
const ContactSurface &annulus(PlaneLand &land, double inner, double outer, unsigned int n_lines)
{
  for (unsigned int j = 0; j < n_lines; ++j)
  {
    const double theta = 2 * pi * j / n_lines, width = 2 * pi / n_lines;
    const Eigen::RowVector2d outward(std::cos(theta), std::sin(theta)), across(-outward(1), outward(0));
    land.add_line(inner * outward, outer * outward, inner * width * across, outer * width * across, width);
  }
  land.surface.lines_are_radial = true;
  land.surface.n_sectors = n_lines;
  land.surface.is_ring = inner > 0;
  return land.finished();
}

/// Area of the part x > c of the disc with radius a, and its first and second moments in x.
struct Segment
{
  Segment(double a, double c)
  {
    c = std::min(std::max(c, -a), a);
    const double root = std::sqrt(a * a - c * c), angle = std::acos(c / a);
    area = a * a * angle - c * root;
    first = 2. / 3 * root * root * root;
    second = a * a * a * a / 4 * angle - c * (2 * c * c - a * a) * root / 4;
  }
  double area, first, second;
};

/// Where the pressure of an annulus on a mat vanishes, p ~ x - c for x > c, its centre at @p eccentricity,
/// and the share of the area beyond. In full contact the share is 1.
struct LiftedAnnulus
{
  LiftedAnnulus(double inner, double outer, double eccentricity)
  {
    const auto beyond = [&](double c, auto moment)
    { return moment(Segment(outer, c)) - (inner > 0 ? moment(Segment(inner, c)) : 0); };
    const auto centre = [&](double c)
    {
      const double area = beyond(c, [](const Segment &s) { return s.area; }),
                   first = beyond(c, [](const Segment &s) { return s.first; }),
                   second = beyond(c, [](const Segment &s) { return s.second; });
      return (second - c * first) / (first - c * area);
    };
    double low = -outer, high = outer * (1 - 1e-9);
    for (unsigned int i = 0; i < 200; ++i)
      (centre((low + high) / 2) < eccentricity ? low : high) = (low + high) / 2;
    zero = low;
    share = beyond(zero, [](const Segment &s) { return s.area; }) / (pi * (outer * outer - inner * inner));
  }
  double zero, share;
};

/// Extent of the contact of a rigid foot on a mat of 1e9 Pa/m under 10 N at @p eccentricity in x.
ContactExtent pressed(const ContactSurface &surface, double eccentricity)
{
  RigidFoot foot(surface);
  const auto mat = make_law(WinklerInterface(1e9), surface);
  const ContactSolution solution = solve_contact(foot, *mat, Resultants{ 10, 0, -10 * eccentricity }, 0.03);
  return mat->extent(solution);
}

} // namespace

TEST(ContactExtent, OfWideLandsIsAShareOfTheArea)
{
  struct Row
  {
    double inner, outer, eccentricity;
    double share, azimuths; // by a quadrature of other code; azimuths of a disc: not asked
  };
  const Row rows[] = { { 0.02, 0.04, 0.9 * 0.015, 0.983415155, 1 },
                       { 0.02, 0.04, 1.2 * 0.015, 0.818702139, 1 },
                       { 0.02, 0.04, 1.6 * 0.015, 0.548418763, 0.572950 },
                       { 0.028, 0.032, 1.1 * 0.015, 0.839529859, 0.885290 },
                       { 0.028, 0.032, 1.3 * 0.015, 0.683367771, 0.698300 },
                       { 0.025, 0.035, 1.3 * 0.015, 0.695537143, 0.742390 },
                       { 0, 0.03, 0.009, 0.955483017, 0 } };
  for (const Row &row : rows)
  {
    const LiftedAnnulus exact(row.inner, row.outer, row.eccentricity);
    EXPECT_NEAR(exact.share, row.share, 1e-8);
    for (const unsigned int n_lines : { 128u, 512u })
    {
      PlaneLand land;
      const ContactExtent extent = pressed(annulus(land, row.inner, row.outer, n_lines), row.eccentricity);
      const double allowed = 12 / std::pow(n_lines, 2); // a kink between lines costs the square of a line
      EXPECT_NEAR(extent.area_share, exact.share, allowed) << row.inner << ' ' << row.eccentricity;
      EXPECT_EQ(extent.azimuth_share.has_value(), row.inner > 0);
      if (row.inner > 0)
      {
        EXPECT_NEAR(*extent.azimuth_share, row.azimuths, 20 / std::pow(n_lines, 2) + 1e-6);
        EXPECT_EQ(*extent.azimuth_share == 1, row.azimuths == 1);
      }
    }
  }
}

TEST(ContactExtent, OfALandInFullContactIsExactlyOne)
{
  for (const double eccentricity : { 0., 0.005, 0.0124 }) // the kern of 20-40 mm: (r^2 + R^2) / 4R = 12.5 mm
  {
    PlaneLand land;
    const ContactExtent extent = pressed(annulus(land, 0.02, 0.04, 128), eccentricity);
    EXPECT_EQ(extent.area_share, 1);
    EXPECT_EQ(extent.azimuth_share, 1.);
    // p = N / A (1 + x / kern).
    const double mean = 10 / (pi * (0.04 * 0.04 - 0.02 * 0.02));
    EXPECT_NEAR(extent.peak_pressure / (mean * (1 + eccentricity / 0.0125)), 1, 1e-9);
  }
  PlaneLand land;
  EXPECT_LT(pressed(annulus(land, 0.02, 0.04, 128), 0.0126).area_share, 1);
}

TEST(ContactExtent, OfAPlateBeyondItsKernIsThatOfATriangularPressure)
{
  // 80 x 40 mm, the load 10 mm off in y: p = 2 N / (3 L (B/2 - e)) at the edge, over 3 (B/2 - e) of B.
  PlaneLand land;
  constexpr unsigned int n = 50;
  const double length = 0.08, breadth = 0.04, eccentricity = 0.01;
  for (unsigned int j = 0; j < n; ++j)
  {
    const double x = length * ((j + 0.5) / n - 0.5);
    const Eigen::RowVector2d across(length / n, 0);
    for (const double side : { -1., 0. })
      land.add_line({ x, side * breadth / 2 }, { x, (side + 1) * breadth / 2 }, across, across, 0.1);
  }
  land.surface.n_sectors = 32;
  land.surface.is_ring = false;
  const ContactSurface &surface = land.finished();
  RigidFoot foot(surface);
  const auto mat = make_law(WinklerInterface(1e9), surface);
  const ContactExtent extent =
    mat->extent(solve_contact(foot, *mat, Resultants{ 10, 10 * eccentricity, 0 }, 0.03));
  EXPECT_NEAR(extent.area_share, 0.75, 1e-9);
  EXPECT_FALSE(extent.azimuth_share);
  EXPECT_NEAR(extent.peak_pressure, 2 * 10 / (3 * length * (breadth / 2 - eccentricity)), 1e-4);
}

TEST(ContactExtent, OfACrownedRimIsThatOfItsAzimuths)
{
  // A rigid rim, R = 30 mm, crown 3 mm, on 1e10 Pa/m, N = 2.943 N; share and largest pressure by a quadrature
  // of other code in r and theta.
  struct Row
  {
    double m, share, pressure;
  };
  const Row rows[] = { { 1.0, 1, 100076.6416 },
                       { 1.2, 1, 108254.7822 },
                       { 1.5, 0.618907039, 127427.8972 },
                       { 1.8, 0.362327510, 174461.3713 },
                       { 1.95, 0.178035671, 276029.2751 } };
  const GlassProfile profile;
  RevolutionCase rim(profile, foot_compliance(profile, equal_cells(), MeridianOptions{ 2, 1 }), 128);
  const ContactSurface &surface = rim.body.contact_surface();
  EXPECT_TRUE(surface.is_crowned);
  RigidFoot foot(surface);
  const auto mat = make_law(WinklerInterface(1e10), surface);
  for (const Row &row : rows)
    for (const double direction : { -pi / 2, 0.02 }) // on a line, and between two
    {
      const ContactLoad load =
        extract_load(*mat, solve_contact(foot, *mat, load_at(row.m, direction), 0.03), 8);
      EXPECT_NEAR(load.contact_fraction, row.share, 1e-3) << row.m; // the lines are 8e-3 apart
      EXPECT_EQ(load.azimuth_fraction, load.contact_fraction);
      EXPECT_NEAR(load.peak_pressure / row.pressure, 1, 1e-4) << row.m;
    }
  GlassProfile flat = flat_profile();
  EXPECT_FALSE(RevolutionCase(flat, foot_compliance(flat, equal_cells(), MeridianOptions{ 2, 1 }), 16)
                 .body.contact_surface()
                 .is_crowned);
}
