// Moment balance and energy balance, which hold for every pressure distribution. The first test needs the
// linear pressure of a flat land on a mat.
#include "fem/pipeline/analysis/budget.h"
#include "fem/pipeline/coupling/make_foot.h"
#include "ring_model/friction_functionals.h"
#include "ring_model/spin/curves.h"
#include "tests/fem/pipeline/analysis/quick_studies.h"
#include "tests/fem/pipeline/analysis/solved_study.h"
#include "tests/fem/pipeline/mat_study.h"

#include <Eigen/Geometry>
#include <boost/math/quadrature/gauss.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace stemware::pipeline
{
namespace
{

using test::SolvedStudy;

bool is_loaded_everywhere(const SolvedStudy &solved)
{
  const fem::PressureMap map = solved.foot->body().pressure_map(*solved.load.contact(0));
  return std::all_of(map.cuts.begin(), map.cuts.end(),
                     [](const auto &cut)
                     {
                       return std::all_of(cut.begin(), cut.end(),
                                          [](const fem::PressurePoint &point) { return point.pressure > 0; });
                     });
}

TEST(Balance, HarmonicsHaveNoEffectOnAFlatLandOnAMat)
{
  for (const LoadCoupling coupling : { LoadCoupling::one_way, LoadCoupling::two_way })
  {
    const SolvedStudy solved(test::flat_land_on_a_mat(coupling));
    EXPECT_EQ(solved.load.report().contact_fraction, 1);
    EXPECT_TRUE(is_loaded_everywhere(solved));
    fem::ComplianceCache cache;
    const SpinStudy spin = test::whole_spin_study(solved.study, ThreadedExecutor(cache));
    EXPECT_NEAR(*harmonic_effect(spin.rows).absolute, 0, 1e-9);
    EXPECT_NEAR(*harmonic_effect(spin.rows).relative, 0, 1e-9);
    EXPECT_NEAR(*find_budget(spin.rows).rows.back().omega_terminal, solved.omega(), 1e-9);
  }
}

struct Surface
{
  const char *name;
  TableInterface interface;
  TableSubstrate substrate;
};

std::ostream &operator<<(std::ostream &stream, const Surface &surface)
{
  return stream << surface.name;
}

const Surface surfaces[] = { { "WinklerOnRigid", TableInterface::winkler, TableSubstrate::rigid },
                             { "WinklerOnElastic", TableInterface::winkler, TableSubstrate::elastic },
                             { "RoughOnRigid", TableInterface::rough, TableSubstrate::rigid },
                             { "RoughOnElastic", TableInterface::rough, TableSubstrate::elastic },
                             { "HardOnRigid", TableInterface::hard, TableSubstrate::rigid },
                             { "HardOnElastic", TableInterface::hard, TableSubstrate::elastic } };

class BalanceOnTables : public testing::TestWithParam<Surface>
{
};

INSTANTIATE_TEST_SUITE_P(Tables, BalanceOnTables, testing::ValuesIn(surfaces),
                         [](const auto &info) { return std::string(info.param.name); });

Study study_on(const Surface &surface)
{
  Study study = test::mat_study();
  study.table.interface = surface.interface;
  study.table.substrate = surface.substrate;
  study.contact.azimuth_lines = 64;
  return study;
}

TEST_P(BalanceOnTables, FrictionTorqueAtRestIsMuTimesTheMomentAboutX)
{
  // Friction torque at rest: friction coefficient times moment_x. The moment is in balance with the force F
  // of the hand, the friction force T and the weight of the tilted glass. Unit vector k: vertical.
  for (const bool tilt : { true, false })
  {
    Study study = study_on(GetParam());
    study.motion.tilt = tilt;
    fem::ComplianceCache cache;
    const BalancedLoad load = find_load(study, study_foot(study, foot_maker(cache)));
    const ring::Motion &motion = study.motion.orbit;
    const ring::Sample rest = load.at(0);
    const ring::Wrench friction =
      ring::coulomb_wrench(motion.friction_coefficient, rest, 0, motion.orbit_speed);
    const Eigen::Vector3d T(friction.force_x, friction.force_y, 0), k(0, 0, 1),
      F = Eigen::Vector3d(0, motion.mass * motion.orbit_speed * motion.orbit_speed / motion.orbit_radius, 0) -
          T;
    const double arm = motion.centre_of_mass_height, weight = motion.normal_force();
    const Eigen::Vector3d moment = -motion.force_offset * k.cross(F) + arm * k.cross(T) +
                                   weight * arm * Eigen::Vector3d(-rest.tilt.y(), rest.tilt.x(), 0);
    EXPECT_EQ(rest.tilt.norm() > 0, tilt);
    const double scale = motion.friction_coefficient * weight * study.glass.profile.contact_radius;
    EXPECT_NEAR(friction.torque, motion.friction_coefficient * moment.x(), 1e-10 * scale) << tilt;
  }
}

double coefficient_at(const ring::Motion &motion, double slip_speed)
{
  if (motion.friction_law == ring::FrictionLawKind::coulomb)
    return motion.friction_coefficient;
  return motion.friction_coefficient +
         (motion.static_coefficient - motion.friction_coefficient) *
           std::exp(-std::pow(slip_speed / motion.friction_decay_speed, 2)) +
         motion.viscous_friction * slip_speed;
}

/// Expects the energy balance without tilt: the work of the hand equals the kinetic energy of the spin plus
/// the friction heat, which is the time integral of the sum of friction coefficient * normal force * slip
/// speed over all points.
void expect_energy_balance(Study study)
{
  study.motion.tilt = false;
  const SolvedStudy solved(study);
  const ring::Motion &motion = study.motion.orbit;
  constexpr double end = 0.3; // final time [s]; the glass then has more than half of its terminal spin
  using Quadrature = boost::math::quadrature::gauss<double, 20>;
  std::vector<double> times = { 0 }, weights = { 0 };
  for (int side = -1; side <= 1; side += 2)
    for (std::size_t i = 0; i < Quadrature::abscissa().size(); ++i)
    {
      const std::size_t place = side < 0 ? Quadrature::abscissa().size() - 1 - i : i;
      times.push_back(end / 2 * (1 + side * Quadrature::abscissa()[place]));
      weights.push_back(end / 2 * Quadrature::weights()[place]);
    }
  times.push_back(end);
  weights.push_back(0);
  const double terminal = solved.omega();
  const std::vector<ring::YawSample> spins =
    ring::spin_up(solved.load.interpolated(1.05 * terminal, -0.05 * terminal), { motion }, times);
  double work = 0, heat = 0;
  for (std::size_t i = 0; i < times.size(); ++i)
    if (weights[i] > 0)
    {
      const double omega = spins[i].omega;
      work -= weights[i] * motion.orbit_speed * ring::wrench(motion, solved.load.at(omega), omega).force_x;
      double power = 0;
      for (const fem::PointForce &point : solved.foot->body().point_forces(*solved.load.contact(omega)))
      {
        const double slip_speed = std::hypot(motion.orbit_speed - omega * point.y, omega * point.x);
        power += coefficient_at(motion, slip_speed) * point.force * slip_speed;
      }
      heat += weights[i] * power;
    }
  const double omega = spins.back().omega;
  EXPECT_GT(omega / terminal, 0.5);
  EXPECT_NEAR(work, motion.yaw_inertia * omega * omega / 2 + heat, 1e-7 * work);
}

TEST_P(BalanceOnTables, WorkOfTheHandIsKineticEnergyPlusFrictionHeat)
{
  expect_energy_balance(study_on(GetParam()));
}

TEST(BalanceWithStribeck, WorkOfTheHandIsKineticEnergyPlusFrictionHeat)
{
  for (const Surface &surface : { surfaces[0], surfaces[3] })
  {
    Study study = study_on(surface);
    study.motion.orbit.friction_law = ring::FrictionLawKind::stribeck;
    study.motion.orbit.friction_coefficient = 0.25;
    study.motion.orbit.static_coefficient = 0.35;
    study.motion.orbit.friction_decay_speed = 0.3;
    study.motion.orbit.viscous_friction = 0.02;
    expect_energy_balance(study);
  }
}

} // namespace
} // namespace stemware::pipeline
