#pragma once

#include "fem/pipeline/analysis/quantities_of_interest.h"
#include "fem/pipeline/analysis/solve.h"
#include "fem/pipeline/analysis/study_rows.h"
#include "ring_model/spin/answer.h"

#include <optional>
#include <string>
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

/// Change of one numerical parameter. With Shared::load, the study's contacts are kept, and only the torque
/// of their pressures on other rings and harmonics (Variant::n_harmonics) is computed.
struct BandChange : Variant
{
  std::string part;      ///< part of the band (BandedQuantity::parts) to which it contributes
  double factor = 1;     ///< factor on the change; 0: only a reference of other changes
  std::string from = {}; ///< part whose first change is the reference; empty: the study
  /// True if terminal spin and torques are compared by their largest change at several spins.
  bool compares_over_spins = false;
  /// True if the part is the larger of this change and the sum of its earlier ones (for maxima: the sum).
  bool is_alternative = false;
  std::vector<double> ring_radii = {}; ///< for Shared::load [m]; empty: one ring
};

/// Returns the changes for the bands of a study (estimate_bands()). @p foot: the study's foot with its rings;
/// @p at_rest: load at rest; @p is_full: the whole rim is loaded. Throws BadInput, with the reason, if
/// no other mesh would be informative: a solid foot whose contact on a hard table is narrower than its cells,
/// or linear elements from a file if quadratic ones would exceed Contact/Memory limit.
std::vector<BandChange> band_changes(const ElasticFoot &foot, const LoadReport &at_rest, bool is_full);

} // namespace stemware::pipeline
