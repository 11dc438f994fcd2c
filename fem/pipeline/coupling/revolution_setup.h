#pragma once

#include "fem/pipeline/study/study.h"
#include "fem/revolution/revolution_setup.h"

namespace stemware::pipeline
{

/// Rim and table of a study as gaps.
fem::RimImperfection imperfection_of(const Study &study);

/// The foot of revolution and the table that @p study asks for, resolved for its weight.
fem::RevolutionSetup revolution_setup(const Study &study);

/// Gives @p setup, a fem::RevolutionSetup or fem::SolidSetup, the friction that deforms the body, where one
/// does.
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
