#pragma once

#include "fem/pipeline/coupling/balanced_contact.h"
#include "fem/pipeline/coupling/foot_specification.h"

#include <string>
#include <vector>

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

/// Returns the paper's model of a study's glass: its moment balance, first harmonic on a ring of the contact
/// radius, constant friction, no grip, level liquid.
Study paper_study(Study study);

/// Returns the models of the study @p own before the rows by harmonics: steps 1, 1a, 2, 2a and 3, each named
/// after its difference from the previous one, with a first harmonic. Models with a contact use the study's
/// foot.
std::vector<Variant> model_chain(const Variant &own);

/// Returns the study @p own without one of its effects at a time, named "friction in the foot", "tilt",
/// "grip", ... (docs/theory/budget.md); empty without a contact. Not to be solved (Variant::reason): variants
/// without compliance, and a solid foot on a hard table whose load @p depends_on_phase (too slow).
std::vector<Variant> variants_without(const Variant &own, bool depends_on_phase = false);

/// Returns the first-harmonic model of the study @p own, "unchanged" and with one input changed at a time:
/// "0.05 more friction", ... (Budget::inputs); empty for a load without a moment balance.
std::vector<Variant> input_variants(const Variant &own);

/// Returns true if foot, substrate or interface is compliant; otherwise the pressure is undefined.
bool has_compliance(const FootSpecification &specification);

} // namespace stemware::pipeline
