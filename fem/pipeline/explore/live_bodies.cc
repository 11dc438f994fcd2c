#include "fem/pipeline/explore/live_bodies.h"

#include "fem/pipeline/coupling/revolution_setup.h"
#include "fem/pipeline/study/study_file.h"
#include "fem/pipeline/support/failures.h"
#include "fem/revolution/meridian_meshes.h"
#include "fem/revolution/revolution_foot.h"

#include <algorithm>

namespace stemware::pipeline
{

namespace
{

void require_live(const Study &study)
{
  require(study.load.is_from_contact(), "A page needs a contact to solve; set Load/Source = contact.");
  require(abilities(study.contact.body).is_of_revolution,
          "A page solves a body of revolution alone; set Contact/Body = revolution.");
  // Its solver takes minutes for a contact of a rough table, where the program takes a second.
  require(study.table.interface != TableInterface::rough,
          "A page does not solve a rough table; set Table/Interface = hard or Winkler.");
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
  const auto foot = cache.get(meshes.foot, setup.material, setup.meridian);
  const auto disc =
    setup.table.substrate ? cache.get(meshes.disc, setup.table.substrate->material, setup.meridian) : nullptr;
  const auto both = std::make_shared<const fem::ContactCompliance>(setup.together(*foot, disc.get()));
  const fem::RevolutionFoot whole(setup, both);
  const Eigen::VectorXd &part = whole.elastic_body().contact_compliance().radii;
  const auto first = std::lower_bound(foot->radii.begin(), foot->radii.end(), part(0)) - foot->radii.begin();
  LiveBodies bodies = { foot->part(first, part.size()), {} };
  if (disc)
    bodies.disc = disc->part(first, part.size());
  return bodies;
}

} // namespace stemware::pipeline
