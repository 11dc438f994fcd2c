#pragma once

#include "fem/pipeline/coupling/discretisation.h"
#include "fem/pipeline/study/study.h"
#include "fem/revolution/revolution_setup.h"

namespace stemware::pipeline
{

/// Returns the waviness of rim and table of a study.
fem::RimImperfection imperfection_of(const Study &study);

/// Returns foot of revolution, table, and a mesh that resolves the contact under the weight of @p study.
fem::RevolutionSetup revolution_setup(const Study &study, const Discretisation &discretisation = {},
                                      const Model &model = {});

/// Sets the friction of @p setup, a fem::RevolutionSetup or fem::SolidSetup, if Study::friction_deforms().
template <typename Setup>
void set_friction(const Study &study, Setup &setup)
{
  if (!study.friction_deforms())
    return;
  const ring::Motion &motion = study.motion.orbit;
  setup.friction_coefficient = motion.friction_coefficient;
  if (!motion.has_constant_friction())
    setup.friction_by_slip = [motion](double relative_slip)
    { return motion.friction_at(relative_slip * motion.orbit_speed); };
}

} // namespace stemware::pipeline
