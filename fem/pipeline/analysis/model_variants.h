#pragma once

#include "fem/pipeline/analysis/variant.h"

#include <vector>

namespace stemware::pipeline
{

/// Returns the paper's model of a study's glass: the paper's moment balance, a first harmonic on a ring of
/// the contact radius, constant friction, no grip, a liquid with a level surface.
Study paper_study(Study study);

/// Returns the models before the rows by harmonics: steps 1, 1a, 2, 2a and 3, each named after its
/// difference from the one before, all with a first harmonic. Models with a contact use the study's foot.
std::vector<Variant> model_chain(const Study &study);

/// Returns the study without one of its effects at a time; empty for a load without a contact: "friction in
/// the foot", "friction in the substrate", "elasticity of the foot", "elasticity of the substrate",
/// "compliance of the interface", "dependence of friction on slip", "tilt", "lean of the liquid", "grip",
/// "waviness". Two kinds are not to be solved: variants without any compliance are undefined, and variants of
/// a solid foot on a hard table take too long if the load @p depends_on_phase. @p own: the study itself.
std::vector<Variant> variants_without(const Variant &own, bool depends_on_phase = false);

/// Returns the first-harmonic model of a study with a moment balance, "unchanged" and with one input changed
/// at a time: "1 cm more height of the centre of mass", "0.05 more friction", "1.4 mN m more grip". Without
/// contacts. Empty for a load without a moment balance.
std::vector<Variant> input_variants(const Study &study);

/// Returns whether foot, substrate or interface is compliant; otherwise the pressure is not defined.
bool has_compliance(const Study &study, const Model &model);

} // namespace stemware::pipeline
