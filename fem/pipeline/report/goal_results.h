#pragma once

#include "fem/pipeline/analysis/refinement/goal_mesh.h"
#include "fem/pipeline/analysis/refinement/quantities_of_interest.h"
#include "fem/pipeline/coupling/contact_report.h"

#include <nlohmann/json.hpp>

#include <optional>

/// Results about a study whose foot has a mesh for its goal.
namespace stemware::pipeline
{

/// "goal" of summary.json: the number, what is estimated to be missing to it, the part of its band (@p bands)
/// that is the mesh's, null without one, and the mesh.
nlohmann::ordered_json goal_summary(const Study &study, const GoalOutcome &goal, const FootReport &foot,
                                    const ErrorBands &bands);

/// The part of the band of the study's goal that is the mesh's; nothing where there is none.
std::optional<double> band_of_mesh(const Study &study, const ErrorBands &bands);

} // namespace stemware::pipeline
