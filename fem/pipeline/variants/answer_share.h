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

/// Returns the share (0 to 1) of the answer of @p study in the work that is planned: the answer, the
/// @p variants on loads of their own, and, @p with_bands, error bands. Counts contacts, each weighted with
/// its cost relative to the answer's.
double share_of_answer(const Study &study, const AnswerWork &answer, const std::vector<Variant> &variants,
                       bool with_bands);

} // namespace stemware::pipeline
