#pragma once

#include "fem/pipeline/variants/variant.h"

#include <cstddef>
#include <vector>

namespace stemware::pipeline
{

/// Work done for the answer of a study.
struct AnswerWork
{
  std::size_t n_contacts = 0;    ///< contacts solved
  bool depends_on_phase = false; ///< the load is sampled over phases
  bool lifts_off = false;        ///< a part of the land carries no load
};

/// Shares (0 to 1) of the planned work that are done at two instants.
struct WorkShares
{
  double answer;   ///< when the answer is known
  double variants; ///< when the variants are solved too
};

/// Returns the shares in the work that is planned for @p study: the answer, the @p variants on loads of their
/// own, the curves over the spin, and, @p with_bands, error bands. Counts contacts, each weighted with its
/// cost relative to the answer's.
WorkShares work_shares(const Study &study, const AnswerWork &answer, const std::vector<Variant> &variants,
                       bool with_bands);

} // namespace stemware::pipeline
