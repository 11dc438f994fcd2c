#pragma once

#include "fem/pipeline/coupling/contact_report.h"
#include "fem/pipeline/coupling/elastic_foot.h"
#include "fem/pipeline/variants/variant.h"

#include <optional>
#include <string>
#include <vector>

namespace stemware::pipeline
{

/// A way in which rings take over the pressure of contacts.
struct RingProjection
{
  std::vector<double> radii = {}; ///< of the rings [m]; empty: one ring
  unsigned int n_harmonics = 0;
};

/// A change of one numerical parameter, whose key is the part of the band that it goes into, as in
/// BandedQuantity::parts: several may go into one.
struct BandChange : Variant
{
  double factor = 1;     ///< on what is changed; 0: no part, others are compared with it
  std::string from = {}; ///< part whose first change it is compared with, an earlier one; empty: the study
  /// Terminal spin and torques are judged together, by the torques at several spins.
  bool compares_over_spins = false;
  /// The part is the larger of this change and the sum of the earlier changes of the same part.
  bool is_alternative = false;
  /// The contacts of the study stay, in the balance of their own rings: it is their torque that another
  /// gathering changes. Nothing: the change has contacts of its own.
  std::optional<RingProjection> ring_projection = {};
};

/// The changes that the band of @p study is made of (estimate_bands()); @p foot is its own, with its rings
/// chosen, @p at_rest its load at rest. @p is_full: the whole rim carries load. Throws BadInput, with what
/// it is that no other mesh would tell: for a solid foot whose contact on a hard table is narrower than its
/// cells, and for one of linear elements from a file when quadratic ones would exceed Contact/Memory limit.
std::vector<BandChange> band_changes(const Study &study, const ElasticFoot &foot, const LoadReport &at_rest,
                                     bool is_full);

} // namespace stemware::pipeline
