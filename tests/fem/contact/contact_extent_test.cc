#include "fem/contact/line_integral.h"
#include "fem/contact/rigid_foot.h"
#include "ring_model/load/constants.h"
#include "tests/fem/revolution/revolution_case.h"
#include "tests/ulps.h"
#include "tests/verification/lifted_annulus.h"
#include "tests/verification/lifted_square.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

using namespace stemware::revolution_tests;
using stemware::verification::LiftedAnnulus;
namespace verification = stemware::verification;

namespace
{

using stemware::ring::pi;

class PlaneLand
{
public:
  /// Adds a line from @p begin to @p end. @p across_begin and @p across_end are the width vectors at its ends
  /// [m].
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

/// Returns an annulus with @p n_lines radial lines; a disc if @p inner is 0.
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

struct Pressed
{
  ContactExtent extent;
  Eigen::Vector3d motion;
};

/// Returns contact extent and motion of a rigid foot under @p normal_force [N] at (x, y) [m] on a mat of @p
/// modulus [Pa/m].
Pressed pressed_at(const ContactSurface &surface, double normal_force, double x, double y, double modulus)
{
  RigidFoot foot(surface);
  const auto mat = make_law(WinklerInterface(modulus), surface);
  const ContactSolution solution =
    solve_contact(foot, *mat, Resultants{ normal_force, normal_force * y, -normal_force * x }, 0.03);
  return { mat->extent(solution), solution.motion };
}

ContactExtent pressed(const ContactSurface &surface, double eccentricity)
{
  return pressed_at(surface, 10, eccentricity, 0, 1e9).extent;
}

const ContactSurface &plate(PlaneLand &land, double length, double breadth, unsigned int n_lines)
{
  for (unsigned int j = 0; j < n_lines; ++j)
  {
    const double x = length * ((j + 0.5) / n_lines - 0.5);
    const Eigen::RowVector2d across(length / n_lines, 0);
    for (const double side : { -1., 0. })
      land.add_line({ x, side * breadth / 2 }, { x, (side + 1) * breadth / 2 }, across, across, 0.1);
  }
  land.surface.n_sectors = 32;
  land.surface.is_ring = false;
  return land.finished();
}

/// Returns three short radial lines that end at @p corners, so that the convex hull is a triangle.
const ContactSurface &tripod(PlaneLand &land, const std::vector<Eigen::RowVector2d> &corners)
{
  for (const Eigen::RowVector2d &corner : corners)
  {
    const Eigen::RowVector2d across = 0.001 * Eigen::RowVector2d(-corner(1), corner(0)).normalized();
    land.add_line(0.95 * corner, corner, across, across, 0.1);
  }
  land.surface.n_sectors = 3;
  land.surface.is_ring = false;
  return land.finished();
}

/// Returns the distance [m] from the axis to the border of the convex polygon @p corners (counter-clockwise)
/// in the direction @p angle.
double distance_to_border(const std::vector<Eigen::RowVector2d> &corners, double angle)
{
  const Eigen::RowVector2d ray(std::cos(angle), std::sin(angle));
  double distance = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    const Eigen::RowVector2d side = corners[(i + 1) % corners.size()] - corners[i];
    const Eigen::RowVector2d outward(side(1), -side(0));
    if (outward.dot(ray) > 0)
      distance = std::min(distance, outward.dot(corners[i]) / outward.dot(ray));
  }
  return distance;
}

bool tips(const ContactSurface &surface, double distance, double angle)
{
  try
  {
    pressed_at(surface, 10, distance * std::cos(angle), distance * std::sin(angle), 1e9);
  }
  catch (const TippingDemand &)
  {
    return true;
  }
  // If a single point next to a corner is loaded, the contact set is singular.
  catch (const ContactFailure &failure)
  {
    EXPECT_EQ(failure.outcome, ContactOutcome::singular_set);
  }
  return false;
}

/// Pressure c + g_x x + g_y y (positive part) under a rigid plate on a mat, from a LiftedSquare in the
/// coordinates (2 x / length, 2 y / breadth).
struct PlatePressure
{
  PlatePressure(double length, double breadth, double force, double x, double y)
  {
    const verification::LiftedSquare square({ 2 * x / length, 2 * y / breadth });
    const double scale = 4 * force / (length * breadth); // a LiftedSquare has 1 N on an area of 4
    plane = scale * square.motion.cwiseProduct(Eigen::Vector3d(1, 2 / length, 2 / breadth));
    peak = scale * square.peak();
    share = square.share();
  }

  Eigen::Vector3d plane;
  double peak, share;
};

} // namespace

TEST(ContactExtent, AgreesWithTheClosedFormForAnnularLandsAndADisc)
{
  struct Row
  {
    double inner, outer, eccentricity;
    double share, azimuths; // quadrature by other code; a disc has no azimuth share
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
      const Pressed found =
        pressed_at(annulus(land, row.inner, row.outer, n_lines), 10, row.eccentricity, 0, 1e9);
      const ContactExtent &extent = found.extent;
      const double allowed = 12 / std::pow(n_lines, 2); // error due to the contact edge between two lines
      // Closed forms for the pressure p = slope (x - zero).
      const double slope = 10 / exact.per_slope;
      EXPECT_NEAR(extent.peak_pressure / (slope * (row.outer - exact.zero)), 1, allowed) << row.eccentricity;
      EXPECT_NEAR(found.motion(0) / (slope * exact.zero / 1e9), 1, allowed * 0.04 / std::abs(exact.zero));
      EXPECT_NEAR(found.motion(1) / (-slope / 1e9), 1, allowed);
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

TEST(ContactExtent, FullContactEndsAtTheKernAndItsPeakPressureIsExact)
{
  // Kern radius of an annulus with r = 20 mm and R = 40 mm: (r^2 + R^2) / 4R = 12.5 mm.
  for (const double eccentricity : { 0., 0.005, 0.0124 })
  {
    PlaneLand land;
    const ContactExtent extent = pressed(annulus(land, 0.02, 0.04, 128), eccentricity);
    EXPECT_EQ(extent.area_share, 1);
    EXPECT_EQ(extent.azimuth_share, 1.);
    // In full contact the largest pressure is N / A (1 + e / kern).
    const double mean = 10 / (pi * (0.04 * 0.04 - 0.02 * 0.02));
    EXPECT_NEAR(extent.peak_pressure / (mean * (1 + eccentricity / 0.0125)), 1, 1e-9);
  }
  PlaneLand land;
  EXPECT_LT(pressed(annulus(land, 0.02, 0.04, 128), 0.0126).area_share, 1);
}

// Reference: test case V6.02.130 of Code_Aster, a square plate of side 2 m under 80/3 N at 0.5 m from its
// centre, on a mat of 5000 Pa/m. One edge penetrates by 4/1125 m, the opposite edge is 4/3375 m above the
// mat.
TEST(ContactExtent, AgreesWithCodeAsterUnderARigidPlate)
{
  PlaneLand land;
  const Pressed found = pressed_at(plate(land, 2, 2, 8), 80. / 3, 0, 0.5, 5000);
  EXPECT_NEAR(found.motion(0) + found.motion(2), -4. / 1125, 1e-13);
  EXPECT_NEAR(found.motion(0) - found.motion(2), 4. / 3375, 1e-13);
  EXPECT_NEAR(found.motion(1), 0, stemware::ulps(3800, found.motion(0)));
  EXPECT_NEAR(found.extent.area_share, 0.75, 1e-9);
  EXPECT_FALSE(found.extent.azimuth_share);
  EXPECT_NEAR(found.extent.peak_pressure, 5000 * 4. / 1125, 1e-9);
}

TEST(ContactExtent, AFootTipsAtTheBorderOfItsConvexHull)
{
  using Corners = std::vector<Eigen::RowVector2d>;
  const auto expect_border = [](const ContactSurface &surface, const Corners &hull)
  {
    for (unsigned int k = 0; k < 32; ++k)
    {
      const double angle = 2 * pi * k / 32 + 0.037, limit = distance_to_border(hull, angle);
      EXPECT_FALSE(tips(surface, 0.999 * limit, angle)) << k;
      EXPECT_TRUE(tips(surface, 1.00001 * limit, angle)) << k;
    }
  };
  const Corners triangle = { { 0.04, -0.01 }, { 0.005, 0.03 }, { -0.03, -0.02 } };
  PlaneLand feet, strip;
  expect_border(tripod(feet, triangle), triangle);
  // The outermost of the 40 lines lies half a line width inside the edge of the plate.
  constexpr double a = 0.04 * (1 - 1. / 40), b = 0.02;
  expect_border(plate(strip, 0.08, 0.04, 40), { { a, -b }, { a, b }, { -a, b }, { -a, -b } });
}

// Closed form for a loaded triangle: p = 6 N / (a b) at the corner, where the legs a and b are four times the
// distances of the force from the edges. Otherwise the reference is LiftedSquare.
TEST(ContactExtent, AgreesWithTheClosedFormUnderBiaxialEccentricity)
{
  struct Row
  {
    double x, y; ///< point of the force [m]
  };
  const double length = 0.08, breadth = 0.04, force = 10, modulus = 1e9;
  for (const Row &row : { Row{ 0.006, 0.002 }, Row{ 0.01, 0.005 }, Row{ 0.018, 0.004 }, Row{ -0.012, 0.0095 },
                          Row{ 0.025, 0.012 } })
  {
    const PlatePressure exact(length, breadth, force, row.x, row.y);
    if (row.x == 0.025)
    {
      const double a = 4 * (length / 2 - row.x), b = 4 * (breadth / 2 - row.y);
      EXPECT_NEAR(exact.peak, 6 * force / (a * b), 1e-9 * exact.peak);
      EXPECT_NEAR(exact.share, a * b / 2 / (length * breadth), 1e-12);
    }
    if (row.x == 0.006) // in the kern, |x|/L + |y|/B < 1/6: p = N/A (1 + 6 x/L + 6 y/B)
    {
      EXPECT_NEAR(exact.peak, force / (length * breadth) * (1 + 6 * (row.x / length + row.y / breadth)),
                  1e-9 * exact.peak);
    }
    for (const unsigned int n_lines : { 100u, 400u })
    {
      PlaneLand land;
      const Pressed found = pressed_at(plate(land, length, breadth, n_lines), force, row.x, row.y, modulus);
      const double allowed = 8 / std::pow(n_lines, 2); // error of the midpoint rule over the strips
      EXPECT_NEAR(found.extent.area_share, exact.share, allowed) << row.x;
      EXPECT_NEAR(found.extent.peak_pressure / exact.peak, 1, 1. / n_lines) << row.x;
      const Eigen::Vector3d motion = -exact.plane / modulus;
      for (unsigned int i = 0; i < 3; ++i)
        EXPECT_NEAR(found.motion(i) * (i > 0 ? 0.04 : 1), motion(i) * (i > 0 ? 0.04 : 1),
                    allowed * exact.peak / modulus)
          << row.x << ' ' << i;
    }
  }
}

TEST(ContactExtent, AgreesWithQuadratureUnderACrownedRim)
{
  // Rigid rim, R = 30 mm, crown 3 mm, on 1e10 Pa/m, N = 2.943 N. Reference: quadrature in r and theta by
  // other code.
  struct Row
  {
    double m, share, pressure;
  };
  const Row rows[] = { { 1., 1, 100076.6416 },
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
    for (const double direction : { -pi / 2, 0.02 }) // pressure maximum on a line, and between two lines
    {
      const ContactLoad load =
        extract_load(*mat, solve_contact(foot, *mat, load_at(row.m, direction), 0.03), 8);
      EXPECT_NEAR(load.contact_fraction, row.share, 1e-3) << row.m;
      EXPECT_EQ(load.azimuth_fraction, load.contact_fraction);
      EXPECT_NEAR(load.peak_pressure / row.pressure, 1, 1e-4) << row.m;
    }
  GlassProfile flat = flat_profile();
  EXPECT_FALSE(RevolutionCase(flat, foot_compliance(flat, equal_cells(), MeridianOptions{ 2, 1 }), 16)
                 .body.contact_surface()
                 .is_crowned);
}
