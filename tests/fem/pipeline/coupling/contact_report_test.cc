// What a study says about its contact: the friction of the pressure where it lies, at the state that it is
// named after.
#include "fem/pipeline/analysis/spin.h"
#include "fem/pipeline/coupling/contact_report.h"
#include "fem/pipeline/coupling/study_load.h"

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

TEST(ContactReport, LoadAtTheTerminalSpinIsThatOfThePressureThere)
{
  const Study study = coarse_study_in_balance();
  const ring::Motion &motion = study.motion.orbit;
  const Described glass(study);
  const double scale = motion.friction_coefficient * motion.normal_force() * 0.03;
  // Its torque vanishes there, but for what the leaning axis takes; the pressure of rest would leave a
  // hundredth of the scale.
  const fem::ContactState spinning = glass.load.contact_at()(glass.omega);
  EXPECT_NEAR(friction_of(glass, spinning, study, glass.omega).torque,
              -glass.load.leaning(glass.omega).lean_torque(), 1e-8 * scale);
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
