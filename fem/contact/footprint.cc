#include "fem/contact/footprint.h"

#include "ring_model/load/constants.h"

#include <algorithm>
#include <iterator>
#include <limits>

namespace stemware::fem
{

namespace
{

constexpr double whole_turn = 2 * ring::pi;

double pressure_at(const std::vector<PressurePoint> &cut, double radius)
{
  const auto above = std::lower_bound(cut.begin(), cut.end(), radius,
                                      [](const PressurePoint &point, double r) { return point.radius < r; });
  if (above == cut.begin() || above == cut.end())
    return (above == cut.end() ? cut.back() : cut.front()).pressure;
  const auto below = above - 1;
  const double share = (radius - below->radius) / (above->radius - below->radius);
  return (1 - share) * below->pressure + share * above->pressure;
}

/// Returns @p n points across the width of the contact; their pressures are NaN if the cut is unloaded.
std::vector<PressurePoint> across_contact(const std::vector<PressurePoint> &cut, bool has_edge, std::size_t n)
{
  const double nothing = std::numeric_limits<double>::quiet_NaN(), azimuth = cut.front().azimuth;
  const std::optional<ContactWidth> width = contact_width(cut, has_edge);
  if (!width)
    return std::vector<PressurePoint>(n, { cut.front().radius, azimuth, nothing });
  std::vector<PressurePoint> loaded;
  std::copy_if(cut.begin(), cut.end(), std::back_inserter(loaded),
               [&](const PressurePoint &point) { return point.pressure > 0 || !has_edge; });
  if (width->inner < loaded.front().radius)
    loaded.insert(loaded.begin(), { width->inner, azimuth, 0 });
  if (width->outer > loaded.back().radius)
    loaded.push_back({ width->outer, azimuth, 0 });
  std::vector<PressurePoint> points;
  for (std::size_t i = 0; i < n; ++i)
  {
    const double share = static_cast<double>(i) / static_cast<double>(n - 1);
    const double radius =
      std::clamp((1 - share) * width->inner + share * width->outer, width->inner, width->outer);
    points.push_back({ radius, azimuth, pressure_at(loaded, radius) });
  }
  return points;
}

} // namespace

bool has_cells(const PressureMap &footprint)
{
  return footprint.is_grid && footprint.cuts.front().size() > 1;
}

double largest_pressure(const PressureMap &footprint)
{
  double largest = 0;
  for (const auto &cut : footprint.cuts)
    for (const PressurePoint &point : cut)
      largest = std::max(largest, point.pressure);
  return largest;
}

ContactWidth loaded_band(const PressureMap &footprint)
{
  ContactWidth band = { std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity() };
  const auto include = [&](double inner, double outer) {
    band = { std::min(band.inner, inner), std::max(band.outer, outer) };
  };
  for (const auto &cut : footprint.cuts)
    if (const auto width = has_cells(footprint) ? contact_width(cut, footprint.has_edge) : std::nullopt)
      include(width->inner, width->outer);
    else if (!has_cells(footprint))
      for (const PressurePoint &point : cut)
        if (point.pressure > 0)
          include(point.radius, point.radius);
  return band;
}

std::vector<std::vector<PressurePoint>> loaded_cuts(const PressureMap &footprint)
{
  constexpr std::size_t n_cuts = 72, n_across = 24;
  std::vector<std::vector<PressurePoint>> cuts;
  if (!has_cells(footprint))
  {
    for (const auto &cut : footprint.cuts)
    {
      cuts.emplace_back();
      std::copy_if(cut.begin(), cut.end(), std::back_inserter(cuts.back()),
                   [](const PressurePoint &point) { return point.pressure > 0; });
    }
    return cuts;
  }
  const std::size_t stride = (footprint.cuts.size() - 1) / n_cuts + 1;
  for (std::size_t c = 0; c < footprint.cuts.size(); c += stride)
    cuts.push_back(across_contact(footprint.cuts[c], footprint.has_edge, n_across));
  cuts.push_back(cuts.front());
  for (PressurePoint &point : cuts.back())
    point.azimuth += whole_turn;
  return cuts;
}

FootprintMeasures measures_of(const PressureMap &footprint)
{
  const std::size_t n_cuts = footprint.cuts.size();
  FootprintMeasures measures = { {}, 0, std::numeric_limits<double>::infinity(), 0 };
  double force = 0, area = 0;
  for (std::size_t c = 0; c < n_cuts; ++c)
  {
    const double before =
      c > 0 ? footprint.cuts[c - 1].front().azimuth : footprint.cuts.back().front().azimuth - whole_turn;
    const double after = c + 1 < n_cuts ? footprint.cuts[c + 1].front().azimuth
                                        : footprint.cuts.front().front().azimuth + whole_turn;
    const auto points = across_contact(footprint.cuts[c], footprint.has_edge, 2 * footprint.cuts[c].size());
    const bool has_load = points.front().pressure >= 0;
    const double width = has_load ? points.back().radius - points.front().radius : 0;
    measures.narrowest = std::min(measures.narrowest, width);
    measures.widest = std::max(measures.widest, width);
    for (std::size_t i = 1; i < points.size() && has_load; ++i)
    {
      const double piece = (after - before) / 2 * (points[i].radius - points[i - 1].radius) *
                           (points[i].radius + points[i - 1].radius) / 2;
      area += piece;
      force += piece * (points[i].pressure + points[i - 1].pressure) / 2;
    }
    for (const PressurePoint &point : footprint.cuts[c])
      if (point.pressure > measures.largest.pressure)
        measures.largest = point;
  }
  measures.mean = force / area;
  return measures;
}

} // namespace stemware::fem
