#include "fem/pipeline/study/orbit_speed_file.h"

#include "fem/pipeline/study/quantity_text.h"
#include "fem/pipeline/study/study.h"
#include "fem/pipeline/support/failures.h"
#include "fem/pipeline/support/numbers.h"

#include <boost/algorithm/string/classification.hpp>
#include <boost/algorithm/string/split.hpp>
#include <boost/algorithm/string/trim.hpp>

#include <fmt/format.h>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <vector>

namespace stemware::pipeline
{

namespace
{

std::string speed_entry(const std::string &file)
{
  return "Motion/Orbit speed file = " + shortened_path(file);
}

/// The columns of a line.
std::vector<std::string> columns_of(const std::string &line)
{
  std::vector<std::string> columns;
  boost::split(columns, line, boost::is_any_of(",;\t"));
  for (std::string &column : columns)
    boost::trim(column);
  return columns;
}

/// The unit in brackets of "t (s)" as a factor to @p unit; nothing where there is none of that kind.
std::optional<double> factor_in(const std::string &column, const std::string &unit)
{
  const auto begin = column.find_first_of("(["), end = column.find_last_of(")]");
  if (begin == std::string::npos || end == std::string::npos || end <= begin + 1)
    return std::nullopt;
  return parse_quantity("1 " + column.substr(begin + 1, end - begin - 1), unit);
}

} // namespace

ring::OrbitSpeedTable read_orbit_speed_file(const std::string &file)
{
  constexpr std::size_t most_rows = 100000;
  std::ifstream stream(file);
  require(static_cast<bool>(stream), speed_entry(file) + " cannot be read; check its path and permissions.");
  std::vector<double> times, speeds;
  std::optional<double> seconds, metres_per_second;
  std::string line;
  for (unsigned int number = 1; std::getline(stream, line); ++number)
  {
    boost::trim(line);
    if (line.empty() || line.front() == '#')
      continue;
    const std::vector<std::string> columns = columns_of(line);
    const std::string place =
      fmt::format(FMT_STRING("{}, line {}: \"{}\""), speed_entry(file), number, shortened(line));
    if (!seconds)
    {
      require(columns.size() == 2, place + " is no header; begin with \"t (s), v (m/s)\".");
      seconds = factor_in(columns[0], "s");
      metres_per_second = factor_in(columns[1], "m/s");
      require(seconds && metres_per_second,
              place + " does not name a time and a speed with their units; begin with \"t (s), v (m/s)\".");
      continue;
    }
    const auto time = columns.size() == 2 ? parse_number(columns[0]) : std::nullopt;
    const auto speed = columns.size() == 2 ? parse_number(columns[1]) : std::nullopt;
    require(time && speed, place + " is not a row; write a time and a speed with a comma between them.");
    require(*speed > 0,
            place + " has a speed that is not greater than 0; the direction of friction needs one.");
    require(times.empty() || *seconds * *time > times.back(),
            place + " is not later than the row before; sort the rows by time.");
    require(times.size() < most_rows, fmt::format(FMT_STRING("{} has more than {} rows; leave some out."),
                                                  speed_entry(file), most_rows));
    times.push_back(*seconds * *time);
    speeds.push_back(*metres_per_second * *speed);
  }
  require(times.size() >= 2, speed_entry(file) +
                               " has fewer than two rows; write a header \"t (s), v (m/s)\" and at "
                               "least two rows.");
  try
  {
    return { times, speeds };
  }
  catch (const std::invalid_argument &error)
  {
    throw BadInput(speed_entry(file) + ": " + error.what() + ".");
  }
}

void check_orbit_speed_file(const Study &study)
{
  const std::string &file = study.motion.orbit_speed_file;
  if (file.empty())
    return;
  const ring::OrbitSpeedTable table = read_orbit_speed_file(file);
  for (const double time : { 0., study.motion.end_time })
    try
    {
      table.speed(time);
    }
    catch (const std::out_of_range &)
    {
      throw BadInput(
        fmt::format(FMT_STRING("{} does not reach t = {} s; give speeds from 0 to Motion/End time = {} s."),
                    speed_entry(file), to_text(time), to_text(study.motion.end_time)));
    }
  const std::string needs = speed_entry(file) + " needs ";
  require(!study.load.is_static() && study.load.source != LoadSource::file &&
            study.load.coupling == LoadCoupling::two_way,
          needs +
            "a load in balance at every speed; set Load/Coupling = two-way, and no given moment or load.");
  require(study.motion.orbit.has_constant_friction(),
          needs + "friction with one coefficient; set Motion/Friction law = Coulomb.");
  require(!study.load.is_from_contact() || !abilities(study.contact.body).is_collective,
          needs + "a body of revolution; set Contact/Body = revolution.");
  require(!study.has_waviness(), needs + "a flat rim on a flat table; leave Glass/Rim waviness and "
                                         "Table/Waviness empty.");
}

} // namespace stemware::pipeline
