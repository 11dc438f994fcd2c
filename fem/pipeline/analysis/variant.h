#pragma once

#include "fem/pipeline/coupling/balanced_load.h"
#include "fem/pipeline/coupling/elastic_foot.h"
#include "fem/pipeline/study/study.h"

#include <string>

namespace stemware::pipeline
{

/// Kind of a variant of a study.
enum class VariantKind
{
  study,     ///< the study itself, or a case of a sweep
  chain,     ///< model of the budget's chain before the study's own rows
  harmonics, ///< the study with fewer harmonics, a row of the budget's chain too
  without,   ///< the study without one of its effects
  input,     ///< the first-harmonic model of the study, or the same with one input changed
  one_ring,  ///< the study on one ring
  parameter  ///< numerical parameter changed: level of refinement, or part of a band
};

/// Part of the study's solution that a variant uses again.
enum class Shared
{
  nothing, ///< has a foot of its own
  contact, ///< the study's foot with newly chosen rings
  foot,    ///< the study's foot and rings
  load     ///< the study's load, truncated to n_harmonics
};

/// Position of a model in the chain from the paper's model to the study's.
struct ChainStep
{
  unsigned int number = 1;  ///< 1 the paper, 2 the study's moment, 3 its contact, 4 ... more harmonics
  bool is_addition = false; ///< addition to the model `number`: 1a, 2a, 3a

  /// Returns true if the terminal spin comes from the study's contact, not from a closed form.
  bool is_of_contact() const { return number >= 3; }
};

/// Named change of a study, or the study itself, to be solved next to the study. Derived types add data for
/// their evaluation.
struct Variant
{
  VariantKind kind = VariantKind::study;
  std::string name = {}; ///< displayed name: "tilt"
  Study study = {};
  Discretisation discretisation = {};
  Model model = {};
  unsigned int n_harmonics = all_harmonics; ///< whose friction acts
  Shared shared = Shared::nothing;
  ChainStep step = {};     ///< step of VariantKind::chain
  std::string reason = {}; ///< reason for not being solved; empty if it is to be solved

  /// Returns whether it is a row of the budget's chain, with torques.
  bool is_of_chain() const { return kind == VariantKind::chain || kind == VariantKind::harmonics; }
};

/// Returns the study itself on its foot @p foot; nullptr: without a contact. Other variants are changes of
/// it.
inline Variant own_variant(const Study &study, const ElasticFoot *foot)
{
  return foot ? Variant{ VariantKind::study, "", study, foot->discretisation(), foot->model() }
              : Variant{ VariantKind::study, "", study };
}

} // namespace stemware::pipeline
