#pragma once

#include "fem/pipeline/analysis/refinement/goal_mesh.h"
#include "fem/pipeline/analysis/refinement/quantities_of_interest.h"
#include "fem/pipeline/analysis/spin_study.h"
#include "fem/pipeline/coupling/contact_report.h"
#include "fem/pipeline/report/results.h"

#include <optional>
#include <vector>

namespace stemware::pipeline
{

/// The results of `run`: load, contact, torque, spin-up, truncations and moment balances. @p bands are empty
/// where they have not been estimated; @p goal is what the mesh was made for, if anything. The fields are
/// left to the caller, who need not copy them.
Results make_document(const Study &study, const ContactReport &report, const SpinStudy &spin,
                      const std::vector<BandedQuantity> &bands, const std::optional<GoalOutcome> &goal = {});

/// The part of the band of the study's goal that is the mesh's; nothing where there is none.
std::optional<double> band_of_mesh(const Study &study, const ErrorBands &bands);

} // namespace stemware::pipeline
