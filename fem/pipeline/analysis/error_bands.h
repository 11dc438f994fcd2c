#pragma once

#include "fem/pipeline/analysis/budget.h"
#include "fem/pipeline/analysis/quantities_of_interest.h"
#include "fem/pipeline/analysis/solve.h"
#include "ring_model/spin/answer.h"

#include <memory>
#include <optional>
#include <vector>

namespace stemware::pipeline
{

/// Returns the error bands of a study from a few additional contacts: each numerical parameter is changed
/// once, by itself, and the resulting change is the part of the band with the parameter's name
/// (docs/method/error_bands.md):
///
///   mesh            cells twice as large (in the contact only, if its cells are smaller; then also half as
///                   large outside); for a solid foot half as large if larger cells are not possible
///   degree          elements of one degree more (on a hard table with cells twice as large); for a solid
///                   foot if they are linear
///   harmonics       half the elastic harmonics; not for a solid foot
///   lines           four and three times the azimuth lines, for a solid foot the lines of each face; nothing
///                   in full contact, unless the mesh is from a file
///   interface       ten times the penalty of a hard interface
///   load_harmonics  twice the harmonics of the load, half if the lines or cells resolve no more
///   rings           2 n, 2 n + 1 and 4 n instead of n rings, the largest change; for a solid foot n - 1,
///                   or 5 instead of 2; instead of one ring the rings of Contact/Rings = 5
///   interpolation   loads between sampled phases
///   solver          tolerances
///
/// The band is the sum of the parts. Quantities: load and table motion at rest; the torque at rest, at half
/// and at one and a half times the terminal spin; terminal spin and time constant; the effect of the
/// harmonics beyond the first on the terminal spin. With waviness, and for a foot whose load depends on the
/// direction of the moment, torques are means over four phases of the period.
///
/// @p all: row of all harmonics; @p first: terminal spin of the first harmonic only, if any. Returns an empty
/// list for a load without a contact, if one of the changed contacts fails (as near tipping), or if no other
/// mesh would be informative (a solid foot whose contact with a hard table is narrower than its cells); @p
/// progress receives the reason. A quantity without a value after a change has no band. Collective if the
/// body is. @p reported: quantities with known values, which equal the values of the bands up to the solver's
/// tolerance.
ErrorBands estimate_bands(const Study &study, const std::shared_ptr<ElasticFoot> &foot,
                          const ring::Answer &all, const std::optional<double> &first,
                          const Executor &executor, Progress &progress = silent_progress(),
                          const std::vector<QuantityOfInterest> &reported = {});

/// Returns the quantities stated in the results of a study: of the load @p at_rest, and the torque at half
/// the terminal spin in the last row of @p budget.
std::vector<QuantityOfInterest> reported_quantities(const LoadReport &at_rest, const Budget &budget);

/// Sets the band of each budget row that comes from the contact and has a terminal spin, from the bands @p
/// of_all of the last row and @p of_first of the first harmonic only [rad/s]. A row has the wider of the two,
/// but at most either band plus the row's difference to its row, because discretisation changes a small
/// difference by a fraction of it. Closed forms get no band. Without @p of_first only rows that differ from
/// the last row by less than its band get one; without @p of_all none.
void add_bands(const std::optional<double> &of_all, const std::optional<double> &of_first,
               std::vector<BudgetRow> &rows);

} // namespace stemware::pipeline
