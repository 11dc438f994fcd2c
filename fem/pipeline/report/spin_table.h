#pragma once

#include "fem/pipeline/analysis/spin_row.h"
#include "fem/pipeline/report/render/table.h"

#include <vector>

namespace stemware::pipeline
{

/// All numbers of the rows of run, truncate and compare, of which each shows some; the columns are those of
/// quantities.h. Torques at @p omega [rad/s] make the column "torque[]". People read 0 where a change of spin
/// is below 1e-11 and a torque below 1e-12 of the last row's at rest.
Table spin_table(const std::vector<SpinRow> &rows, const std::vector<double> &omega = {});

} // namespace stemware::pipeline
