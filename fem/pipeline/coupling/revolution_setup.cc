#include "fem/pipeline/coupling/revolution_setup.h"

namespace stemware::pipeline
{

fem::RevolutionSetup revolution_setup(const FootSpecification &specification)
{
  const auto &[study, discretisation, model] = specification;
  fem::RevolutionSetup setup;
  setup.profile = study.glass.profile;
  setup.material = study.glass.material;
  setup.table = study.table.make();
  setup.imperfection = { study.glass.waviness, study.table.waviness };
  if (study.friction_deforms())
    set_friction(study.motion.orbit, setup);
  setup.meridian.degree = study.contact.degree;
  setup.meridian.n_harmonics = study.contact.harmonics;
  setup.resolution.land_cells = study.contact.resolution.radial_cells;
  setup.resolution.land_grading = study.contact.land_grading;
  setup.resolution.refinements = study.contact.refinements;
  setup.halved_cells = discretisation.halved_cells;
  setup.n_lines = study.contact.azimuth_lines;
  setup.fineness = discretisation.fineness;
  setup.halvings_beyond_zone = discretisation.halvings_beyond_zone;
  setup.hardness *= discretisation.hardness;
  setup.foot_is_rigid = model.foot_is_rigid;
  setup.friction_in_foot = model.friction_in_foot;
  setup.friction_in_substrate = model.friction_in_substrate;
  return setup.resolved_for(study.required_resultants().normal_force);
}

} // namespace stemware::pipeline
