#pragma once

#include "fem/pipeline/analysis/goal_mesh.h"
#include "fem/pipeline/analysis/quantities_of_interest.h"
#include "fem/pipeline/analysis/spin_study.h"
#include "fem/pipeline/coupling/contact_report.h"
#include "fem/pipeline/result/results.h"

#include <optional>
#include <vector>

namespace stemware::pipeline
{

/// Returns the results of `run`: load, contact, torque, spin-up, truncations and moment balances. @p bands
/// are empty if not estimated; @p goal: goal of the mesh, if any. The caller adds the fields, to avoid a
/// copy.
Results make_document(const Study &study, const ContactReport &report, const SpinStudy &spin,
                      const std::vector<BandedQuantity> &bands, const std::optional<GoalOutcome> &goal = {});

/// Returns the JSON Schema of the summary of `run`.
Json run_schema();

/// Returns the mesh's part of the band of the study's goal; std::nullopt without a goal or band.
std::optional<double> band_of_mesh(const Study &study, const ErrorBands &bands);

} // namespace stemware::pipeline
