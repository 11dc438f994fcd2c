#pragma once

#include "fem/pipeline/analysis/variant.h"

#include <vector>

namespace stemware::pipeline
{

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
