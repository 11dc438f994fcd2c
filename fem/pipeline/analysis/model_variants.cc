#include "fem/pipeline/analysis/model_variants.h"

#include <functional>
#include <utility>

namespace stemware::pipeline
{

Study with_constant_friction(Study study)
{
  ring::Motion &motion = study.motion.orbit;
  motion.friction_coefficient = motion.friction_at_rest();
  motion.friction_law = ring::FrictionLawKind::coulomb;
  return study;
}

Study paper_study(Study study)
{
  study = with_constant_friction(std::move(study));
  study.motion.closure = ring::Closure::paper;
  study.motion.grip_torque = 0;
  study.load = {};
  study.load.source = LoadSource::first_harmonic;
  return study;
}

Study first_harmonic_study(Study study)
{
  study.load.source = LoadSource::first_harmonic;
  return study;
}

bool has_compliance(const Study &study)
{
  return study.table.interface != TableInterface::hard || study.table.substrate == TableSubstrate::elastic ||
         !study.model.foot_is_rigid;
}

std::vector<ModelVariant> variants_without(const Study &study)
{
  std::vector<ModelVariant> variants;
  if (!study.load.is_from_contact())
    return variants;
  const auto add_if = [&](bool applies, const char *name, const std::function<void(Study &)> &leave_out)
  {
    if (!applies)
      return;
    leave_out(variants.emplace_back(ModelVariant{ name, study }).study);
  };
  const bool is_elastic_substrate = study.table.substrate == TableSubstrate::elastic;
  const bool is_elastic_foot = !study.model.foot_is_rigid;
  add_if(study.friction_deforms() && is_elastic_foot && study.model.friction_in_foot, "friction in the foot",
         [](Study &other) { other.model.friction_in_foot = false; });
  add_if(study.friction_deforms() && is_elastic_substrate && study.model.friction_in_substrate,
         "friction in the substrate", [](Study &other) { other.model.friction_in_substrate = false; });
  add_if(abilities(study.contact.body).is_of_revolution && is_elastic_foot, "elasticity of the foot",
         [](Study &other) { other.model.foot_is_rigid = true; });
  add_if(is_elastic_substrate, "elasticity of the substrate",
         [](Study &other) { other.table.substrate = TableSubstrate::rigid; });
  add_if(!study.table.is_hard(), "compliance of the interface",
         [](Study &other) { other.table.interface = TableInterface::hard; });
  add_if(!study.motion.orbit.has_constant_friction(), "dependence of friction on slip",
         [](Study &other) { other = with_constant_friction(std::move(other)); });
  add_if(study.tilts(), "tilt", [](Study &other) { other.motion.tilt = false; });
  add_if(study.motion.grip_torque > 0, "grip", [](Study &other) { other.motion.grip_torque = 0; });
  add_if(study.has_waviness(), "waviness", [](Study &other) { other.model.waviness = false; });
  return variants;
}

} // namespace stemware::pipeline
