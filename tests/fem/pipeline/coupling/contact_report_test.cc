// What a study says about its contact: the friction of the pressure where it lies, at the state that it is
// named after.
#include "fem/pipeline/analysis/spin.h"
#include "fem/pipeline/coupling/contact_report.h"
#include "fem/pipeline/coupling/study_load.h"
#include "tests/verification/plain_rigid_foot.h"

#include <gtest/gtest.h>

#include <cmath>

namespace stemware::pipeline
{
namespace
{

/// The default glass with few harmonics and lines, in balance at every spin.
Study coarse_study_in_balance()
{
  Study study;
  study.contact.harmonics = 6;
  study.contact.azimuth_lines = 64;
  study.load.coupling = LoadCoupling::two_way;
  return study;
}

struct Described
{
  explicit Described(const Study &study)
      : foot(study_foot(study, cache))
      , load(find_load(study, foot))
      , omega(terminal_spin(load, study.motion.orbit).spin.omega)
      , report(describe(study, foot, load, omega))
  {
  }

  fem::ComplianceCache cache;
  std::shared_ptr<ElasticFoot> foot;
  BalancedLoad load;
  double omega;
  ContactReport report;
};

/// Friction of a contact by point forces, without rings and kernels.
fem::ResolvedFriction friction_of(const Described &glass, const fem::ContactState &contact,
                                  const Study &study, double omega)
{
  return fem::resolved_friction(glass.foot->body().point_forces(contact),
                                study.motion.orbit.friction_coefficient, omega,
                                study.motion.orbit.orbit_speed);
}

/// All forces on the glass and their moments in three dimensions, from the pressure where it lies and the
/// table's tilts in the frame of the glass, whose axis leans the other way.
verification::PlainGlass plain_glass(const Described &glass, const fem::ContactState &contact,
                                     const Study &study, double omega)
{
  const ring::Motion &motion = study.motion.orbit;
  std::vector<verification::PlainPoint> points;
  for (const fem::PointForce &point : glass.foot->body().point_forces(contact))
    points.push_back({ point.x, point.y, point.force });
  const Eigen::Vector2d tilt = contact.solution.motion.tail<2>();
  return { points,
           { 0, -tilt.x(), -tilt.y() },
           omega,
           { motion.mass, motion.yaw_inertia, motion.centre_of_mass_height, motion.force_offset,
             motion.orbit_radius, motion.orbit_speed, motion.friction_coefficient, motion.gravity } };
}

TEST(ContactReport, ForcesHoldTheGlassUprightAtEverySpinAndTurnItAboutItsAxis)
{
  // Elastic foot, tilt, friction that deforms it. Reference: sums over points in three dimensions.
  const Study study = coarse_study_in_balance();
  const Described glass(study);
  const double weight = study.motion.orbit.normal_force(), rim = study.glass.profile.contact_radius;
  const double scale = study.motion.orbit.friction_coefficient * weight * rim;
  for (const double omega : { 0., glass.omega / 2, glass.omega, 5. })
  {
    const verification::PlainGlass plain = plain_glass(glass, glass.load.contact_at()(omega), study, omega);
    EXPECT_NEAR(plain.moment.head<2>().norm(), 0, 1e-8 * weight * rim) << omega;
    // The lean torque is 2e-6 of the scale.
    const double lean = plain.axial_torque - plain.friction_torque;
    EXPECT_GT(std::abs(lean), 1e-6 * scale) << omega;
    EXPECT_NEAR(glass.load.leaning(omega).lean_torque() / lean, 1, 1e-3) << omega;
  }
  const fem::ContactState spinning = glass.load.contact_at()(glass.omega);
  EXPECT_NEAR(plain_glass(glass, spinning, study, glass.omega).axial_torque, 0, 1e-8 * scale);
}

TEST(ContactReport, LoadAtTheTerminalSpinIsThatOfThePressureThere)
{
  const Study study = coarse_study_in_balance();
  const ring::Motion &motion = study.motion.orbit;
  const Described glass(study);
  const double scale = motion.friction_coefficient * motion.normal_force() * 0.03;
  // The pressure of rest would leave a hundredth of the scale.
  const fem::ContactState spinning = glass.load.contact_at()(glass.omega);
  EXPECT_NEAR(friction_of(glass, spinning, study, glass.omega).torque, 0, 1e-5 * scale);
  const fem::ContactState &rest = glass.report.foot->at_rest;
  EXPECT_GT(std::abs(friction_of(glass, rest, study, glass.omega).torque), 1e-2 * scale);
  const LoadReport &at_terminal = glass.report.load_at_end;
  EXPECT_NEAR((at_terminal.moment - Eigen::Vector2d(spinning.load.moment_x, spinning.load.moment_y)).norm(),
              0, 1e-9 * motion.normal_force() * 0.03);
  EXPECT_GT((at_terminal.moment - glass.report.load.moment).norm(), 1e-3 * motion.normal_force() * 0.03);
  // At rest friction is -mu N along the direction of travel, whatever the pressure.
  EXPECT_NEAR(friction_of(glass, rest, study, 0).force_x,
              -motion.friction_coefficient * motion.normal_force(), 1e-9);
  EXPECT_NEAR(friction_of(glass, rest, study, 0).torque,
              motion.friction_coefficient * glass.report.load.moment.x(), 1e-9 * scale);
}

} // namespace
} // namespace stemware::pipeline
