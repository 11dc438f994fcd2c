#pragma once

#include "fem/pipeline/coupling/contact_report.h"
#include "fem/pipeline/result/results.h"
#include "fem/pipeline/study/study.h"
#include "ring_model/spin/answer.h"
#include "ring_model/spin/torque_effect.h"

#include <vector>

namespace stemware::pipeline
{

/// Returns the results of `truncate`: @p rows are rows_by_harmonics(), the last with a terminal spin; @p load
/// is the study's load at rest, @p effects the effects of its harmonics on tau_z.
Results make_truncation_document(const Study &study, const LoadReport &load,
                                 const std::vector<ring::Answer> &rows, const ring::TorqueEffects &effects);

/// Returns the JSON Schema of the summary of `truncate`.
Json truncate_schema();

} // namespace stemware::pipeline
