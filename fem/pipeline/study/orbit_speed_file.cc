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
