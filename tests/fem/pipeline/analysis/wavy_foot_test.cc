// Wavy rigid foot on a Winkler mat. Reference: sums over points by independent code (plain_rigid_foot.h).
#include "fem/pipeline/analysis/error_bands.h"
#include "fem/pipeline/analysis/spin_study.h"
#include "fem/pipeline/analysis/threaded_executor.h"
#include "ring_model/friction_functionals.h"
#include "ring_model/load/constants.h"
#include "ring_model/spin/answer.h"
#include "tests/fem/pipeline/analysis/solved_study.h"
#include "tests/fem/pipeline/mat_study.h"
#include "tests/verification/plain_rigid_foot.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <random>
#include <vector>

namespace stemware::pipeline
{
namespace
{

using test::SolvedStudy;

/// Wavy foot on a soft mat in full contact, and its reference by sums over points.
struct WavyFoot
{
  explicit WavyFoot(unsigned int n_waves = 3, double amplitude = 5e-6, double modulus = 1e9,
                    double depth = 2.8e-5)
      : n_waves(n_waves)
      , amplitude(amplitude)
      , depth(depth)
      , plain(verification::PlainRigidFoot::on_mat(modulus))
  {
    study.table.foundation_modulus = modulus;
    study.glass.waviness = { { n_waves, amplitude, crest } };
    study.contact.azimuth_lines = 96;
    plain.n_azimuths = 16 * n_waves;
    const ring::Motion &orbit = study.motion.orbit;
    motion = { orbit.mass,         orbit.yaw_inertia, orbit.centre_of_mass_height, orbit.force_offset,
               orbit.orbit_radius, orbit.orbit_speed, orbit.friction_coefficient,  orbit.gravity };
  }

  void turn(double phase)
  {
    plain.wave = [this, phase](double theta)
    { return amplitude * std::cos(n_waves * (theta - phase - crest)); };
  }

  verification::PlainGlass at(double omega, std::vector<verification::PlainPoint> *points = nullptr)
  {
    position = verification::position_in_balance(plain, motion, omega, position, depth);
    const std::vector<verification::PlainPoint> forces = plain.forces(position);
    if (points)
      *points = forces;
    return { forces, position, omega, motion };
  }

  static constexpr double crest = 0.2; ///< azimuth of a high place [rad]

  unsigned int n_waves;
  double amplitude, depth;
  Study study = test::mat_study();
  verification::PlainRigidFoot plain;
  verification::PlainMotion motion = {};
  Eigen::Vector3d position = { depth, 0, 0 };
};

TEST(RigidFoot, WavyFootAgreesWithSumsOverPointsAtEveryPhase)
{
  WavyFoot foot;
  const SolvedStudy solved(foot.study, test::rigid_foot());
  const ring::Motion &motion = foot.study.motion.orbit;
  const double scale = motion.normal_force() * 0.03;
  double largest_lean = 0;
  for (const double phase : { 0., 0.5, 1.3, 4. })
    for (const double omega : { 0., -3.6, 7. })
    {
      foot.turn(phase);
      std::vector<verification::PlainPoint> points;
      const verification::PlainGlass expected = foot.at(omega, &points);
      const ring::Sample found = solved.load.at(omega, ring::Orientation{ phase, 0 });
      EXPECT_NEAR((found.moment() - expected.contact_moment.head<2>()).norm(), 0, 1e-6 * scale);
      for (unsigned int n = 2; n <= 5; ++n)
      {
        const double mean = found.a(0);
        EXPECT_NEAR(found.a(n) / mean, verification::harmonic_over_mean(points, n), 1e-5) << n;
        EXPECT_NEAR(found.b(n) / mean, verification::harmonic_over_mean(points, n, true), 1e-5) << n;
      }
      EXPECT_NEAR(ring::wrench(motion, found, omega).torque, expected.friction_torque, 1e-6 * scale);
      const double lean = expected.axial_torque - expected.friction_torque;
      EXPECT_NEAR(found.lean_torque(), lean, 2e-9 * scale) << phase << ", " << omega;
      largest_lean = std::max(largest_lean, std::abs(lean));
    }
  EXPECT_GT(largest_lean, 1e-7 * scale);
}

/// Returns the smallest load of all azimuths and 32 phases [N/rad] in full contact, where each azimuth has
/// equally many points, one after the other.
double least_load_of(WavyFoot &foot, double omega)
{
  foot.plain.n_azimuths = 360;
  double least = foot.study.motion.orbit.normal_force(); // above every minimum
  for (unsigned int i = 0; i < 32; ++i)
  {
    foot.turn(2 * ring::pi / foot.n_waves * i / 32);
    std::vector<verification::PlainPoint> points;
    foot.at(omega, &points);
    std::vector<double> loads(foot.plain.n_azimuths, 0.);
    for (std::size_t i = 0; i < points.size(); ++i)
      loads[i * loads.size() / points.size()] += points[i].force * foot.plain.n_azimuths / (2 * ring::pi);
    least = std::min(least, *std::min_element(loads.begin(), loads.end()));
  }
  return least;
}

TEST(RigidFoot, LeastLoadOfAWavyFootAgreesWithSumsOverPointsAtRestAndAtTheTerminalSpin)
{
  WavyFoot foot;
  const SolvedStudy solved(foot.study, test::rigid_foot());
  fem::ComplianceCache cache;
  const SpinStudy spin =
    study_spin({ solved.study, solved.foot, ThreadedExecutor(cache) }, solved.load, Depth::answer);
  const double at_rest = least_load_of(foot, 0);
  const double at_terminal = least_load_of(foot, *spin.answer().omega_terminal());
  const double mean = foot.study.motion.orbit.normal_force() / (2 * ring::pi);
  EXPECT_GT(std::abs(at_terminal - at_rest), 5e-3 * mean);
  EXPECT_EQ(spin.phases->least_load_is_at_rest, at_rest < at_terminal);
  EXPECT_NEAR(spin.phases->least_load, std::min(at_rest, at_terminal), 5e-4 * mean);
}

// With the hand at the height of the centre of mass the glass does not spin up.
TEST(RigidFoot, TimeConstantOfAWavyFootThatDoesNotSpinUpAgreesWithSumsOverPoints)
{
  WavyFoot foot;
  foot.study.motion.orbit.force_offset = foot.motion.force_offset = 0;
  const SolvedStudy solved(foot.study, test::rigid_foot());
  ring::Question with_slope;
  with_slope.with_slope = true;
  const ring::Answer row = ring::answer(solved.load, spin_question(foot.study, with_slope)).value();
  constexpr int n_phases = 8;
  const double step = 0.02; // [rad/s]
  double slope = 0;
  for (int i = 0; i < n_phases; ++i)
  {
    foot.turn(2 * ring::pi / foot.n_waves * i / n_phases);
    slope += (foot.at(step).axial_torque - foot.at(-step).axial_torque) / (2 * step * n_phases);
  }
  EXPECT_NEAR(row.terminal->omega, 0, 1e-5);
  EXPECT_NEAR(row.terminal->time_constant, foot.motion.inertia / -slope, 2e-4 * row.terminal->time_constant);
}

/// Returns the mean over time of the spin [rad/s] after the transient, near @p middle. The torque by sums
/// over points is a Fourier series in the phase and a polynomial in the spin; Euler's equation is integrated
/// over the phase by the Runge-Kutta method of fourth order.
double long_time_spin_of(WavyFoot &foot, double middle)
{
  constexpr int n_spins = 5, n_phases = 25, n_steps = 512, n_periods = 30;
  const double reach = 0.5, period = 2 * ring::pi / foot.n_waves;
  Eigen::MatrixXd powers(n_spins, n_spins), torques(n_spins, n_phases), series(n_phases, n_phases);
  for (int i = 0; i < n_spins; ++i)
  {
    const double x = std::cos(ring::pi * (i + 0.5) / n_spins);
    for (int k = 0; k < n_spins; ++k)
      powers(i, k) = std::pow(x, k);
    for (int j = 0; j < n_phases; ++j)
    {
      foot.turn(period * j / n_phases);
      torques(i, j) = foot.at(middle + reach * x).axial_torque;
    }
  }
  const auto wave = [&](int k, double phase)
  {
    return k % 2 == 0 ? std::cos(k / 2 * foot.n_waves * phase) : std::sin((k + 1) / 2 * foot.n_waves * phase);
  };
  for (int j = 0; j < n_phases; ++j)
    for (int k = 0; k < n_phases; ++k)
      series(j, k) = wave(k, period * j / n_phases);
  const Eigen::MatrixXd coefficients =
    powers.partialPivLu().solve(series.partialPivLu().solve(torques.transpose()).transpose());

  // Changes of spin, time and yaw angle per phase.
  const double orbit_rate = foot.motion.speed / foot.motion.orbit_radius;
  const auto slopes = [&](double phase, const Eigen::Vector3d &state) -> Eigen::Vector3d
  {
    const double x = (state(0) - middle) / reach, per_time = state(0) - orbit_rate;
    double torque = 0;
    for (int k = 0; k < n_phases; ++k)
      for (int i = 0; i < n_spins; ++i)
        torque += coefficients(i, k) * std::pow(x, i) * wave(k, phase);
    return Eigen::Vector3d(torque / foot.motion.inertia, 1, state(0)) / per_time;
  };
  Eigen::Vector3d state(middle, 0, 0);
  const double h = std::copysign(period, middle - orbit_rate) / n_steps; // forward in time
  for (int i = 0; i < n_steps * n_periods; ++i)
  {
    if (i % n_steps == 0)
      state.tail<2>().setZero();
    const Eigen::Vector3d one = slopes(i * h, state), two = slopes((i + 0.5) * h, state + h / 2 * one),
                          three = slopes((i + 0.5) * h, state + h / 2 * two),
                          four = slopes((i + 1) * h, state + h * three);
    state += h / 6 * (one + 2 * two + 2 * three + four);
  }
  return state(2) / state(1);
}

/// Expects the error bands of the terminal spin to hold for @p n_feet random wavy feet, and their median to
/// be less than ten times the error.
void expect_bands_of_wavy_feet(unsigned int n_feet)
{
  std::mt19937 random(60);
  const auto between = [&](double from, double to)
  { return from + (to - from) * static_cast<double>(random()) / 4294967296.; };
  std::vector<double> ratios;
  for (unsigned int i = 0; i < n_feet; ++i)
  {
    const auto n_waves = static_cast<unsigned int>(between(2, 6));
    // The crown of 3 mm sinks by (3 q / (4 k sqrt(6 mm)))^(2/3) under the weight q = 15.6 N per metre.
    const double modulus = std::exp(between(std::log(2e8), std::log(1e10))),
                 depth = std::pow(15.6 / (4. / 3 * modulus * std::sqrt(6e-3)), 2. / 3);
    WavyFoot foot(n_waves, between(0.05, 0.35) * depth, modulus, depth);
    SolvedStudy solved(foot.study, test::rigid_foot());
    ring::Question with_slope;
    with_slope.with_slope = true;
    const ring::Answer row = ring::answer(solved.load, spin_question(foot.study, with_slope)).value();
    const ErrorBands bands =
      estimate_bands({ foot.study, solved.foot, ThreadedExecutor(solved.cache) }, row, std::nullopt);
    const auto found = find_quantity(bands, "omega_terminal");
    ASSERT_NE(found, bands.end());
    const double error = std::abs(found->quantity.value - long_time_spin_of(foot, row.terminal->omega));
    std::printf("%u waves of %.2g m on %.2g Pa/m: error %.1e, band %.1e, ripple %.2g rad/s\n", n_waves,
                foot.amplitude, modulus, error, found->band, row.terminal->ripple);
    EXPECT_LE(error, found->band) << n_waves << " waves of " << foot.amplitude << " m on " << modulus
                                  << " Pa/m";
    ratios.push_back(found->band / std::max(error, found->quantity.rounding));
  }
  std::sort(ratios.begin(), ratios.end());
  std::printf("band over error: median %.1f, at most %.1f\n", ratios[ratios.size() / 2], ratios.back());
  EXPECT_LT(ratios[ratios.size() / 2], 10);
}

TEST(RigidFoot, BandsOfRandomWavyFeetContainTheErrorLong)
{
  expect_bands_of_wavy_feet(20);
}

TEST(RigidFoot, BandOfAWavyFootContainsTheError)
{
  expect_bands_of_wavy_feet(1);
}

} // namespace
} // namespace stemware::pipeline
