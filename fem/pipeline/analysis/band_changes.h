#pragma once

#include "fem/pipeline/analysis/variant.h"
#include "fem/pipeline/coupling/contact_report.h"
#include "fem/pipeline/coupling/elastic_foot.h"

#include <string>
#include <vector>

namespace stemware::pipeline
{

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
