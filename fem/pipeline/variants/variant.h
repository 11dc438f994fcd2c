#pragma once

#include "fem/pipeline/coupling/balanced_load.h"
#include "fem/pipeline/coupling/elastic_foot.h"
#include "fem/pipeline/study/study.h"

#include <memory>
#include <string>

namespace stemware::pipeline
{

/// Named change of a study, or the study itself, to be solved next to the study. Derived types add data for
/// their evaluation.
struct Variant
{
  std::string key = {};  ///< identifier: step of a chain, or part of a band
  std::string name = {}; ///< displayed name: "tilt"
  Study study = {};
  Discretisation discretisation = {};
  Model model = {};
  unsigned int n_harmonics = all_harmonics; ///< whose friction acts
  bool on_same_foot = false;                ///< uses the study's foot
  bool on_same_load = false;                ///< uses the study's load, truncated to n_harmonics
  bool is_of_chain = false;                 ///< a row of the budget's chain, with torques
  std::string reason = {};                  ///< reason for not being solved; empty if it is to be solved
  bool on_other_rings = false;              ///< on the same foot, but with newly chosen rings
};

/// Returns the study itself on @p foot, its foot, of which other variants are changes; nullptr: without a
/// contact.
inline Variant own_variant(const Study &study, const ElasticFoot *foot)
{
  return foot ? Variant{ "", "", study, foot->discretisation(), foot->model() } : Variant{ "", "", study };
}

} // namespace stemware::pipeline
