#include "fem/pipeline/variants/model_variants.h"

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
  study.motion.orbit.liquid.surface_leans = false;
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

std::vector<Variant> model_chain(const Study &study)
{
  std::vector<Variant> chain;
  const auto add = [&](const char *key, const char *name, const Study &model) {
    chain.push_back({ key, name, model, 1, true });
  };
  Study model = paper_study(study);
  add("1", "paper", model);
  if (!study.motion.orbit.has_constant_friction())
  {
    model.motion.orbit = study.motion.orbit;
    model.motion.orbit.liquid.surface_leans = false;
    add("1a", "friction law", model);
  }
  if (study.load.source != LoadSource::file)
  {
    model = first_harmonic_study(study);
    model.motion.grip_torque = 0;
    add("2", study.load.is_static() ? "given moment" : "moment balance", model);
  }
  if (study.motion.grip_torque > 0)
  {
    model.motion.grip_torque = study.motion.grip_torque;
    add("2a", "grip", model);
  }
  if (study.tilts())
  {
    model = study;
    model.motion.tilt = false;
    add("3", "where the foot touches", model);
  }
  return chain;
}

std::vector<Variant> variants_without(const Study &study, bool depends_on_phase)
{
  std::vector<Variant> variants;
  if (!study.load.is_from_contact())
    return variants;
  const auto add_if = [&](bool applies, const char *name, const std::function<void(Study &)> &leave_out)
  {
    if (!applies)
      return;
    Variant &variant = variants.emplace_back(Variant{ "without", name, study });
    leave_out(variant.study);
    const bool is_solid = !abilities(study.contact.body).is_of_revolution;
    if (!has_compliance(variant.study))
      variant.reason = "not defined";
    else if ((depends_on_phase || variant.study.has_waviness()) && is_solid &&
             variant.study.table.is_hard() && !study.table.is_hard())
      variant.reason = "not computed: a solid foot on a hard table takes too long at every phase";
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
  add_if(study.motion.orbit.liquid.mass > 0 && study.load.has_closure(), "lean of the liquid",
         [](Study &other) { other.motion.orbit.liquid.surface_leans = false; });
  add_if(study.motion.grip_torque > 0, "grip", [](Study &other) { other.motion.grip_torque = 0; });
  if (study.motion.grip_torque > 0)
    variants.back().on_same_load = true;
  add_if(study.has_waviness(), "waviness", [](Study &other) { other.model.waviness = false; });
  return variants;
}

} // namespace stemware::pipeline
