#pragma once

#include "fem/pipeline/coupling/foot_specification.h"
#include "fem/revolution/revolution_setup.h"
#include "ring_model/motion.h"

namespace stemware::pipeline
{

/// Returns foot of revolution, table, and a mesh that resolves the contact under the weight of the study.
fem::RevolutionSetup revolution_setup(const FootSpecification &specification);

/// Sets the friction of @p setup, a fem::RevolutionSetup or fem::SolidSetup.
template <typename Setup>
void set_friction(const ring::Motion &motion, Setup &setup)
{
  setup.friction_coefficient = motion.friction_coefficient;
  if (!motion.has_constant_friction())
    setup.friction_by_slip = [motion](double relative_slip)
    { return motion.friction_at(relative_slip * motion.orbit_speed); };
}

} // namespace stemware::pipeline
