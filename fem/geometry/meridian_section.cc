#include "fem/geometry/meridian_section.h"

#include "fem/geometry/require.h"
#include "ring_model/load/constants.h"

#include <boost/geometry/algorithms/simplify.hpp>
#include <boost/geometry/geometries/register/linestring.hpp>
#include <boost/geometry/geometries/register/point.hpp>
#include <boost/geometry/strategies/strategies.hpp>

#include <algorithm>
#include <cmath>

BOOST_GEOMETRY_REGISTER_POINT_2D(stemware::fem::SectionVertex, double, boost::geometry::cs::cartesian, radius,
                                 height)
BOOST_GEOMETRY_REGISTER_LINESTRING(std::vector<stemware::fem::SectionVertex>)

namespace stemware::fem
{

namespace
{

using Polyline = std::vector<SectionVertex>;

/// Rounding error of the numbers in a file, relative to the largest radius.
constexpr double file_rounding = 1e-6;

/// Returns a description such as "line 14 (r = 0.03 m, z = 0 m)".
std::string place(const SectionVertex &vertex)
{
  return sentence("line ", vertex.line, " (r = ", vertex.radius, " m, z = ", vertex.height, " m)");
}

double largest_radius(const Polyline &polyline)
{
  double largest = 0;
  for (const SectionVertex &vertex : polyline)
    largest = std::max(largest, vertex.radius);
  return largest;
}

bool is_lower(const SectionVertex &one, const SectionVertex &other)
{
  return one.height < other.height;
}

/// Checks and normalises a profile: both ends lie on the axis, the lower end comes first, heights are
/// measured from the lowest point, and the last two points have the same height.
Polyline ordered(Polyline polyline)
{
  require(
    polyline.size() >= 6, "a profile of ", polyline.size(),
    " points is no foot; give at least 6 points (r, z) from the axis under the foot round its edge to the "
    "axis in the stem's cut.");
  // The time of the simplification below grows with the square of the number of points.
  constexpr std::size_t max_points = 10000;
  require(polyline.size() <= max_points, "a profile of ", polyline.size(),
          " points is finer than any mesh; give at most 10000, one every few micrometres.");
  const double tolerance = file_rounding * largest_radius(polyline);
  const auto coincide = [=](const SectionVertex &one, const SectionVertex &other)
  { return std::hypot(one.radius - other.radius, one.height - other.height) <= tolerance; };
  for (const SectionVertex &vertex : polyline)
    require(vertex.radius >= -tolerance, place(vertex),
            " lies beyond the axis; give one half of the section, r from 0 outwards.");
  if (coincide(polyline.front(), polyline.back()))
    polyline.pop_back(); // the polyline is closed: its last side lies on the axis
  polyline.erase(std::unique(polyline.begin(), polyline.end(), coincide), polyline.end());
  for (SectionVertex *end : { &polyline.front(), &polyline.back() })
  {
    require(end->radius <= tolerance, "the profile is open: it ends at ", place(*end),
            ", not on the axis; begin with the point r = 0 of the underside and end with the point r = 0 of "
            "the stem's cut.");
    end->radius = 0;
  }
  if (is_lower(polyline.back(), polyline.front()))
    std::reverse(polyline.begin(), polyline.end());

  Polyline simple;
  boost::geometry::simplify(polyline, simple, 1e-5 * largest_radius(polyline));
  const double lowest = std::min_element(simple.begin(), simple.end(), is_lower)->height;
  require(simple.front().height > lowest + tolerance, "the profile is lowest on the axis, at ",
          place(simple.front()),
          ", where a foot does not stand on its rim; if it is drawn upside down, let z grow from the table "
          "to the stem.");
  const SectionVertex &highest = *std::max_element(simple.begin(), simple.end(), is_lower);
  SectionVertex &corner = simple[simple.size() - 2];
  require(highest.height <= simple.back().height + tolerance &&
            corner.height >= simple.back().height - tolerance,
          "the profile does not end with the stem's cut: the last segment, from ", place(corner), " to ",
          place(simple.back()), ", has to be horizontal and the highest of all.");
  corner.height = simple.back().height;
  for (SectionVertex &vertex : simple)
    vertex.height -= lowest;
  return simple;
}

/// Returns the slope angle of the segment from point @p i to point i + 1 [rad].
double direction(const PiecewiseLinear &curve, std::size_t i)
{
  return std::atan2(curve.y[i + 1] - curve.y[i], curve.x[i + 1] - curve.x[i]);
}

} // namespace

void PiecewiseLinear::add(double at, double value, unsigned int line)
{
  x.push_back(at);
  y.push_back(value);
  lines.push_back(line);
}

double PiecewiseLinear::operator()(double at) const
{
  const auto next = std::upper_bound(x.begin(), x.end(), at);
  if (next == x.begin())
    return y.front();
  if (next == x.end())
    return y.back();
  const auto i = static_cast<std::size_t>(next - x.begin());
  const double share = (at - x[i - 1]) / (x[i] - x[i - 1]);
  return (1 - share) * y[i - 1] + share * y[i];
}

MeridianSection::MeridianSection(std::vector<SectionVertex> polyline)
{
  split(ordered(std::move(polyline)));
  require_glass_everywhere();
  cut_edge();
  find_rounding();
}

void MeridianSection::split(const std::vector<SectionVertex> &polyline)
{
  const double outermost = largest_radius(polyline);
  const auto is_outermost = [=](const SectionVertex &vertex) { return vertex.radius == outermost; };
  const auto first = std::find_if(polyline.begin(), polyline.end(), is_outermost);
  const auto last = std::find_if(polyline.rbegin(), polyline.rend(), is_outermost).base() - 1;
  const auto cut = polyline.end() - 2; // the point on the stem's surface at the cut

  for (auto vertex = polyline.begin(); vertex <= first; ++vertex)
  {
    require(
      vertex == polyline.begin() || vertex->radius > (vertex - 1)->radius,
      "the underside turns back or stands upright at ", place(*vertex),
      ": from the axis to the edge of the foot r has to grow from point to point (a steep wall may, by a "
      "little).");
    lower.add(vertex->radius, vertex->height, vertex->line);
  }
  // Inwards from the edge, the top extends while r decreases. Downwards from the cut, the stem extends while
  // z decreases. In the overlap, the stem ends at the first segment that is not steeper than 45 degrees.
  auto inner = last;
  while (inner != cut && (inner + 1)->radius < inner->radius)
    ++inner;
  auto meeting = cut;
  while (
    meeting != last && (meeting - 1)->height < meeting->height &&
    (meeting > inner || meeting->height - (meeting - 1)->height > (meeting - 1)->radius - meeting->radius))
    --meeting;
  require(meeting <= inner, "the outside turns back at ", place(*(inner + 1)),
          ": from the edge the top of the foot has to run inwards, and then the stem upwards to its cut.");
  require(meeting != cut && meeting != last, "the profile has no ",
          meeting == cut ? "stem below " : "top of the foot outside ", place(*meeting),
          "; draw a foot whose top runs from its edge inwards to a stem, and the stem up to its cut.");
  for (auto vertex = meeting; vertex >= last; --vertex)
    upper.add(vertex->radius, vertex->height, vertex->line);
  for (auto vertex = meeting; vertex <= cut; ++vertex)
    stem.add(vertex->height, vertex->radius, vertex->line);
}

void MeridianSection::require_glass_everywhere() const
{
  const auto refuse_crossing = [](double radius, unsigned int line, const char *other)
  {
    require(false, "the profile crosses itself: at r = ", radius, " m (line ", line, ") ", other,
            "; draw the outline of one piece of glass.");
  };
  constexpr char above[] = "its underside lies above its top";
  for (std::size_t i = 0; i < lower.x.size(); ++i)
    if (lower.x[i] < upper.x.back() && !(lower.y[i] < upper(lower.x[i])))
      refuse_crossing(lower.x[i], lower.lines[i], above);
  for (std::size_t i = 0; i < upper.x.size(); ++i)
    if (upper.x[i] < lower.x.back() && !(lower(upper.x[i]) < upper.y[i]))
      refuse_crossing(upper.x[i], upper.lines[i], above);
  for (std::size_t i = 1; i < upper.x.size(); ++i)
    if (upper.y[i] > middle_height() && upper.x[i] <= stem(upper.y[i]))
      refuse_crossing(upper.x[i], upper.lines[i], "the top of the foot lies inside the stem");
  for (std::size_t i = 1; i < stem.x.size(); ++i)
  {
    require(stem.y[i] > 0, "line ", stem.lines[i], " ends the stem on the axis before its cut.");
    if (stem.y[i] > middle_radius() && stem.y[i] < upper.x.back() && stem.x[i] <= upper(stem.y[i]))
      refuse_crossing(stem.y[i], stem.lines[i], "the stem lies inside the foot");
  }
}

void MeridianSection::cut_edge()
{
  const auto thickness_at = [&](double radius) { return upper(radius) - lower(radius); };
  const auto lowest = std::min_element(lower.y.begin(), lower.y.end()) - lower.y.begin();
  const double least = 0.05 * thickness_at(lower.x[static_cast<std::size_t>(lowest)]);
  edge = upper.x.back();
  if (thickness_at(edge) >= least)
    return;
  // The thickness is linear between the points of both curves.
  std::vector<double> radii = upper.x;
  for (const double radius : lower.x)
    if (radius > middle_radius())
      radii.push_back(radius);
  std::sort(radii.begin(), radii.end());
  while (radii.size() > 1 && thickness_at(radii.back()) < least)
  {
    edge = radii.back();
    radii.pop_back();
  }
  const double inside = thickness_at(radii.back()), outside = thickness_at(edge);
  edge = radii.back() + (edge - radii.back()) * (inside - least) / (inside - outside);
}

void MeridianSection::find_rounding()
{
  // On the foot, the fillet ends at the first segment with a slope angle below `foot_limit`, which lies above
  // the mean slope angle. On the stem, it ends at the first segment within 0.15 * 45 deg of the vertical.
  constexpr double half_right = ring::pi / 4;
  const double mean =
    std::atan2(std::abs(upper.y.back() - upper.y.front()), upper.x.back() - upper.x.front());
  const double foot_limit = mean + 0.15 * (half_right - mean);
  std::size_t i = 0;
  while (i + 1 < upper.x.size() && upper.x[i] < edge && std::abs(direction(upper, i)) > foot_limit)
    ++i;
  fillet_end = i + 1 < upper.x.size() && upper.x[i] < edge ? upper.x[i] : middle_radius();
  std::size_t j = 0;
  while (j + 1 < stem.x.size() && std::abs(direction(stem, j)) > 0.15 * half_right)
    ++j;
  stem_start = j + 1 < stem.x.size() ? stem.x[j] : middle_height();
}

std::vector<double> MeridianSection::corner_radii() const
{
  constexpr double smallest_bend = 0.2;
  std::vector<double> radii;
  for (const PiecewiseLinear *curve : { &lower, &upper })
    for (std::size_t i = 1; i + 1 < curve->x.size(); ++i)
      if (curve->x[i] > fillet_end && curve->x[i] < edge &&
          std::abs(direction(*curve, i) - direction(*curve, i - 1)) > smallest_bend)
        radii.push_back(curve->x[i]);
  std::sort(radii.begin(), radii.end());
  return radii;
}

std::vector<SectionVertex> MeridianSection::points_below(double height) const
{
  std::vector<SectionVertex> points;
  for (std::size_t i = 0; i < lower.x.size(); ++i)
    if (lower.y[i] <= height)
      points.push_back({ lower.x[i], lower.y[i], lower.lines[i] });
  return points;
}

} // namespace stemware::fem
