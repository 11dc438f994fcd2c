#pragma once

#include "fem/pipeline/analysis/truncation.h"
#include "fem/pipeline/coupling/contact_report.h"
#include "fem/pipeline/output/results.h"

#include <vector>

namespace stemware::pipeline
{

/// The results of `truncate`: what is left of the answer with fewer harmonics, truncated afterwards and in
/// the loop of contact, friction and moment balance. @p load is the study's at rest.
Results truncation_results(const Study &study, const LoadReport &load, const TruncationStudy &truncations);

/// All numbers of one way of truncating by the number of harmonics, with the torques at @p omega [rad/s].
Table truncation_table(const TruncationTable &truncations, const std::vector<double> &omega);

/// omega(t) by the number of harmonics; truncations without a spin-up are left out.
Table spin_up_table(const std::vector<double> &time, const TruncationTable &truncations);

} // namespace stemware::pipeline
