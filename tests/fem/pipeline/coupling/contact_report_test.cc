// What a study says about its contact: the friction of the pressure where it lies, at the state that it is
// named after.
#include "fem/pipeline/analysis/spin.h"
#include "fem/pipeline/coupling/contact_report.h"
#include "fem/pipeline/coupling/study_load.h"
#include "fem/pipeline/study/waviness_text.h"

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

TEST(ContactReport, FrictionAtTheTerminalSpinIsThatOfThePressureThere)
{
  const Study study = coarse_study_in_balance();
  const ring::Motion &motion = study.motion.orbit;
  const Described glass(study);
  const FootReport &foot = *glass.report.foot;
  const double scale = motion.friction_coefficient * motion.normal_force() * 0.03;
  // The torque vanishes, but for the width of the contact; the pressure of rest would leave a hundredth of
  // the scale.
  EXPECT_LT(std::abs(foot.friction_at_terminal.torque), 1e-4 * scale);
  const fem::ResolvedFriction of_rest =
    fem::resolved_friction(glass.foot->body().point_forces(foot.at_rest), motion.friction_coefficient,
                           glass.omega, motion.orbit_speed);
  EXPECT_GT(std::abs(of_rest.torque), 1e-2 * scale);
  // At rest it is -mu N along the direction of travel, whatever the pressure.
  EXPECT_NEAR(foot.friction_at_rest.force_x, -motion.friction_coefficient * motion.normal_force(), 1e-9);
  EXPECT_NEAR(foot.friction_at_rest.torque, motion.friction_coefficient * glass.report.load.moment.x(),
              1e-9 * scale);
}

TEST(ContactReport, FrictionOfAWavyFootKeepsToCoulombsBound)
{
  Study study = coarse_study_in_balance();
  study.load.coupling = LoadCoupling::one_way;
  study.table.waviness = *parse_waviness("2: 5e-6");
  const FootReport foot = *Described(study).report.foot;
  const double bound = study.motion.orbit.friction_coefficient * study.motion.orbit.normal_force();
  const double force = std::hypot(foot.friction_at_terminal.force_x, foot.friction_at_terminal.force_y);
  EXPECT_LE(force, bound * (1 + 1e-9));
  EXPECT_GT(force, 0.5 * bound);
}

} // namespace
} // namespace stemware::pipeline
