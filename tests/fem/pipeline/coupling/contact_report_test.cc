// Reference: sums over the point forces.
#include "fem/contact/sliding_traction.h"
#include "fem/pipeline/analysis/study_rows.h"
#include "fem/pipeline/coupling/contact_report.h"
#include "fem/pipeline/coupling/make_foot.h"
#include "fem/pipeline/coupling/study_load.h"
#include "ring_model/friction_functionals.h"
#include "ring_model/spin/answer.h"
#include "tests/fem/pipeline/mat_study.h"
#include "tests/verification/plain_rigid_foot.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace stemware::pipeline
{
namespace
{

Study coarse_study_in_balance()
{
  Study study = test::mat_study();
  study.contact.harmonics = 6;
  study.contact.azimuth_lines = 64;
  study.load.coupling = LoadCoupling::two_way;
  return study;
}

struct Described
{
  explicit Described(const Study &study)
      : foot(study_foot(study, foot_maker(cache)))
      , load(find_load(study, foot))
      , omega(ring::answer(load, { study.motion.orbit }).omega_terminal().value())
      , report(describe(foot, load, omega))
  {
  }

  fem::ComplianceCache cache;
  std::shared_ptr<ElasticFoot> foot;
  BalancedLoad load;
  double omega;
  ContactReport report;
};

/// Returns the friction of a contact solution as the sum of point forces, without rings and kernels.
ring::Wrench friction_of(const Described &glass, const fem::ContactState &contact, const Study &study,
                         double omega)
{
  ring::Wrench friction = {};
  for (const fem::PointForce &point : glass.foot->body().point_forces(contact))
  {
    const Eigen::Vector2d force =
      fem::coulomb_friction({ study.motion.orbit.orbit_speed - omega * point.y, omega * point.x },
                            study.motion.orbit.friction_coefficient * point.force);
    friction.force_x += force(0);
    friction.force_y += force(1);
    friction.torque += point.x * force(1) - point.y * force(0);
  }
  return friction;
}

/// Returns the forces and moments on the glass from the point forces. The contact solution describes the tilt
/// of the table under an upright glass, so the glass leans by the opposite angles.
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

TEST(ContactReport, MomentsBalanceAndTheLeanTorqueAgreesWithSumsAtFourSpins)
{
  const Study study = coarse_study_in_balance();
  const Described glass(study);
  const double weight = study.motion.orbit.normal_force(), rim = study.glass.profile.contact_radius;
  const double scale = study.motion.orbit.friction_coefficient * weight * rim;
  for (const double omega : { 0., glass.omega / 2, glass.omega, 5. })
  {
    const verification::PlainGlass plain = plain_glass(glass, *glass.load.contact(omega), study, omega);
    EXPECT_NEAR(plain.moment.head<2>().norm(), 0, 1e-8 * weight * rim) << omega;
    // The lean torque, about 2e-6 of the scale, is above the rounding error.
    const double lean = plain.axial_torque - plain.friction_torque;
    EXPECT_GT(std::abs(lean), 1e-6 * scale) << omega;
    EXPECT_NEAR(glass.load.at(omega).lean_torque() / lean, 1, 1e-3) << omega;
  }
  const fem::ContactState spinning = *glass.load.contact(glass.omega);
  EXPECT_NEAR(plain_glass(glass, spinning, study, glass.omega).axial_torque, 0, 1e-8 * scale);
}

TEST(ContactReport, FrictionTorqueVanishesAndTheLoadAgreesWithThePressureAtTheTerminalSpin)
{
  const Study study = coarse_study_in_balance();
  const ring::Motion &motion = study.motion.orbit;
  const Described glass(study);
  const double scale = motion.friction_coefficient * motion.normal_force() * 0.03;
  // The friction torque vanishes with the pressure at the terminal spin, but not with the pressure at rest.
  const fem::ContactState spinning = *glass.load.contact(glass.omega);
  EXPECT_NEAR(friction_of(glass, spinning, study, glass.omega).torque, 0, 1e-5 * scale);
  const fem::ContactState &rest = glass.report.foot->at_rest;
  EXPECT_GT(std::abs(friction_of(glass, rest, study, glass.omega).torque), 1e-2 * scale);
  const LoadReport &at_terminal = glass.report.load_at_end;
  EXPECT_NEAR((at_terminal.moment() - spinning.load.moment()).norm(), 0, 1e-9 * motion.normal_force() * 0.03);
  EXPECT_GT((at_terminal.moment() - glass.report.load.moment()).norm(), 1e-3 * motion.normal_force() * 0.03);
}

TEST(ContactReport, LoadReportAgreesWithSumsOverThePressure)
{
  // On a flat land, the mean radius of the load differs from the radius of the ring with the same moment.
  Study study = coarse_study_in_balance();
  study.glass.profile.crown_radius = 0;
  const Described glass(study);
  const double rim = study.glass.profile.contact_radius;
  const auto check = [&](const LoadReport &load, const fem::ContactState &contact, double moment_ratio)
  {
    double force = 0, first_moment = 0;
    Eigen::Vector2d centre = Eigen::Vector2d::Zero();
    for (const fem::PointForce &point : glass.foot->body().point_forces(contact))
    {
      force += point.force;
      first_moment += point.force * std::hypot(point.x, point.y);
      centre += point.force * Eigen::Vector2d(point.x, point.y);
    }
    EXPECT_NEAR(load.mean_radius, first_moment / force, 1e-9 * rim);
    EXPECT_GT(std::abs(load.radius() - load.mean_radius), 1e-7 * rim);
    EXPECT_NEAR(load.moment_ratio, 2 * centre.norm() / (force * rim), 1e-8);
    EXPECT_NEAR(moment_ratio, 2 * centre.norm() / (force * rim), 1e-8);
  };
  const ring::Answer row = ring::answer(glass.load, spin_question(study)).value();
  const fem::ContactState spinning = *glass.load.contact(glass.omega);
  check(glass.report.load, glass.report.foot->at_rest, row.at_rest->moment_ratio);
  check(glass.report.load_at_end, spinning, row.at_terminal->moment_ratio);
  EXPECT_GT(std::abs(row.at_terminal->moment_ratio - row.at_rest->moment_ratio), 1e-3);
}

TEST(ContactReport, DeformationByFrictionDependsOnOmegaOverV)
{
  // Reference: the foot under the balanced force and moment, with the friction of a given omega / v.
  const Study study = coarse_study_in_balance();
  const Described glass(study);
  const double speed = study.motion.orbit.orbit_speed;
  const fem::ContactLoad balanced = glass.load.contact(glass.omega)->load;
  const auto difference_to = [&](double spin_per_speed)
  {
    fem::ComplianceCache cache;
    const auto foot = study_foot(study, foot_maker(cache));
    const fem::ContactState pressed = foot->solve(
      { balanced.normal_force(), balanced.moment().x(), balanced.moment().y() }, { spin_per_speed, {} });
    const fem::ContactLoad load = foot->body().project_onto_rings(pressed, balanced.radii(), 4);
    double largest = 0;
    for (unsigned int n = 0; n <= 4; ++n)
    {
      double a = 0, b = 0, mean = 0;
      for (std::size_t j = 0; j < load.rings().size(); ++j)
      {
        a += load.rings()[j].a[n] - balanced.rings()[j].a[n];
        b += load.rings()[j].b[n] - balanced.rings()[j].b[n];
        mean += balanced.rings()[j].a[0];
      }
      largest = std::max(largest, std::hypot(a, b) / mean);
    }
    return largest;
  };
  EXPECT_LT(difference_to(glass.omega / speed), 1e-8);
  EXPECT_GT(difference_to(glass.omega), 1e-6);
  EXPECT_GT(difference_to(-glass.omega / speed), 1e-6);
}

} // namespace
} // namespace stemware::pipeline
