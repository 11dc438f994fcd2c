#pragma once

#include "fem/pipeline/analysis/refinement/goal_mesh.h"
#include "fem/pipeline/analysis/refinement/quantities_of_interest.h"
#include "fem/pipeline/analysis/spin_study.h"
#include "fem/pipeline/coupling/contact_report.h"
#include "fem/pipeline/report/results.h"

#include <vector>

namespace stemware::pipeline
{

/// The results of `run`: load, contact, torque, spin-up, truncations and moment balances. @p bands are empty
/// where they have not been estimated; @p goal is what the mesh was made for, if anything.
Results tabulate(const Study &study, const ContactReport &report, const SpinStudy &spin,
                 const std::vector<BandedQuantity> &bands, const std::optional<GoalOutcome> &goal = {});

/// Results that a rank other than the first adds: the fields of its own cells.
Results own_fields(const ContactReport &report);

} // namespace stemware::pipeline
