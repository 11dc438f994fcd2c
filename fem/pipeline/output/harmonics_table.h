#pragma once

#include "fem/pipeline/output/render/report.h"
#include "ring_model/ring_stack.h"

namespace stemware::pipeline
{

/// The first harmonics of a load over its mean, for a report.
ReportTable harmonics_table(const ring::RingStack &load);

} // namespace stemware::pipeline
