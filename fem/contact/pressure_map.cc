#include "fem/contact/pressure_map.h"

#include "fem/contact/line_integral.h"

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace stemware::fem
{

namespace
{

/// Pressure below this share of the largest is not shown.
constexpr double least_share = 1e-3;

constexpr unsigned int n_points_across = 33;

/// theta in [0, 2 pi).
double wrapped(double azimuth)
{
  const double turns = azimuth / boost::math::double_constants::two_pi;
  return std::max(0., (turns - std::floor(turns)) * boost::math::double_constants::two_pi);
}

void sort_by_azimuth(PressureMap &pressure_map)
{
  std::stable_sort(pressure_map.cuts.begin(), pressure_map.cuts.end(),
                   [](const auto &one, const auto &other)
                   { return one.front().azimuth < other.front().azimuth; });
}

/// A contact line with the pressure along it.
class LoadedLine
{
public:
  LoadedLine(const ContactLine &line, const Eigen::VectorXd &normal_displacement,
             const std::function<double(double)> &pressure)
      : line(line)
      , depth(penetration(line, normal_displacement))
      , pressure(pressure)
  {
  }

  /// At a local coordinate in [-1, 1].
  PressurePoint at(double xi) const
  {
    const Eigen::Vector3d shape = line_shape(xi);
    const Eigen::RowVector2d position = shape.transpose() * line.position;
    return { position.norm(), wrapped(std::atan2(position(1), position(0))), pressure(shape.dot(depth)) };
  }

  double begin() const { return line.position.row(0).norm(); }
  double end() const { return line.position.row(2).norm(); }

private:
  const ContactLine &line;
  const Eigen::Vector3d depth; ///< at the samples [m]
  const std::function<double(double)> &pressure;
};

/// Radii between which there is pressure worth showing.
struct RadialRange
{
  double lower = 0;
  double upper = 0;
};

RadialRange loaded_range(const std::vector<LoadedLine> &lines)
{
  constexpr unsigned int n_samples = 16;
  std::vector<PressurePoint> points;
  double largest = 0;
  for (const LoadedLine &line : lines)
    for (unsigned int i = 0; i <= n_samples; ++i)
    {
      points.push_back(line.at(2. * i / n_samples - 1));
      largest = std::max(largest, points.back().pressure);
    }
  RadialRange range = { 1e300, 0 };
  RadialRange zone = range;
  for (const PressurePoint &point : points)
  {
    zone = { std::min(zone.lower, point.radius), std::max(zone.upper, point.radius) };
    if (point.pressure >= least_share * largest)
      range = { std::min(range.lower, point.radius), std::max(range.upper, point.radius) };
  }
  const double margin = 0.1 * (range.upper - range.lower) + 1e-3 * (zone.upper - zone.lower);
  return { std::max(zone.lower, range.lower - margin), std::min(zone.upper, range.upper + margin) };
}

/// The cut at one azimuth, through the lines that lie on it.
std::vector<PressurePoint> cut_through(const std::vector<const LoadedLine *> &lines, double azimuth,
                                       const RadialRange &range)
{
  std::vector<PressurePoint> cut;
  for (unsigned int i = 0; i < n_points_across; ++i)
  {
    const double radius = range.lower + (range.upper - range.lower) * i / (n_points_across - 1);
    double pressure = 0;
    for (const LoadedLine *line : lines)
    {
      const double xi = 2 * (radius - line->begin()) / (line->end() - line->begin()) - 1;
      if (std::abs(xi) <= 1 + 1e-9)
        pressure = line->at(std::clamp(xi, -1., 1.)).pressure;
    }
    cut.push_back({ radius, azimuth, pressure });
  }
  return cut;
}

/// Indices by azimuth, those of one azimuth together; rounding does not tell azimuths apart.
std::vector<std::vector<std::size_t>> groups_of_azimuths(const std::vector<double> &azimuths)
{
  constexpr double tolerance = 1e-7;
  std::vector<std::size_t> order(azimuths.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  // What is a rounding error below 2 pi counts as 0.
  const auto key = [&](std::size_t i) { return wrapped(azimuths[i] + tolerance / 2); };
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return key(i) < key(j); });
  std::vector<std::vector<std::size_t>> groups;
  for (const std::size_t i : order)
  {
    if (groups.empty() || key(i) - key(groups.back().front()) > tolerance)
      groups.emplace_back();
    groups.back().push_back(i);
  }
  return groups;
}

} // namespace

PressureMap PressureMap::turned(double angle) const
{
  PressureMap result = *this;
  for (auto &cut : result.cuts)
    for (PressurePoint &point : cut)
      point.azimuth = wrapped(point.azimuth + angle);
  sort_by_azimuth(result);
  return result;
}

PressureMap pressure_map_of_lines(const ContactSurface &surface, const Eigen::VectorXd &normal_displacement,
                                  const std::function<double(double)> &pressure)
{
  std::vector<LoadedLine> lines;
  for (const ContactLine &line : surface.lines)
    lines.emplace_back(line, normal_displacement, pressure);
  PressureMap pressure_map;
  pressure_map.is_grid = surface.lines_are_radial;
  if (!surface.lines_are_radial)
  {
    for (const LoadedLine &line : lines)
      pressure_map.cuts.push_back({ line.at(-1), line.at(-0.5), line.at(0), line.at(0.5), line.at(1) });
    sort_by_azimuth(pressure_map);
    return pressure_map;
  }
  const RadialRange range = loaded_range(lines);
  std::vector<double> azimuths;
  for (const ContactLine &line : surface.lines)
    azimuths.push_back(line.azimuth);
  for (const std::vector<std::size_t> &group : groups_of_azimuths(azimuths))
  {
    std::vector<const LoadedLine *> on_cut;
    for (const std::size_t i : group)
      on_cut.push_back(&lines[i]);
    pressure_map.cuts.push_back(cut_through(on_cut, wrapped(azimuths[group.front()]), range));
  }
  return pressure_map;
}

PressureMap pressure_map_of_nodes(const ContactSurface &surface, const Eigen::VectorXd &pressure)
{
  const double least = least_share * pressure.maxCoeff();
  RadialRange range = { 1e300, 0 };
  std::vector<double> azimuths;
  for (unsigned int i = 0; i < surface.n_nodes(); ++i)
  {
    const double radius = surface.node_position.row(i).norm();
    azimuths.push_back(std::atan2(surface.node_position(i, 1), surface.node_position(i, 0)));
    if (pressure(i) >= least)
      range = { std::min(range.lower, radius), std::max(range.upper, radius) };
  }
  // A contact on a single circle still needs neighbours to be seen.
  const double margin = std::max(0.25 * (range.upper - range.lower), 1e-4 * range.upper);
  PressureMap pressure_map;
  pressure_map.is_grid = true;
  for (const std::vector<std::size_t> &group : groups_of_azimuths(azimuths))
  {
    std::vector<PressurePoint> cut;
    for (const std::size_t i : group)
    {
      const double radius = surface.node_position.row(static_cast<Eigen::Index>(i)).norm();
      if (range.lower - margin <= radius && radius <= range.upper + margin)
        cut.push_back({ radius, wrapped(azimuths[group.front()]), pressure(static_cast<Eigen::Index>(i)) });
    }
    std::sort(cut.begin(), cut.end(),
              [](const PressurePoint &one, const PressurePoint &other) { return one.radius < other.radius; });
    if (!cut.empty())
      pressure_map.cuts.push_back(std::move(cut));
  }
  for (const auto &cut : pressure_map.cuts)
    pressure_map.is_grid = pressure_map.is_grid && cut.size() == pressure_map.cuts.front().size();
  return pressure_map;
}

} // namespace stemware::fem
