#include "fem/pipeline/study/data_files.h"

#include "fem/pipeline/base/failures.h"
#include "fem/pipeline/base/numbers.h"
#include "fem/pipeline/base/text_file.h"
#include "fem/pipeline/study/column_table.h"
#include "fem/pipeline/study/quantity_text.h"

#include <boost/algorithm/string/trim.hpp>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
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

} // namespace stemware::pipeline
