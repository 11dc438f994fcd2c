#pragma once

#include "fem/pipeline/analysis/quantities_of_interest.h"
#include "fem/pipeline/analysis/solve.h"
#include "fem/pipeline/analysis/study_rows.h"
#include "ring_model/spin/answer.h"

#include <optional>
#include <vector>

namespace stemware::pipeline
{

/// Returns the error bands of a study from a few additional contacts: each numerical parameter is changed by
/// itself, and the change is one of the parts that the band sums (docs/method/error_bands.md). Quantities:
/// load and table motion at rest; torque at rest and at 0.5 and 1.5 times the terminal spin;
/// terminal spin and time constant; effect of the harmonics beyond the first. With waviness, and if the load
/// depends on the direction of the moment, torques are means over four phases of the period of a glass that
/// spins up.
///
/// @p all: row of all harmonics; @p first: terminal spin of the first harmonic only, if any; @p reported:
/// known values, which replace computed ones (equal up to the solver's tolerance). A quantity without a value
/// after a change has no band. Returns an empty list for a load without a contact, if a changed contact
/// fails, or if no other mesh is informative; the executor's progress receives the reason. Collective if the
/// body is.
ErrorBands estimate_bands(const Analysis &analysis, const ring::Answer &all,
                          const std::optional<double> &first,
                          const std::vector<QuantityOfInterest> &reported = {});

/// Returns the quantities whose values the results of a study state: of the load @p at_rest, and the torque
/// at half the terminal spin in the last of the @p rows by harmonics.
std::vector<QuantityOfInterest> reported_quantities(const LoadReport &at_rest, const StudyRows &rows);

} // namespace stemware::pipeline
