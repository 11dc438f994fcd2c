#include "fem/pipeline/page/live_bodies.h"

#include "fem/pipeline/base/failures.h"
#include "fem/pipeline/coupling/revolution_setup.h"
#include "fem/pipeline/study/study_file.h"
#include "fem/revolution/meridian_meshes.h"

namespace stemware::pipeline
{

LiveBodies live_bodies(const FootSpecification &specification, fem::ComplianceCache &cache, double ratio)
{
  const auto &[study, discretisation, model] = specification;
  ensure(study.load.is_from_contact(), "A page needs a contact to solve; set Load/Source = contact.");
  ensure(study.contact.is_of_revolution(),
         "A page solves bodies of revolution only; set Contact/Body = revolution.");
  ensure(!study.has_waviness(),
         "A page solves one load over the spin; leave Glass/Rim waviness and Table/Waviness empty.");
  ensure(files_of(entries_of(study)).empty(),
         "A page reads no files; leave Glass/Profile file and Motion/Orbit speed file empty.");
  ensure(study.contact.goal == Goal::none, "A page keeps its mesh; set Contact/Goal = none.");
  fem::RevolutionSetup setup = revolution_setup(specification);
  if (setup.table.substrate)
  {
    setup.table.substrate->disc.radius /= ratio;
    setup.table.substrate->disc.thickness /= ratio;
  }
  const fem::MeridianMeshes meshes(setup);
  const fem::MeridianOptions options = setup.meridian_of_zone();
  LiveBodies bodies = { *cache.get(meshes.foot, setup.material, options), std::nullopt };
  if (setup.table.substrate)
    bodies.disc = *cache.get(meshes.disc, setup.table.substrate->material, options);
  return bodies;
}

} // namespace stemware::pipeline
