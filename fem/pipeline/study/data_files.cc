#include "fem/pipeline/study/data_files.h"

#include "fem/pipeline/base/failures.h"
#include "fem/pipeline/base/numbers.h"
#include "fem/pipeline/base/text_file.h"
#include "fem/pipeline/study/table_file.h"

#include <boost/algorithm/string/trim.hpp>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <memory>
#include <optional>
#include <sstream>
#include <stdexcept>

namespace stemware::pipeline
{

namespace
{

/// Maximum number of harmonics. Computing the torque of 1000 harmonics takes seconds, and the friction
/// kernels of much lower orders are negligible already.
constexpr std::size_t max_harmonics = 1000;

/// Maximum of loads and radii in SI units. Larger values are unit errors and would overflow.
constexpr double largest_number = 1e12;

/// Maximum ratio of a coefficient to a_0. Without tension, the ratio is at most 2.
constexpr double largest_share = 1000;

std::optional<double> ring_radius_in(const std::string &setting, const std::string &text)
{
  const std::string key = "# ring radius:";
  std::optional<double> radius;
  std::istringstream lines(text);
  std::string line;
  for (unsigned int number = 1; std::getline(lines, line); ++number)
  {
    boost::trim(line);
    const auto end = line.rfind("(m)");
    if (line.rfind(key, 0) != 0 || end == std::string::npos)
      continue;
    const std::string where = fmt::format(FMT_STRING("{}, line {}: "), setting, number);
    ensure(!radius, where + "the ring radius is given a second time; leave one of them.");
    radius = parse_number(line.substr(key.size(), end - key.size()));
    ensure(radius && *radius > 0 && *radius < largest_number,
           where + "\"" + shortened(line) + "\" gives no radius; write \"# ring radius: 0.03 (m)\".");
  }
  return radius;
}

std::string profile_entry(const std::string &file)
{
  return "Glass/Profile file = " + shortened_path(file);
}

/// Returns the points of a section [m]. Throws BadInput for coordinates of 1 m or more, probably given in mm.
std::vector<fem::SectionVertex> points_in(const std::string &file)
{
  std::vector<fem::SectionVertex> points;
  for (const auto &row : parse_columns(profile_entry(file), read_input_text(profile_entry(file), file),
                                       { { { "r", "radius" }, "m" }, { { "z", "height" }, "m" } }))
  {
    const double r = row.cells[0], z = row.cells[1];
    ensure(std::abs(r) < 1 && std::abs(z) < 1,
           fmt::format(FMT_STRING("{}, line {}: r = {} m, z = {} m is larger than any glass; these look like "
                                  "millimetres: write \"r (mm), z (mm)\" as the first line."),
                       profile_entry(file), row.line, to_short_text(r), to_short_text(z)));
    points.push_back({ r, z, row.line });
  }
  return points;
}

/// Returns the mean of the radii of the first and the last of the lowest points.
double lowest_radius(const std::vector<fem::SectionVertex> &points)
{
  const auto is_lower = [](const auto &a, const auto &b) { return a.height < b.height; };
  return (std::min_element(points.begin(), points.end(), is_lower)->radius +
          std::min_element(points.rbegin(), points.rend(), is_lower)->radius) /
         2;
}

void fit_rim(const std::vector<fem::SectionVertex> &points, Study &study)
{
  fem::GlassProfile &profile = study.glass.profile;
  const auto circle = fem::fit_rim_circle(points, profile.land_width);
  const auto is_given = [&](const char *entry, double value, const double fem::RimCircle::*fitted)
  {
    const bool is_fitted = circle && std::abs(value - (*circle).*fitted) <= 1e-12 * std::abs(value);
    return study.given_entries.count(entry) > 0 && !is_fitted;
  };
  const bool has_radius =
    is_given("Glass/Contact radius", profile.contact_radius, &fem::RimCircle::contact_radius);
  const bool has_crown = is_given("Glass/Crown radius", profile.crown_radius, &fem::RimCircle::crown_radius);
  ensure(circle || has_crown,
         profile_entry(study.glass.profile_file) +
           ": no circle fits the points within half of Glass/Land width = " + to_text(profile.land_width) +
           " m of the lowest one; draw at least three points of the rounded rim "
           "there, or give Glass/Crown radius (0 for a flat land).");
  if (!has_radius)
    profile.contact_radius = circle ? circle->contact_radius : lowest_radius(points);
  if (!has_crown)
    profile.crown_radius = circle->crown_radius;
  if (!has_radius || !has_crown)
    study.glass.rim_circle = circle;
}

} // namespace

ring::OrbitSpeedTable read_orbit_speed_file(const std::string &file)
{
  const std::string setting = "Motion/Orbit speed file = " + shortened_path(file);
  std::vector<double> times, speeds;
  for (const auto &row : parse_columns(setting, read_input_text(setting, file),
                                       { { { "t", "time" }, "s" }, { { "v", "speed", "velocity" }, "m/s" } }))
  {
    const std::string place = fmt::format(FMT_STRING("{}, line {}: "), setting, row.line);
    ensure(row.cells[1] > 0 || (row.cells[1] == 0 && (speeds.empty() || speeds.back() == 0)),
           place + "the speed is not greater than 0, which it may be at the beginning only; end the table "
                   "before the hand stops.");
    ensure(times.empty() || row.cells[0] > times.back(),
           place + "the time is not later than in the row before; sort the rows by time.");
    times.push_back(row.cells[0]);
    speeds.push_back(row.cells[1]);
  }
  ensure(times.size() >= 2, setting + " has one row; give at least two.");
  try
  {
    return { times, speeds };
  }
  catch (const std::invalid_argument &error)
  {
    throw BadInput(setting + ": " + error.what() + ".");
  }
}

ring::RingStack read_load_file(const std::string &file)
{
  const std::string setting = "Load/File = " + shortened_path(file);
  const std::string text = read_input_text(setting, file);
  const std::optional<double> radius = ring_radius_in(setting, text);
  const TextTable table = parse_table(setting, text, true);
  std::vector<double> all_a, all_b;
  for (const auto &row : table.rows)
  {
    const std::string where = fmt::format(FMT_STRING("{}, line {}: "), setting, row.line);
    ensure(all_a.size() <= max_harmonics,
           fmt::format(FMT_STRING("{} has more than {} harmonics, the most that a torque is computed from; "
                                  "remove the higher harmonics."),
                       setting, max_harmonics));
    std::vector<std::string> cells = row.cells;
    cells.resize(std::max<std::size_t>(cells.size(), 3));
    const auto n = parse_count(cells[0]);
    const auto a = parse_number(table.with_point(cells[1])), b = parse_number(table.with_point(cells[2]));
    ensure(n && a && b && *n == all_a.size() && (*n > 0 || (*a > 0 && *b == 0)),
           fmt::format(FMT_STRING("{}expected \"{} a b\" with finite numbers in N/rad{}."), where,
                       all_a.size(), all_a.empty() ? ", a greater than 0 and b = 0" : ""));
    all_a.push_back(*a);
    all_b.push_back(*b);
    const double size = std::max(std::abs(*a), std::abs(*b));
    ensure(size <= std::min(largest_number, largest_share * all_a.front()),
           fmt::format(FMT_STRING("{}a coefficient of {} N/rad beside a_0 = {} N/rad is no load of a table; "
                                  "give all in N/rad, none larger than 1000 a_0 and 1e12."),
                       where, to_short_text(size), to_short_text(all_a.front())));
  }
  ensure(radius.has_value(),
         setting + " does not say how large the ring is; add a line \"# ring radius: 0.03 (m)\".");
  ensure(all_a.size() >= 2,
         setting + " holds no first harmonic; give at least the rows \"0 a b\" and \"1 a b\".");
  return { all_a, all_b, *radius };
}

void attach_profile(Study &study)
{
  fem::GlassProfile &profile = study.glass.profile;
  profile.section.reset();
  study.glass.rim_circle.reset();
  if (profile.shape != fem::GlassShape::profile)
    return;
  const std::string &file = study.glass.profile_file;
  ensure(!file.empty(), "Glass/Shape = profile needs Glass/Profile file; name a file with the points (r, z) "
                        "of the foot's section.");
  const std::vector<fem::SectionVertex> points = points_in(file);
  try
  {
    profile.section = std::make_shared<fem::MeridianSection>(points);
  }
  catch (const std::invalid_argument &error)
  {
    throw BadInput(profile_entry(file) + ": " + error.what());
  }
  study.glass.n_profile_points = static_cast<unsigned int>(points.size());
  fit_rim(points, study);
}

std::string profile_note(const GlassSection &glass)
{
  if (!glass.profile.section)
    return "";
  const std::string note =
    fmt::format(FMT_STRING("{} points; contact radius {:.6g} m, crown radius {:.6g} m"),
                glass.n_profile_points, glass.profile.contact_radius, glass.profile.crown_radius);
  const fem::RimCircle circle = glass.rim_circle.value_or(fem::RimCircle());
  return circle.n_points == 0
           ? note
           : note + fmt::format(FMT_STRING(", from a circle through {} points of the land ({:.2g} µm rms)"),
                                circle.n_points, 1e6 * circle.rms_distance);
}

} // namespace stemware::pipeline
