#include "fem/pipeline/study/measured_spin_file.h"

#include "fem/pipeline/study/column_file.h"
#include "fem/pipeline/support/failures.h"

namespace stemware::pipeline
{

std::vector<MeasuredSpin> read_measured_spin_file(const std::string &file)
{
  const std::string setting = "Motion/Measured spin file = " + shortened_path(file);
  std::vector<MeasuredSpin> points;
  for (const FileRow &row :
       read_column_file(setting, file, { { { "t", "time" }, "s" }, { { "omega", "spin", "ω" }, "rad/s" } }))
    points.push_back({ row.values[0], row.values[1] });
  require(!points.empty(), setting + " has no rows; give at least one.");
  return points;
}

} // namespace stemware::pipeline
