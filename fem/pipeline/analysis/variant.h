#pragma once

#include "fem/pipeline/coupling/balanced_contact.h"
#include "fem/pipeline/coupling/foot_specification.h"

#include <string>

namespace stemware::pipeline
{

/// Kind of a variant of a study.
enum class VariantKind
{
  study,     ///< the study itself, or a case of a sweep
  chain,     ///< model of the budget's chain before the rows by harmonics
  harmonics, ///< the study with fewer harmonics, in the budget's chain too
  without,   ///< the study without one of its effects
  input,     ///< first-harmonic model of the study, maybe with one input changed
  one_ring,  ///< the study on one ring
  parameter  ///< one numerical parameter changed (refinement or error band)
};

/// Part of the study's solution that a variant uses again, in ascending order.
enum class Shared
{
  nothing, ///< own foot
  rings,   ///< own foot with the study's rings
  contact, ///< the study's foot with newly chosen rings
  foot,    ///< the study's foot and rings
  load     ///< the study's load, truncated to n_harmonics
};

/// Position of a model in the budget's chain.
struct ChainStep
{
  unsigned int number = 1;  ///< 1 paper, 2 study's moment, 3 study's contact, 4 ... more harmonics
  bool is_addition = false; ///< 1a, 2a, 3a

  /// Returns true if the terminal spin comes from the study's contact.
  bool is_of_contact() const { return number >= 3; }
};

/// Named change of a study, or the study itself, to be solved. Derived types add data.
struct Variant : FootSpecification
{
  VariantKind kind = VariantKind::study;
  std::string name = {};                    ///< displayed name: "tilt"
  unsigned int n_harmonics = all_harmonics; ///< harmonics whose friction acts
  Shared shared = Shared::nothing;
  ChainStep step = {};     ///< step of VariantKind::chain
  std::string reason = {}; ///< why it is not to be solved; empty if it is

  /// Returns true for rows of the budget's chain, which have torques.
  bool is_of_chain() const { return kind == VariantKind::chain || kind == VariantKind::harmonics; }
};

} // namespace stemware::pipeline
