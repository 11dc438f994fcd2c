// References: a refined body of revolution with its own error bands; LiftedSquare for a rigid plate, which
// has no rotational symmetry. Runs with MPI.
#include "fem/pipeline/analysis/error_bands.h"
#include "fem/pipeline/analysis/threaded_executor.h"
#include "fem/pipeline/coupling/make_foot.h"
#include "fem/pipeline/coupling/study_load.h"
#include "ring_model/spin/answer.h"
#include "tests/fem/pipeline/mat_study.h"
#include "tests/verification/lifted_square.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <string>

namespace stemware::pipeline
{

namespace
{

ErrorBands bands_of(const Study &study)
{
  fem::ComplianceCache cache;
  const std::shared_ptr<ElasticFoot> foot = study_foot(study, foot_maker(cache));
  const BalancedLoad load = find_load(study, foot);
  ring::Question question = { study.motion.orbit };
  question.with_slope = true;
  return estimate_bands({ study, foot, ThreadedExecutor(cache) }, ring::answer(load, question).value(),
                        std::nullopt);
}

Study revolved(Study study, unsigned int refinements = 1)
{
  study.contact.body = BodyKind::revolution;
  study.contact.resolution = {};
  study.contact.refinements = refinements;
  study.contact.harmonics = 24;
  return study;
}

/// Expects that the two values of @p key agree within the sum of their error bands. @p widest: largest
/// accepted ratio of the solid foot's error band to the difference of the two values; 0: no limit, because
/// the difference may vanish by chance.
void expect_within_both(const ErrorBands &solid, const ErrorBands &revolution, const std::string &key,
                        double widest = 0)
{
  const BandedQuantity &own = solid[index_of(solid, key)], &other = revolution[index_of(revolution, key)];
  const double difference = std::abs(own.quantity.value - other.quantity.value);
  ::testing::Test::RecordProperty(key, std::to_string(own.band / difference));
  EXPECT_LE(difference, own.band + other.band) << key;
  EXPECT_LT(other.band, own.band) << key; // the reference must be more accurate
  if (widest > 0)
  {
    EXPECT_LT(own.band, widest * difference) << key;
  }
}

Study solid_study(fem::GlassShape shape, const fem::FootResolution &resolution)
{
  Study study = test::mat_study();
  study.contact.body = BodyKind::solid;
  study.glass.profile.shape = shape;
  study.contact.resolution = resolution;
  study.contact.load_harmonics = 8;
  return study;
}

Study step_on_mat(double foundation_modulus)
{
  Study study = solid_study(fem::GlassShape::step, { 24, 2, 1 });
  study.contact.refinements = 1;
  study.contact.load_harmonics = 12;
  study.table.foundation_modulus = foundation_modulus;
  study.load.moment_ratio = 1.2;
  return study;
}

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

void expect_bands_of_mat(const Study &study, const Study &reference, const std::vector<const char *> &keys)
{
  const ErrorBands solid = bands_of(study), revolution = bands_of(reference);
  for (const char *key : keys)
    expect_within_both(solid, revolution, key, 30);
  expect_within_both(solid, revolution, "tau_at_spin_1");
}

void expect_band_of_flat_land(double moment_ratio)
{
  const Study study = flat_land(moment_ratio);
  const ErrorBands solid = bands_of(study), revolution = bands_of(revolved(study));
  for (const char *key : { "omega_terminal", "tau_at_spin_1", "a2", "b3", "a4", "b5", "a6", "b7", "a8" })
    expect_within_both(solid, revolution, key);
  EXPECT_GT(solid[index_of(solid, "a2")].parts.at("interface"), 0);
  EXPECT_LT(solid[index_of(solid, "a4")].band, 1e-2); // relative to a_0
}

/// Returns a study of a foot from a mesh file: linear elements, on a mat, without friction coupling.
Study study_of_mesh(const std::string &file)
{
  Study study = test::mat_study();
  study.contact.body = BodyKind::solid;
  study.contact.mesh_file = STEMWARE_MESHES "/" + file;
  study.contact.degree = 1;
  study.contact.load_harmonics = 8;
  study.contact.friction_coupling = FrictionCoupling::none;
  return study;
}

/// Returns a study of the nearly rigid square plate of docs/verification on a mat. The load acts at @p
/// eccentricity [m] in the direction @p direction [rad].
Study plate_on_mat(double eccentricity, double direction)
{
  Study study = study_of_mesh("square_plate.msh");
  study.glass.profile.contact_radius = 1.2071067811865476;
  study.glass.material.young_modulus = 1e14;
  study.table.foundation_modulus = 8000;
  study.motion.orbit.mass = 4;
  study.motion.orbit.gravity = 10;
  study.motion.orbit.yaw_inertia = 2.67;
  study.load.moment_ratio = 2 * eccentricity / study.glass.profile.contact_radius;
  study.load.moment_direction = direction;
  return study;
}

void expect_bands_of_plate(double eccentricity, double direction)
{
  const Study study = plate_on_mat(eccentricity, direction);
  const double per_mat =
    study.motion.orbit.mass * study.motion.orbit.gravity / study.table.foundation_modulus;
  const verification::LiftedSquare plate(eccentricity *
                                         Eigen::Vector2d(std::cos(direction), std::sin(direction)));
  std::map<std::string, double> truth = { { "contact_fraction", plate.share() },
                                          { "peak_pressure",
                                            plate.peak() * per_mat * study.table.foundation_modulus } };
  for (unsigned int i = 0; i < 3; ++i)
    truth["table_motion_" + std::to_string(i)] = -per_mat * plate.motion(i);
  for (unsigned int n = 1; n <= 6; ++n)
  {
    truth["a" + std::to_string(n)] = plate.harmonic(n, false);
    truth["b" + std::to_string(n)] = plate.harmonic(n, true);
  }
  for (const BandedQuantity &banded : bands_of(study))
    if (const auto found = truth.find(banded.quantity.key); found != truth.end())
    {
      const double error = std::abs(banded.quantity.value - found->second);
      EXPECT_LE(error, banded.band) << banded.quantity.key << " at " << eccentricity << " m, " << direction;
      truth.erase(found);
    }
  EXPECT_TRUE(truth.empty()) << truth.begin()->first << " has no band";
}

/// Returns the spin at which the mean torque over the phases of the foot vanishes [rad/s].
double mean_spin(const Study &study)
{
  fem::ComplianceCache cache;
  const BalancedLoad load = find_load(study, study_foot(study, foot_maker(cache)));
  return ring::answer(load, { study.motion.orbit }).value().terminal->evaluated_at;
}

} // namespace

// The error band compares degree 1 with degree 2 at rest and at one spin. Reference: degree 2 at every spin.
TEST(SolidBands, DegreePartContainsTheSpinChangeFromDegreeOneToTwoOnAnOvalMesh)
{
  Study study = study_of_mesh("oval_foot.msh");
  study.table.foundation_modulus = 2e9;
  const ErrorBands bands = bands_of(study);
  const double part = bands[index_of(bands, "omega_terminal")].parts.at("degree");
  const double before = mean_spin(study);
  study.contact.degree = 2;
  const double change = std::abs(mean_spin(study) - before);
  EXPECT_GE(part, change);
  EXPECT_LE(part, 1.5 * change);
}

// The displacement of a rigid plate is exact on every mesh. The only error comes from the integration of the
// pressure, which has a kink at the contact edge inside the element faces. The band must therefore come from
// the variant with another number of contact lines.
TEST(SolidBands, ContainTheErrorOfAPlateWithLiftOff)
{
  for (const double eccentricity : { 0.62, 0.55 })
    expect_bands_of_plate(eccentricity, std::acos(0.));
  std::mt19937 random(59);
  for (unsigned int i = 0; i < 3; ++i)
  {
    const double eccentricity = 0.35 + 0.35 * static_cast<double>(random()) / 4294967296.,
                 direction = 6.28 * static_cast<double>(random()) / 4294967296.;
    expect_bands_of_plate(eccentricity, direction);
  }
}

// Moment balance with friction and tilt. The mesh is the coarsest possible one, so the error band comes from
// halved cells. The contact is a twentieth of a cell wide.
TEST(SolidBands, ContainTheErrorOfAFootOnAMatLong)
{
  Study study = solid_study(fem::GlassShape::foot, { 24, 2, 1 });
  study.table.foundation_modulus = 1e12;
  expect_bands_of_mat(study, revolved(study), { "omega_terminal", "a2" });
}

// Short version of ContainTheErrorOfAFootOnAMatLong: linear elements and a given moment.
TEST(SolidBands, ContainTheErrorOfLinearElementsOnAMat)
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

// The error band comes from a mesh with half as many cells. The number of cells across the land must be even,
// so the coarser mesh has 4 of them instead of 3.
TEST(SolidBands, ContainTheErrorIfHalfTheNumberOfRadialCellsIsOdd)
{
  Study study = solid_study(fem::GlassShape::foot, { 16, 6, 2 });
  study.load.moment_ratio = 0.6;
  study.contact.friction_coupling = FrictionCoupling::none;
  expect_bands_of_mat(study, revolved(study), { "omega_terminal", "a2", "b3" });
}

// At re-entrant corners the error is of first order. The error band comes from cells of twice the size.
TEST(SolidBands, ContainTheErrorOfAStepShapedFootOnAMatLong)
{
  const Study study = step_on_mat(1e11);
  expect_bands_of_mat(study, revolved(study), { "omega_terminal", "a2", "b3", "a4" });
}

// The contact is a hundredth of a cell wide, so one halving of the cells hardly reduces the error.
TEST(SolidBands, ContainTheErrorOfAContactNarrowerThanItsCellsLong)
{
  Study study = step_on_mat(1e15);
  study.contact.friction_coupling = FrictionCoupling::none;
  expect_bands_of_mat(study, revolved(study, 0), { "omega_terminal", "a2", "b3", "a4" });
}

// Short version of ContainTheErrorOfAFlatLandOnAHardTableLong: linear elements.
TEST(SolidBands, ContainTheErrorOfLinearElementsForAFlatLandOnAHardTable)
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
  EXPECT_LT(solid[index_of(solid, "a2")].band, 0.1); // relative to a_0
}

TEST(SolidBands, ContainTheErrorOfAFlatLandOnAHardTableLong)
{
  expect_band_of_flat_land(0.5);
}

TEST(SolidBands, ContainTheErrorOfAFlatLandWithLiftOffOnAHardTableLong)
{
  expect_band_of_flat_land(1.2);
}

} // namespace stemware::pipeline
