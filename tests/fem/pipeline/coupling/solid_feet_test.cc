// Solid feet that share what is the same. With MPI.
#include "fem/pipeline/coupling/study_load.h"
#include "fem/pipeline/feet/make_foot.h"
#include "fem/solid/solid_foot.h"

#include <gtest/gtest.h>

#include <memory>

namespace stemware::pipeline
{
namespace
{

const void *mesh_of(const ElasticFoot &foot)
{
  return dynamic_cast<const fem::SolidFoot &>(foot.body()).own_mesh().triangulation.get();
}

// Rows without one thing take no second hierarchy of meshes: they are made like the study's own foot. Nothing
// else decides on that, least of all which feet there are.
TEST(SolidFootFunctions, ShareTheMeshOfTheSimilarFootAlone)
{
  Study study;
  study.contact.body = BodyKind::solid;
  study.contact.resolution.azimuthal_cells = 12;
  study.contact.degree = 1;
  fem::ComplianceCache cache;
  const auto like = [&](const Study &asked, const ElasticFoot *similar)
  { return study_foot(asked, cache, silent_progress(), similar); };
  const auto foot = like(study, nullptr);
  Study slippery = study, softer = study;
  slippery.motion.orbit.friction_coefficient /= 2;
  softer.glass.material.young_modulus /= 2;
  EXPECT_EQ(mesh_of(*like(slippery, foot.get())), mesh_of(*foot));
  EXPECT_NE(mesh_of(*like(slippery, nullptr)), mesh_of(*foot));
  EXPECT_NE(mesh_of(*like(softer, foot.get())), mesh_of(*foot));
}

} // namespace
} // namespace stemware::pipeline
