#pragma once

#include "fem/pipeline/analysis/solve_study.h"

#include <functional>
#include <string>

namespace stemware::pipeline
{

/// One load over the spin, with some of its harmonics.
struct TruncatedLoad
{
  LoadAtSpin kept;        ///< the harmonics up to n_max
  LoadAtSpin whole;       ///< all harmonics of the contact under the same moment
  bool is_costly = false; ///< whether a load takes contact solutions
  /// The harmonics up to n_max for thousands of spins between rest and the terminal spin, which need not be
  /// exact; empty: nobody has interpolated them yet.
  LoadAtSpin on_the_way = {};
};

/// The load of a study cut off after @p n_max >= 1 harmonics, for any n_max.
using TruncatedLoads = std::function<TruncatedLoad(unsigned int n_max)>;

/// The study's load cut off; nothing answers to that. @p on_the_way is the same load for thousands of spins.
TruncatedLoads cut_off_loads(const RingLoad &load, const LoadAtSpin &on_the_way);

/// The contact in balance with the friction of its own load, cut off, at every spin. The study's load must
/// come from a contact; @p load keeps its foot. Throws what contact solutions and balances throw, when
/// called.
TruncatedLoads balanced_truncated_loads(const Study &study, const StudyLoad &load);

/// Why there are no balanced_truncated_loads(), in one sentence; empty where there are. Rim and table are
/// flat.
std::string why_no_balance(const Study &study);

} // namespace stemware::pipeline
