#pragma once

#include "fem/pipeline/study/study.h"

#include <string>
#include <vector>

namespace stemware::pipeline
{

/// The study with one coefficient of friction: that at the orbit speed, mu(v), with which the torque at rest
/// stays what it is.
Study with_constant_friction(Study study);

/// The paper's model of a study's glass: its moment balance, a first harmonic on a ring of the contact
/// radius, constant friction, no grip.
Study paper_study(Study study);

/// The study with a first harmonic on a ring of the contact radius, of its moment balance or given moment.
Study first_harmonic_study(Study study);

/// A study with one effect left out.
struct ModelVariant
{
  /// "friction in the foot", "friction in the substrate", "elasticity of the foot", "elasticity of the
  /// substrate", "compliance of the interface", "dependence of friction on slip", "tilt", "grip" or
  /// "waviness".
  std::string name;
  Study study;
};

/// The study without each of the effects that it has, one at a time; none for a load that does not come from
/// a contact.
std::vector<ModelVariant> variants_without(const Study &study);

/// Whether anything yields in a contact: the foot, the substrate or the interface. The pressure of a contact
/// in which nothing does is not defined.
bool has_compliance(const Study &study);

} // namespace stemware::pipeline
