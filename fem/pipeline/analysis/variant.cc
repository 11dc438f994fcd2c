#include "fem/pipeline/analysis/variant.h"

#include <algorithm>
#include <functional>
#include <utility>

namespace stemware::pipeline
{

namespace
{

/// Returns the study with constant friction coefficient mu(orbit speed), which preserves the torque at rest.
Study with_constant_friction(Study study)
{
  ring::Motion &motion = study.motion.orbit;
  motion.friction_coefficient = motion.friction_at_rest();
  motion.friction_law = ring::FrictionLawKind::coulomb;
  return study;
}

/// Returns the study with a load that has only the first harmonic, on a ring of the contact radius.
Study first_harmonic_study(Study study)
{
  study.load.source = LoadSource::first_harmonic;
  return study;
}

} // namespace

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

bool has_compliance(const FootSpecification &specification)
{
  const TableSection &table = specification.study.table;
  return table.interface != TableInterface::hard || table.substrate == TableSubstrate::elastic ||
         !specification.model.foot_is_rigid;
}

std::vector<Variant> model_chain(const Variant &own)
{
  std::vector<Variant> chain;
  const auto add = [&](const ChainStep &step, const char *name, Study model)
  {
    Variant &variant = chain.emplace_back(Variant{ { std::move(model) }, VariantKind::chain, name });
    variant.n_harmonics = 1;
    variant.shared = Shared::foot;
    variant.step = step;
  };
  Study model = paper_study(own.study);
  add({ 1 }, "paper", model);
  if (!own.study.motion.orbit.has_constant_friction())
  {
    model.motion.orbit = own.study.motion.orbit;
    model.motion.orbit.liquid.surface_leans = false;
    add({ 1, true }, "friction law", model);
  }
  if (own.study.load.source != LoadSource::file)
  {
    model = first_harmonic_study(own.study);
    model.motion.grip_torque = 0;
    add({ 2 }, own.study.load.is_static() ? "given moment" : "moment balance", model);
  }
  if (own.study.motion.grip_torque > 0)
  {
    model.motion.grip_torque = own.study.motion.grip_torque;
    add({ 2, true }, "grip", model);
  }
  if (own.study.tilts())
  {
    model = own.study;
    model.motion.tilt = false;
    add({ 3 }, "where the foot touches", model);
  }
  return chain;
}

std::vector<Variant> input_variants(const Variant &own)
{
  constexpr double higher = 0.01, rougher = 0.05, grip = 1.4e-3; // [m], [1], [N m]
  std::vector<Variant> variants;
  if (!own.study.load.has_closure())
    return variants;
  const auto add = [&](const char *name, const std::function<void(MotionSection &)> &change)
  {
    Variant &variant =
      variants.emplace_back(Variant{ { first_harmonic_study(own.study) }, VariantKind::input, name });
    variant.n_harmonics = 1;
    variant.shared = Shared::foot;
    change(variant.study.motion);
  };
  add("unchanged", [](MotionSection &) {});
  add("1 cm more height of the centre of mass",
      [&](MotionSection &motion)
      {
        motion.orbit.centre_of_mass_height += higher;
        if (own.study.given_entries.count("Motion/Force offset") == 0) // keeps the height of the hand
          motion.orbit.force_offset -= higher;
      });
  add("0.05 more friction", [](MotionSection &motion) { motion.orbit.friction_coefficient += rougher; });
  add("1.4 mN m more grip", [](MotionSection &motion) { motion.grip_torque += grip; });
  return variants;
}

std::vector<Variant> variants_without(const Variant &own, bool depends_on_phase)
{
  const Model &model = own.model;
  std::vector<Variant> variants;
  if (!own.study.load.is_from_contact())
    return variants;
  const auto add_if = [&](bool applies, const char *name, const std::function<void(Variant &)> &leave_out)
  {
    if (!applies)
      return;
    Variant &variant = variants.emplace_back(own);
    variant.kind = VariantKind::without;
    variant.name = name;
    leave_out(variant);
    const bool is_solid = !own.study.contact.is_of_revolution();
    if (!has_compliance(variant))
      variant.reason = "not defined";
    else if ((depends_on_phase || variant.study.has_waviness()) && is_solid &&
             variant.study.table.is_hard() && !own.study.table.is_hard())
      variant.reason = "not computed: a solid foot on a hard table takes too long at every phase";
  };
  const bool is_elastic_substrate = own.study.table.substrate == TableSubstrate::elastic;
  const bool is_elastic_foot = !model.foot_is_rigid;
  add_if(own.study.friction_deforms() && is_elastic_foot && model.friction_in_foot, "friction in the foot",
         [](Variant &other) { other.model.friction_in_foot = false; });
  add_if(own.study.friction_deforms() && is_elastic_substrate && model.friction_in_substrate,
         "friction in the substrate", [](Variant &other) { other.model.friction_in_substrate = false; });
  add_if(own.study.contact.is_of_revolution() && is_elastic_foot, "elasticity of the foot",
         [](Variant &other) { other.model.foot_is_rigid = true; });
  add_if(is_elastic_substrate, "elasticity of the substrate",
         [](Variant &other) { other.study.table.substrate = TableSubstrate::rigid; });
  add_if(!own.study.table.is_hard(), "compliance of the interface",
         [](Variant &other)
         {
           // With waviness, the load is interpolated between sampled phases. The error of this interpolation
           // exceeds the error of elements of degree 2, so a higher degree is useless.
           constexpr unsigned int max_degree = 2;
           other.study.table.interface = TableInterface::hard;
           if (other.study.has_waviness())
             other.study.contact.degree = std::min(other.study.contact.degree, max_degree);
         });
  add_if(!own.study.motion.orbit.has_constant_friction(), "dependence of friction on slip",
         [](Variant &other) { other.study = with_constant_friction(std::move(other.study)); });
  add_if(own.study.tilts(), "tilt", [](Variant &other) { other.study.motion.tilt = false; });
  add_if(own.study.motion.orbit.liquid.mass > 0 && own.study.load.has_closure(), "lean of the liquid",
         [](Variant &other) { other.study.motion.orbit.liquid.surface_leans = false; });
  add_if(own.study.motion.grip_torque > 0, "grip",
         [](Variant &other)
         {
           other.study.motion.grip_torque = 0;
           other.shared = Shared::load;
         });
  add_if(own.study.has_waviness(), "waviness",
         [](Variant &other) { other.study.glass.waviness = other.study.table.waviness = {}; });
  return variants;
}

} // namespace stemware::pipeline
