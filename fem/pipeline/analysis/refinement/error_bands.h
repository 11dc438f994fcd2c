#pragma once

#include "fem/pipeline/analysis/budget.h"
#include "fem/pipeline/analysis/refinement/quantities_of_interest.h"
#include "fem/pipeline/variants/solve.h"
#include "ring_model/spin/answer.h"

#include <memory>
#include <optional>
#include <vector>

namespace stemware::pipeline
{

/// The error bands of a study, from few further contacts: each numerical parameter is changed once, by
/// itself, and what that changes is the part of the band that carries its name
/// (docs/method/error_bands.md):
///
///   mesh            cells twice as large, in the contact where they are smaller there; then also those
///                   beyond half as large; of a solid foot half as large where no larger ones can be had
///   degree          elements of one degree more (on hard tables both on cells twice as large); of a solid
///                   foot where they are linear
///   harmonics       half the elastic harmonics; not of a solid foot
///   lines           four and three times the azimuth lines; nothing in full contact; not of a solid foot
///   interface       a ten times stiffer spring in the place of a hard interface
///   load_harmonics  twice the harmonics of the load, half where the lines or cells resolve no more
///   rings           twice the rings that the foot has, half of more than twelve; under a solid foot one
///                   less, five instead of two; instead of one those of Contact/Rings = 5
///   interpolation   loads between sampled phases
///   solver          tolerances
///
/// The band is their sum. Followed are the load at rest, the torque at rest, at half and at one and a half
/// times the terminal spin, terminal spin and time constant, and what the harmonics beyond the first do to
/// the terminal spin. Of an out-of-flat rim or table, and of a foot whose load depends on where the moment
/// points, the torques are means over four phases of the period.
///
/// @p all is the row of all harmonics, @p first that of the first alone, where there is one. Empty for a load
/// that does not come from a contact, and where one of the changed contacts cannot be had, as next to
/// tipping, or no other mesh would tell, as of a solid foot whose contact with a hard table is narrower than
/// its cells; @p progress receives the reason. A quantity that a change leaves without a value has none.
/// Collective where the body is.
ErrorBands estimate_bands(const Study &study, const std::shared_ptr<ElasticFoot> &foot,
                          const ring::Answer &all, const std::optional<double> &first,
                          const Executor &executor, Progress &progress = silent_progress());

/// Puts the numbers that a study reports into the place of those that the contacts of the bands have found,
/// which are the same up to the solver's tolerance: of the load @p at_rest, and of the torque at half the
/// terminal spin in the last row of @p budget.
void use_reported_values(const LoadReport &at_rest, const Budget &budget, ErrorBands &bands);

/// Gives every one of the @p rows of a budget that comes from the contact and has a terminal spin its band,
/// from those of the last row, @p of_all, and of the first harmonic alone, @p of_first [rad/s]: the wider of
/// the two, but no more than either of them and what the row differs from it by, since a discretisation
/// changes a small difference by a part of it. Closed forms have none; without @p of_first only rows that
/// differ from the last one by less than its band have one, without @p of_all none has.
void add_bands(const std::optional<double> &of_all, const std::optional<double> &of_first,
               std::vector<BudgetRow> &rows);

} // namespace stemware::pipeline
