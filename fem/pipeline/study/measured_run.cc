#include "fem/pipeline/study/measured_run.h"

#include "fem/pipeline/study/column_table.h"
#include "fem/pipeline/study/table_file.h"
#include "fem/pipeline/support/failures.h"
#include "fem/pipeline/support/numbers.h"

#include <boost/algorithm/string/case_conv.hpp>

#include <cmath>

namespace stemware::pipeline
{

namespace
{

const FileColumn time_column = { { "t", "time", "zeit", "t_s" }, "s" };
const std::vector<std::string> spin_names = {
  "omega",      "spin",         "ω", "gyroscope z", "gyroscope z-axis", "angular velocity", "wz",
  "gyroskop z", "rotation rate"
};
const std::vector<std::string> angle_names = { "angle", "θ",         "θr",       "θ_r", "theta",
                                               "yaw",   "yaw angle", "rotation", "ψ",   "psi" };

/// No glass spins faster [rad/s]: a rim that is led at 1 m/s on a radius of 2 cm rolls at 50 rad/s.
constexpr double largest_spin_without_unit = 50;

} // namespace

MeasuredRun parse_measured_run(const std::string &setting, const std::string &text, const std::string &column)
{
  const std::vector<std::string> own = { boost::to_lower_copy(as_typed(parse_heading(column).name)) };
  const std::vector<FileColumn> with_spin = { time_column, { column.empty() ? spin_names : own, "rad/s" } },
                                with_angle = { time_column, { column.empty() ? angle_names : own, "rad" } };
  MeasuredRun run;
  run.is_angle = !has_columns(setting, text, with_spin) && has_columns(setting, text, with_angle);
  ensure(column.empty() || run.is_angle || has_columns(setting, text, with_spin),
         setting + " has no column \"" + shortened(column) +
           "\" of spins or angles beside a column t; write its heading into Motion/Measured column.");
  const std::vector<FileColumn> &columns = run.is_angle ? with_angle : with_spin;
  ColumnTable table;
  try
  {
    table = parse_columns(setting, text, columns, MissingValues::skipped);
  }
  catch (const BadInput &failure)
  {
    const bool is_named = run.is_angle || has_columns(setting, text, with_spin);
    throw BadInput(failure.what() +
                   std::string(is_named ? "" : " Another heading can be named by Motion/Measured column."));
  }
  std::size_t n_equal = 0;
  unsigned int equal_line = 0;
  for (const FileRow &row : table.rows)
  {
    const std::string place = setting + ", line " + std::to_string(row.line) + ": ";
    const double time = row.values[0], before = run.times.empty() ? time : run.times.back();
    ensure(time >= before, place + "the time " + to_short_text(time) + " s is earlier than " +
                             to_short_text(before) +
                             " s in the row before; sort the rows by time, and write nothing between "
                             "thousands.");
    ensure(run.is_angle || !table.units[1].empty() || std::abs(row.values[1]) <= largest_spin_without_unit,
           place + "omega = " + to_short_text(row.values[1]) +
             " rad/s is faster than any glass spins; it looks like degrees per second: name the unit in the "
             "heading, \"omega (deg/s)\".");
    ensure(!run.is_angle || !table.units[1].empty(),
           setting +
             ": the angles have no unit; name it in the heading, \"angle (deg)\" or \"angle (rad)\".");
    if (!run.times.empty() && time == before && ++n_equal == 1)
      equal_line = row.line;
    run.times.push_back(time);
    run.values.push_back(row.values[1]);
  }
  run.summary = table.summary(columns);
  if (n_equal > 0)
    run.summary += ", " + std::to_string(n_equal) + " with the time of the row before (line " +
                   std::to_string(equal_line) + ")";
  return run;
}

std::vector<MeasuredSpin> spins_of(const MeasuredRun &run)
{
  std::vector<MeasuredSpin> spins;
  for (std::size_t i = 0; i < run.times.size(); ++i)
    if (!run.is_angle)
      spins.push_back({ run.times[i], run.values[i] });
    else if (i > 0 && run.times[i] > run.times[i - 1])
      spins.push_back({ (run.times[i] + run.times[i - 1]) / 2,
                        (run.values[i] - run.values[i - 1]) / (run.times[i] - run.times[i - 1]) });
  return spins;
}

} // namespace stemware::pipeline
