#include "fem/pipeline/study/orbit_speed_file.h"

#include "fem/pipeline/study/column_file.h"
#include "fem/pipeline/study/study.h"
#include "fem/pipeline/support/failures.h"
#include "fem/pipeline/support/numbers.h"

#include <fmt/format.h>
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

} // namespace

ring::OrbitSpeedTable read_orbit_speed_file(const std::string &file)
{
  std::vector<double> times, speeds;
  for (const FileRow &row :
       read_column_file(speed_entry(file), file, { { { "t", "time" }, "s" }, { { "v", "speed" }, "m/s" } }))
  {
    const std::string place = fmt::format(FMT_STRING("{}, line {}: "), speed_entry(file), row.line);
    require(row.values[1] > 0,
            place + "the speed is not greater than 0; the direction of friction needs one.");
    require(times.empty() || row.values[0] > times.back(),
            place + "the time is not later than in the row before; sort the rows by time.");
    times.push_back(row.values[0]);
    speeds.push_back(row.values[1]);
  }
  require(times.size() >= 2, speed_entry(file) + " has one row; give at least two.");
  try
  {
    return { times, speeds };
  }
  catch (const std::invalid_argument &error)
  {
    throw BadInput(speed_entry(file) + ": " + error.what() + ".");
  }
}

void attach_orbit_speeds(Study &study)
{
  const std::string &file = study.motion.orbit_speed_file;
  study.motion.orbit_speeds.reset();
  if (!file.empty())
    study.motion.orbit_speeds = std::make_shared<const ring::OrbitSpeedTable>(read_orbit_speed_file(file));
}

} // namespace stemware::pipeline
