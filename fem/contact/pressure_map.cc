#include "fem/contact/pressure_map.h"

#include "fem/contact/line_integral.h"
#include "ring_model/load/constants.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace stemware::fem
{

namespace
{

/// Fraction of the maximum pressure below which pressures are not shown.
constexpr double min_share = 1e-3;

constexpr unsigned int n_points_across = 33;

double wrapped(double azimuth)
{
  const double turns = azimuth / (2 * ring::pi);
  return std::max(0., (turns - std::floor(turns)) * 2 * ring::pi);
}

void sort_by_azimuth(PressureMap &pressure_map)
{
  std::stable_sort(pressure_map.cuts.begin(), pressure_map.cuts.end(),
                   [](const auto &one, const auto &other)
                   { return one.front().azimuth < other.front().azimuth; });
}

class LoadedLine
{
public:
  /// Data of a line that ranks exchange: azimuth, positions and penetrations at the samples.
  using Packed = Eigen::Matrix<double, 10, 1>;

  static Packed pack(const ContactLine &line, const Eigen::VectorXd &normal_displacement)
  {
    Packed packed;
    packed << line.azimuth, line.position.reshaped(), penetration(line, normal_displacement);
    return packed;
  }

  LoadedLine(const Packed &packed, const std::function<double(double)> &pressure)
      : azimuth(packed(0))
      , positions(packed.segment<6>(1).reshaped(3, 2))
      , depth(packed.tail<3>())
      , pressure(pressure)
  {
  }

  const double azimuth;

  PressurePoint at(double xi) const
  {
    const Eigen::Vector3d shape = line_shape(xi);
    const Eigen::RowVector2d position = shape.transpose() * positions;
    return { position.norm(), wrapped(std::atan2(position(1), position(0))), pressure(shape.dot(depth)) };
  }

  double begin() const { return positions.row(0).norm(); }
  double end() const { return positions.row(2).norm(); }

private:
  const Eigen::Matrix<double, 3, 2> positions; ///< positions of the samples [m]
  const Eigen::Vector3d depth;                 ///< penetrations at the samples [m]
  const std::function<double(double)> &pressure;
};

ContactWidth loaded_range(const std::vector<LoadedLine> &lines)
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
  ContactWidth range = { 1e300, 0 };
  ContactWidth zone = range;
  for (const PressurePoint &point : points)
  {
    zone = { std::min(zone.inner, point.radius), std::max(zone.outer, point.radius) };
    if (point.pressure >= min_share * largest)
      range = { std::min(range.inner, point.radius), std::max(range.outer, point.radius) };
  }
  const double margin = 0.1 * (range.outer - range.inner) + 1e-3 * (zone.outer - zone.inner);
  return { std::max(zone.inner, range.inner - margin), std::min(zone.outer, range.outer + margin) };
}

std::vector<PressurePoint> cut_through(const std::vector<const LoadedLine *> &lines, double azimuth,
                                       const ContactWidth &range)
{
  std::vector<PressurePoint> cut;
  for (unsigned int i = 0; i < n_points_across; ++i)
  {
    const double radius = range.inner + (range.outer - range.inner) * i / (n_points_across - 1);
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

/// Groups @p places, lines or points, by azimuth, up to rounding, in ascending order.
template <typename Place>
std::vector<std::vector<const Place *>> grouped_by_azimuth(const std::vector<Place> &places)
{
  constexpr double tolerance = 1e-7;
  std::vector<const Place *> order;
  for (const Place &place : places)
    order.push_back(&place);
  // The shift maps an azimuth just below 2 pi (by rounding) to 0.
  const auto key = [](const Place *place) { return wrapped(place->azimuth + tolerance / 2); };
  std::sort(order.begin(), order.end(), [&](auto one, auto other) { return key(one) < key(other); });
  std::vector<std::vector<const Place *>> groups;
  for (const Place *place : order)
  {
    if (groups.empty() || key(place) - key(groups.back().front()) > tolerance)
      groups.emplace_back();
    groups.back().push_back(place);
  }
  return groups;
}

/// Returns the distance from the last loaded point to the edge of contact, divided by the spacing of the
/// points. @p last, @p before and @p second are the pressures at the last three loaded points, from the edge
/// inwards. If the pressure has a vertical tangent at the edge (Hertzian line contact), its square is nearly
/// linear there and is extrapolated by a quadratic. Returns std::nullopt if the pressure is closer to linear
/// than its square.
std::optional<double> reach_of_upright_edge(double last, double before, double second)
{
  const auto bend = [](double q0, double q1, double q2) { return std::abs((q2 - 2 * q1 + q0) / (q1 - q0)); };
  const double q0 = last * last, q1 = before * before, q2 = second * second;
  if (!(before > last && second > before && bend(q0, q1, q2) < bend(last, before, second)))
    return std::nullopt;
  const double quadratic = (q2 - 2 * q1 + q0) / 2, linear = q1 - q0 - quadratic;
  const double discriminant = linear * linear - 4 * quadratic * q0;
  if (discriminant < 0)
    return std::nullopt;
  return 2 * q0 / (linear + std::sqrt(discriminant));
}

/// Returns the radius beyond the loaded point @p i of a cut at which the pressure vanishes. The pressure is
/// extrapolated by reach_of_upright_edge() from three equally spaced loaded points, or linearly from two. For
/// a single loaded point, the radius lies half a spacing beyond this point.
double edge_beyond(const std::vector<PressurePoint> &cut, std::size_t i, bool outwards)
{
  if (i == (outwards ? cut.size() - 1 : 0))
    return cut[i].radius;
  const auto at = [&](std::size_t n) -> const PressurePoint & { return cut[outwards ? i - n : i + n]; };
  if (const std::size_t n_before = outwards ? i : cut.size() - 1 - i; n_before >= 2)
  {
    const double spacing = at(0).radius - at(1).radius;
    const auto reach = reach_of_upright_edge(at(0).pressure, at(1).pressure, at(2).pressure);
    if (reach && std::abs(at(1).radius - at(2).radius - spacing) < 1e-3 * std::abs(spacing))
      return at(0).radius + std::min(*reach, 1.) * spacing;
  }
  const double to_next = cut[outwards ? i + 1 : i - 1].radius - cut[i].radius;
  const bool is_first = i == (outwards ? 0 : cut.size() - 1);
  const PressurePoint &before = is_first ? cut[i] : cut[outwards ? i - 1 : i + 1];
  const double decrease = before.pressure - cut[i].pressure;
  const double reach = before.pressure > 0 && decrease > 0
                         ? cut[i].pressure / decrease * (cut[i].radius - before.radius)
                         : to_next / 2;
  return cut[i].radius + (std::abs(reach) < std::abs(to_next) ? reach : to_next);
}

/// Returns the radius inside which the fraction @p share of the load acts (pressure linear between points).
double radius_of_share(const std::vector<PressurePoint> &cut, double share)
{
  const auto density = [&](std::size_t i) { return cut[i].pressure * cut[i].radius; };
  const auto length = [&](std::size_t i) { return cut[i + 1].radius - cut[i].radius; };
  double total = 0;
  for (std::size_t i = 0; i + 1 < cut.size(); ++i)
    total += length(i) * (density(i) + density(i + 1)) / 2;
  double remaining = share * total;
  for (std::size_t i = 0; i + 1 < cut.size(); ++i)
  {
    const double piece = length(i) * (density(i) + density(i + 1)) / 2;
    if (remaining < piece)
    {
      // Solves wanted = start t + rise t^2 / 2 for t in [0, 1], the position in the interval, without
      // cancellation.
      const double start = density(i), rise = density(i + 1) - start, wanted = remaining / length(i);
      return cut[i].radius +
             length(i) * 2 * wanted / (start + std::sqrt(std::max(0., start * start + 2 * rise * wanted)));
    }
    remaining -= piece;
  }
  return cut.back().radius;
}

} // namespace

std::optional<ContactWidth> contact_width(const std::vector<PressurePoint> &cut, bool has_edge)
{
  const auto is_loaded = [](const PressurePoint &point) { return point.pressure > 0; };
  const auto first = std::find_if(cut.begin(), cut.end(), is_loaded);
  if (first == cut.end())
    return std::nullopt;
  constexpr double left_out = 0.005; // fraction of the load outside the width on each side
  if (!has_edge)
    return ContactWidth{ radius_of_share(cut, left_out), radius_of_share(cut, 1 - left_out) };
  const auto last = std::find_if(cut.rbegin(), cut.rend(), is_loaded).base() - 1;
  return ContactWidth{ edge_beyond(cut, static_cast<std::size_t>(first - cut.begin()), false),
                       edge_beyond(cut, static_cast<std::size_t>(last - cut.begin()), true) };
}

PressureMap PressureMap::rotated(double angle) const
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
  std::vector<double> packed;
  for (const ContactLine &line : surface.lines)
  {
    const LoadedLine::Packed numbers = LoadedLine::pack(line, normal_displacement);
    packed.insert(packed.end(), numbers.begin(), numbers.end());
  }
  packed = surface.parts.gather(packed);
  PressureMap pressure_map;
  if (packed.empty())
    return pressure_map;
  std::vector<LoadedLine> lines;
  for (std::size_t i = 0; i < packed.size(); i += LoadedLine::Packed::SizeAtCompileTime)
    lines.emplace_back(LoadedLine::Packed(&packed[i]), pressure);
  pressure_map.is_grid = surface.lines_are_radial;
  if (!surface.lines_are_radial)
  {
    for (const LoadedLine &line : lines)
      pressure_map.cuts.push_back({ line.at(-1), line.at(-0.5), line.at(0), line.at(0.5), line.at(1) });
    sort_by_azimuth(pressure_map);
    return pressure_map;
  }
  const ContactWidth range = loaded_range(lines);
  for (const std::vector<const LoadedLine *> &group : grouped_by_azimuth(lines))
    pressure_map.cuts.push_back(cut_through(group, wrapped(group.front()->azimuth), range));
  return pressure_map;
}

PressureMap pressure_map_of_nodes(const ContactSurface &surface, const Eigen::VectorXd &pressure)
{
  std::vector<double> packed;
  for (unsigned int i = 0; i < surface.n_owned_nodes(); ++i)
    packed.insert(packed.end(),
                  { surface.node_position.row(i).norm(),
                    std::atan2(surface.node_position(i, 1), surface.node_position(i, 0)), pressure(i) });
  packed = surface.parts.gather(packed);
  std::vector<PressurePoint> nodes;
  double largest = 0;
  for (std::size_t i = 0; i < packed.size(); i += 3)
  {
    nodes.push_back({ packed[i], packed[i + 1], packed[i + 2] });
    largest = std::max(largest, packed[i + 2]);
  }
  ContactWidth range = { 1e300, 0 };
  for (const PressurePoint &node : nodes)
    if (node.pressure >= min_share * largest)
      range = { std::min(range.inner, node.radius), std::max(range.outer, node.radius) };
  // The margin makes a contact on a single circle visible.
  const double margin = std::max(0.25 * (range.outer - range.inner), 1e-4 * range.outer);
  PressureMap pressure_map;
  pressure_map.is_grid = !nodes.empty();
  for (const std::vector<const PressurePoint *> &group : grouped_by_azimuth(nodes))
  {
    std::vector<PressurePoint> cut;
    for (const PressurePoint *node : group)
      if (range.inner - margin <= node->radius && node->radius <= range.outer + margin)
        cut.push_back({ node->radius, wrapped(group.front()->azimuth), node->pressure });
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
