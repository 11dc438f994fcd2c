#include "fem/pipeline/study/data_files.h"

#include "fem/pipeline/study/quantity_text.h"
#include "fem/pipeline/support/failures.h"
#include "fem/pipeline/support/numbers.h"
#include "fem/pipeline/support/text_file.h"

#include <boost/algorithm/string/case_conv.hpp>
#include <boost/algorithm/string/classification.hpp>
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

/// The unit behind the column's name in any case, "r (mm)", "R [mm]" or "r mm", in units of SI.
std::optional<double> unit_in(const std::string &cell, const FileColumn &column)
{
  const auto end = std::min(cell.find_first_of(" (["), cell.size());
  if (std::find(column.names.begin(), column.names.end(), boost::to_lower_copy(cell.substr(0, end))) ==
      column.names.end())
    return std::nullopt;
  return parse_quantity("1 " + boost::trim_copy_if(cell.substr(end), boost::is_any_of(" ()[]")), column.unit);
}

/// The torque of all of them takes seconds; its kernels have fallen to nothing long before.
constexpr std::size_t most_harmonics = 1000;

/// Larger loads and rings are slips of units, and overflow.
constexpr double largest_number = 1e12;

/// How much larger than a_0 a coefficient may be: a load that pulls nowhere has none above 2.
constexpr double largest_share = 1000;

/// The radius that a comment of a load file states; nothing for other comments.
std::optional<double> ring_radius_in(const std::string &where, const std::string &comment)
{
  const std::string key = "# ring radius:";
  const auto end = comment.rfind("(m)");
  if (comment.rfind(key, 0) != 0 || end == std::string::npos)
    return std::nullopt;
  const auto radius = parse_number(comment.substr(key.size(), end - key.size()));
  require(radius && *radius > 0 && *radius < largest_number,
          where + "\"" + shortened(comment) + "\" gives no radius; write \"# ring radius: 0.03 (m)\".");
  return radius;
}

} // namespace

TextTable read_table(const std::string &setting, const std::string &file, bool blanks_separate)
{
  return parse_table(setting, read_input_text(setting, file), blanks_separate);
}

std::vector<FileRow> read_column_file(const std::string &setting, const std::string &file,
                                      const std::vector<FileColumn> &columns)
{
  std::vector<std::string> names, header;
  for (const FileColumn &column : columns)
  {
    names.push_back(column.names.front());
    header.push_back(fmt::format(FMT_STRING("{} ({})"), names.back(), usual_units(column.unit).front()));
  }
  const TextTable table = read_table(setting, file, true);
  std::vector<double> units(columns.size(), 1.);
  std::vector<FileRow> rows;
  for (const TableRow &row : table.rows)
  {
    require(row.cells.size() == columns.size(),
            fmt::format(FMT_STRING("{}, line {}: the row has {}, but there are {} columns; write {} numbers, "
                                   "{}, in SI units or in those of a first line \"{}\"."),
                        setting, row.line,
                        row.cells.size() == 1 ? "1 cell" : fmt::format("{} cells", row.cells.size()),
                        columns.size(), columns.size(), fmt::join(names, ", "), fmt::join(header, ", ")));
    std::vector<double> numbers, given_units;
    std::size_t bad = columns.size();
    for (std::size_t i = 0; i < columns.size(); ++i)
      if (const auto number = parse_number(table.with_point(row.cells[i])))
        numbers.push_back(*number * units[i]);
      else
      {
        bad = std::min(bad, i);
        if (const auto unit = unit_in(row.cells[i], columns[i]); unit && &row == &table.rows.front())
          given_units.push_back(*unit);
      }
    if (given_units.size() == columns.size())
      units = given_units;
    else if (&row == &table.rows.front() && numbers.empty())
      throw BadInput(fmt::format(FMT_STRING("{}, line {}: the header \"{}\" does not name the columns {} "
                                            "with units of theirs; write \"{}\", or leave the header out."),
                                 setting, row.line, shortened(fmt::format("{}", fmt::join(row.cells, ", "))),
                                 fmt::join(names, ", "), fmt::join(header, ", ")));
    else if (numbers.size() == columns.size())
      rows.push_back({ numbers, row.line });
    else
      throw BadInput(place_in_table(setting, row, bad) +
                     fmt::format(FMT_STRING("\"{}\" is not a number; write {} numbers, {}, in SI units or in "
                                            "those of a first line \"{}\"."),
                                 shortened(row.cells[bad]), columns.size(), fmt::join(names, ", "),
                                 fmt::join(header, ", ")));
  }
  require(!rows.empty(), fmt::format(FMT_STRING("{} has no rows; write {} numbers a line, {}."), setting,
                                     columns.size(), fmt::join(names, ", ")));
  return rows;
}

std::vector<MeasuredSpin> read_measured_spin_file(const std::string &file)
{
  std::vector<MeasuredSpin> points;
  for (const FileRow &row :
       read_column_file("Motion/Measured spin file = " + shortened_path(file), file,
                        { { { "t", "time" }, "s" }, { { "omega", "spin", "ω" }, "rad/s" } }))
    points.push_back({ row.values[0], row.values[1] });
  return points;
}

ring::OrbitSpeedTable read_orbit_speed_file(const std::string &file)
{
  const std::string setting = "Motion/Orbit speed file = " + shortened_path(file);
  std::vector<double> times, speeds;
  for (const FileRow &row :
       read_column_file(setting, file, { { { "t", "time" }, "s" }, { { "v", "speed" }, "m/s" } }))
  {
    const std::string place = fmt::format(FMT_STRING("{}, line {}: "), setting, row.line);
    require(row.values[1] > 0,
            place + "the speed is not greater than 0; the direction of friction needs one.");
    require(times.empty() || row.values[0] > times.back(),
            place + "the time is not later than in the row before; sort the rows by time.");
    times.push_back(row.values[0]);
    speeds.push_back(row.values[1]);
  }
  require(times.size() >= 2, setting + " has one row; give at least two.");
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
  std::vector<double> all_a, all_b;
  std::optional<double> radius;
  for (const TextLine &line : read_lines(setting, file))
  {
    const std::string where = fmt::format(FMT_STRING("{}, line {}: "), setting, line.number);
    if (line.text.front() == '#')
    {
      const auto stated = ring_radius_in(where, line.text);
      require(!radius || !stated, where + "the ring radius is given a second time; leave one of them.");
      radius = radius ? radius : stated;
      continue;
    }
    require(
      all_a.size() <= most_harmonics,
      fmt::format(
        FMT_STRING(
          "{} holds more than the {} harmonics that a torque is computed from; leave the higher ones out."),
        setting, most_harmonics));
    std::istringstream words(line.text);
    std::string n_text, a_text, b_text;
    words >> n_text >> a_text >> b_text;
    const auto n = parse_count(n_text);
    const auto a = parse_number(a_text), b = parse_number(b_text);
    require(n && a && b && *n == all_a.size() && (*n > 0 || (*a > 0 && *b == 0)),
            fmt::format(FMT_STRING("{}expected \"{} a b\" with finite numbers in N/rad{}."), where,
                        all_a.size(), all_a.empty() ? ", a greater than 0 and b = 0" : ""));
    all_a.push_back(*a);
    all_b.push_back(*b);
    const double size = std::max(std::abs(*a), std::abs(*b));
    require(size <= std::min(largest_number, largest_share * all_a.front()),
            fmt::format(FMT_STRING("{}a coefficient of {} N/rad beside a_0 = {} N/rad is no load of a table; "
                                   "give all in N/rad, none larger than 1000 a_0 and 1e12."),
                        where, to_short_text(size), to_short_text(all_a.front())));
  }
  require(radius.has_value(),
          setting + " does not say how large the ring is; add a line \"# ring radius: 0.03 (m)\".");
  require(all_a.size() >= 2,
          setting + " holds no first harmonic; give at least the rows \"0 a b\" and \"1 a b\".");
  return { all_a, all_b, *radius };
}

} // namespace stemware::pipeline
