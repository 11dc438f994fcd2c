#pragma once

#include "fem/pipeline/coupling/contact_report.h"
#include "fem/pipeline/report/results.h"
#include "fem/pipeline/study/study.h"
#include "ring_model/spin/answer.h"

#include <vector>

namespace stemware::pipeline
{

/// The results of `truncate`: @p rows are rows_by_harmonics(), with a terminal spin in the last one; @p load
/// is the study's at rest.
Results make_truncation_document(const Study &study, const LoadReport &load,
                                 const std::vector<ring::Answer> &rows);

} // namespace stemware::pipeline
