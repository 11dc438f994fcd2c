#include "fem/pipeline/explore/live_bodies.h"

#include "fem/pipeline/coupling/revolution_setup.h"
#include "fem/pipeline/study/study_file.h"
#include "fem/pipeline/support/failures.h"
#include "fem/revolution/meridian_meshes.h"

namespace stemware::pipeline
{

namespace
{

void require_live(const Study &study)
{
  require(study.load.is_from_contact(), "A page needs a contact to solve; set Load/Source = contact.");
  require(abilities(study.contact.body).is_of_revolution,
          "A page solves a body of revolution alone; set Contact/Body = revolution.");
  require_flat(study, "explore");
  require(files_of(study).empty(),
          "A page reads no files; leave Glass/Profile file and Motion/Orbit speed file empty.");
  require(study.contact.goal == Goal::none, "A page keeps its mesh; set Contact/Goal = none.");
}

} // namespace

LiveBodies live_bodies(const Study &study, fem::ComplianceCache &cache)
{
  require_live(study);
  const fem::RevolutionSetup setup = revolution_setup(study);
  const fem::MeridianMeshes meshes(setup);
  const fem::MeridianOptions options = setup.meridian_of_zone();
  LiveBodies bodies = { *cache.get(meshes.foot, setup.material, options), {} };
  if (setup.table.substrate)
    bodies.disc = *cache.get(meshes.disc, setup.table.substrate->material, options);
  return bodies;
}

} // namespace stemware::pipeline
