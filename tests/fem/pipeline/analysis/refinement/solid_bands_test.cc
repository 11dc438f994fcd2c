// The error bands of a solid foot. Oracle: the body of revolution on the same profile, refined, with its own
// bands. With MPI.
#include "fem/pipeline/answer/threaded_executor.h"
#include "fem/pipeline/coupling/study_load.h"
#include "fem/pipeline/feet/make_foot.h"
#include "fem/pipeline/refinement/error_bands.h"
#include "ring_model/spin/answer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

namespace stemware::pipeline
{

namespace
{

ErrorBands bands_of(const Study &study)
{
  fem::ComplianceCache cache;
  const std::shared_ptr<ElasticFoot> foot = study_foot(study, cache);
  const SharedLoad load = find_load(study, foot);
  ring::Question question = { study.motion.orbit };
  question.with_slope = true;
  return estimate_bands(study, foot, ring::answer(*load, question).value(), std::nullopt,
                        ThreadedExecutor(cache));
}

/// The study of a solid foot as one of revolution, finer than usual where @p refinements says so.
Study revolved(Study study, unsigned int refinements = 1)
{
  study.contact.body = BodyKind::revolution;
  study.contact.resolution = {};
  study.contact.refinements = refinements;
  study.contact.harmonics = 24;
  return study;
}

/// Expects the two values of @p key within the sum of their bands. @p widest: how many times the difference
/// the band may be; 0: any number, where the difference may vanish by chance.
void expect_within_both(const ErrorBands &solid, const ErrorBands &revolution, const std::string &key,
                        double widest = 0)
{
  const BandedQuantity &own = solid[index_of(solid, key)], &other = revolution[index_of(revolution, key)];
  const double difference = std::abs(own.quantity.value - other.quantity.value);
  ::testing::Test::RecordProperty(key, std::to_string(own.band / difference));
  EXPECT_LE(difference, own.band + other.band) << key;
  EXPECT_LT(other.band, own.band) << key; // else the oracle is none
  if (widest > 0)
  {
    EXPECT_LT(own.band, widest * difference) << key;
  }
}

Study solid_study(fem::GlassShape shape, const fem::FootResolution &resolution)
{
  Study study;
  study.contact.body = BodyKind::solid;
  study.glass.profile.shape = shape;
  study.contact.resolution = resolution;
  study.contact.load_harmonics = 8;
  return study;
}

/// A section with re-entrant corners that lifts off a mat, under a given moment.
Study step_on_mat(double foundation_modulus)
{
  Study study = solid_study(fem::GlassShape::step, { 24, 2, 1 });
  study.contact.refinements = 1;
  study.contact.load_harmonics = 12;
  study.table.foundation_modulus = foundation_modulus;
  study.load.moment_ratio = 1.2;
  return study;
}

/// A flat land of 2 mm on a hard table, under a given moment.
Study flat_land(double moment_ratio)
{
  Study study = solid_study(fem::GlassShape::step, { 24, 4, 2 });
  study.glass.profile.land_width = 0.002;
  study.glass.profile.crown_radius = 0;
  study.table.interface = TableInterface::hard;
  study.load.moment_ratio = moment_ratio;
  study.contact.friction_coupling = FrictionCoupling::none;
  return study;
}

void expect_band_of_flat_land(double moment_ratio)
{
  const Study study = flat_land(moment_ratio);
  const ErrorBands solid = bands_of(study), revolution = bands_of(revolved(study));
  for (const char *key : { "omega_terminal", "tau_at_spin_1", "a2", "b3", "a4", "b5", "a6", "b7", "a8" })
    expect_within_both(solid, revolution, key);
  EXPECT_GT(solid[index_of(solid, "a2")].parts.at("interface"), 0);
  EXPECT_LT(solid[index_of(solid, "a4")].band, 1e-2); // of a_0
}

/// Terminal spin of the mean torque over the phases [rad/s].
double mean_spin(const Study &study)
{
  fem::ComplianceCache cache;
  const SharedLoad load = find_load(study, study_foot(study, cache));
  return ring::answer(*load, { study.motion.orbit }).value().zero_of_mean_torque;
}

} // namespace

// The loads on the other mesh are found at rest and at one spin only. Oracle: the study on that mesh, solved
// at every spin.
TEST(SolidBands, OfAnOvalMeshAreTheChangeOfTheTerminalSpin)
{
  Study study;
  study.contact.body = BodyKind::solid;
  study.contact.mesh_file = STEMWARE_MESHES "/oval_foot.msh";
  study.contact.degree = 1;
  study.contact.load_harmonics = 8;
  study.contact.friction_coupling = FrictionCoupling::none;
  study.table.foundation_modulus = 2e9;
  const ErrorBands bands = bands_of(study);
  const double part = bands[index_of(bands, "omega_terminal")].parts.at("degree");
  const double before = mean_spin(study);
  study.contact.degree = 2;
  const double change = std::abs(mean_spin(study) - before);
  EXPECT_GE(part, change);
  EXPECT_LE(part, 1.5 * change);
}

// In balance with friction and tilt, the mesh being the coarsest that there is: its band is that of halved
// cells. The contact is a twentieth of a cell wide, so that more rings would be extrapolated to its nodes.
TEST(SolidBands, OfAFootOnAMatLong)
{
  Study study = solid_study(fem::GlassShape::foot, { 24, 2, 1 });
  study.table.foundation_modulus = 1e12;
  const ErrorBands solid = bands_of(study), revolution = bands_of(revolved(study));
  expect_within_both(solid, revolution, "omega_terminal", 30);
  expect_within_both(solid, revolution, "a2", 30);
  expect_within_both(solid, revolution, "tau_at_spin_1");
}

// The same of linear elements, under a given moment: in seconds.
TEST(SolidBands, OfALinearFootOnAMat)
{
  Study study = solid_study(fem::GlassShape::foot, { 16, 2, 1 });
  study.contact.degree = 1;
  study.load.moment_ratio = 0.6;
  study.contact.friction_coupling = FrictionCoupling::none;
  Study finer = revolved(study);
  finer.contact.degree = 2;
  const ErrorBands solid = bands_of(study), revolution = bands_of(finer);
  for (const char *key : { "omega_terminal", "a2", "b3", "tau_at_spin_1" })
    expect_within_both(solid, revolution, key, 30);
}

// Counts of cells that have no half: the coarser mesh has cells 1.5 times as large across the land.
TEST(SolidBands, OfCountsOfCellsThatDoNotHalve)
{
  Study study = solid_study(fem::GlassShape::foot, { 16, 6, 2 });
  study.load.moment_ratio = 0.6;
  study.contact.friction_coupling = FrictionCoupling::none;
  const ErrorBands solid = bands_of(study), revolution = bands_of(revolved(study));
  for (const char *key : { "omega_terminal", "a2", "b3" })
    expect_within_both(solid, revolution, key, 30);
  expect_within_both(solid, revolution, "tau_at_spin_1");
}

// With re-entrant corners, where the error falls with the first order; its band is that of cells twice as
// large.
TEST(SolidBands, OfAStepOnAMatLong)
{
  const Study study = step_on_mat(1e11);
  const ErrorBands solid = bands_of(study), revolution = bands_of(revolved(study));
  for (const char *key : { "omega_terminal", "a2", "b3", "a4" })
    expect_within_both(solid, revolution, key, 30);
  expect_within_both(solid, revolution, "tau_at_spin_1");
}

// The contact is a hundredth of a cell wide: what halving the cells changes is a small part of the error.
TEST(SolidBands, OfAContactThatIsNarrowerThanItsCellsLong)
{
  Study study = step_on_mat(1e15);
  study.contact.friction_coupling = FrictionCoupling::none;
  const ErrorBands solid = bands_of(study), revolution = bands_of(revolved(study, 0));
  for (const char *key : { "omega_terminal", "a2", "b3", "a4" })
    expect_within_both(solid, revolution, key, 30);
  expect_within_both(solid, revolution, "tau_at_spin_1");
}

// Of linear elements, in seconds.
TEST(SolidBands, OfALinearFlatLandOnAHardTable)
{
  Study study = flat_land(0.5);
  study.contact.resolution = { 16, 2, 1 };
  study.contact.degree = 1;
  Study finer = revolved(study);
  finer.contact.degree = 2;
  const ErrorBands solid = bands_of(study), revolution = bands_of(finer);
  for (const char *key : { "omega_terminal", "tau_at_spin_1", "a2", "b3", "a4" })
    expect_within_both(solid, revolution, key);
  EXPECT_GT(solid[index_of(solid, "a2")].parts.at("interface"), 0);
  EXPECT_LT(solid[index_of(solid, "a2")].band, 0.1); // of a_0
}

TEST(SolidBands, OfAFlatLandOnAHardTableLong)
{
  expect_band_of_flat_land(0.5);
}

TEST(SolidBands, OfAFlatLandThatLiftsOffAHardTableLong)
{
  expect_band_of_flat_land(1.2);
}

} // namespace stemware::pipeline
