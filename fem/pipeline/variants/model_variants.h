#pragma once

#include "fem/pipeline/variants/variant.h"

#include <vector>

namespace stemware::pipeline
{

/// The study with one coefficient of friction: that at the orbit speed, mu(v), with which the torque at rest
/// stays what it is.
Study with_constant_friction(Study study);

/// The paper's model of a study's glass: its moment balance, a first harmonic on a ring of the contact
/// radius, constant friction, no grip, a liquid with a level surface.
Study paper_study(Study study);

/// The study with a first harmonic on a ring of the contact radius, of its moment balance or given moment.
Study first_harmonic_study(Study study);

/// The models in front of those that are told apart by their harmonics, from the paper's on: "1", "1a", "2",
/// "2a" and "3", each named after what tells it from the one before, all of them with a first harmonic. Those
/// with a contact have the study's foot.
std::vector<Variant> model_chain(const Study &study);

/// The study without each of the effects that it has, one at a time; none for a load that does not come from
/// a contact: "friction in the foot", "friction in the substrate", "elasticity of the foot", "elasticity of
/// the substrate", "compliance of the interface", "dependence of friction on slip", "tilt", "lean of
/// the liquid", "grip", "waviness". Those of which nothing yields are not defined, those of a solid foot on a
/// hard table that @p depends_on_phase take too long; they are not to be solved.
std::vector<Variant> variants_without(const Study &study, bool depends_on_phase = false);

/// True if anything yields in a contact: the foot, the substrate or the interface. The pressure of a contact
/// in which nothing does is not defined.
bool has_compliance(const Study &study);

} // namespace stemware::pipeline
