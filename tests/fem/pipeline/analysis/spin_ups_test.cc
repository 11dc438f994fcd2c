#include "fem/meridian/compliance_cache.h"
#include "fem/pipeline/analysis/fit.h"
#include "fem/pipeline/analysis/spin_ups.h"
#include "fem/pipeline/analysis/study_rows.h"
#include "fem/pipeline/answer/threaded_executor.h"
#include "fem/pipeline/coupling/study_load.h"
#include "fem/pipeline/input/study_file.h"
#include "ring_model/spin/answer.h"
#include "ring_model/spin/curves.h"
#include "tests/fem/pipeline/analysis/quick_studies.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <string>
#include <vector>

namespace stemware::pipeline
{
namespace
{

constexpr const char *friction = "Motion/Friction coefficient", *height = "Motion/Centre of mass height",
                     *grip = "Motion/Grip torque", *inertia = "Motion/Yaw inertia";

/// Spin-ups of one study, and the same with each load solved and followed by ring::answer().
class Comparison
{
public:
  Comparison(const Study &study, const std::vector<std::string> &free)
      : study(study)
      , executor(cache)
      , parameters(parameters_of(study, free))
      , spin_ups(study, parameters, executor)
      , foot(study_foot(study, executor.make_foot))
      , x(static_cast<Eigen::Index>(free.size()))
  {
    if (foot)
      find_load(study, foot); // which chooses the rings
    for (Eigen::Index j = 0; j < x.size(); ++j)
      x(j) = parameters[static_cast<std::size_t>(j)].start;
  }

  std::vector<ring::YawSample> solved(const Eigen::VectorXd &at) const
  {
    const Study now = with_parameters(study, parameters, at);
    const SharedLoad exact = load_of(now);
    ring::Question question = spin_question(now);
    question.with_minima = false;
    question.grip_torque = 0;
    const double last = 1.001 * ring::answer(*exact, question).last_spin().value();
    question.grip_torque = now.motion.grip_torque;
    question.times = ring::output_times(1.5);
    return ring::answer(*ring::interpolated(exact, std::min(0., last), std::max(0., last)), question)
      .value()
      .spin_up;
  }

  /// The load of @p now on the rings of the study.
  SharedLoad load_of(const Study &now) const { return find_load(now, foot ? foot->clone() : nullptr); }

  /// Largest difference of the spins to solved() over v / R.
  double difference(const Eigen::VectorXd &at)
  {
    const SpinUp spin_up = spin_ups.at(at);
    double largest = 0;
    for (const ring::YawSample &sample : solved(at))
      largest = std::max(largest, std::abs(sample.omega - spin_up.spin(sample.time)));
    return largest * study.glass.profile.contact_radius / study.motion.orbit.orbit_speed;
  }

  const Study study;
  fem::ComplianceCache cache;
  const ThreadedExecutor executor;
  const std::vector<FitParameter> parameters;
  SpinUps spin_ups;
  const std::shared_ptr<ElasticFoot> foot;
  Eigen::VectorXd x;

private:
  static std::vector<FitParameter> parameters_of(const Study &study, const std::vector<std::string> &free)
  {
    std::vector<FitParameter> found;
    for (const std::string &path : free)
      found.push_back(fit_parameter(study, { path }));
    return found;
  }
};

Study gripped(Study study)
{
  study.motion.grip_torque = 4e-4;
  return study;
}

/// The bound is ten times the tolerance of a load's curve over a_0.
TEST(SpinUps, AreThoseOfSolvedLoadsWhereALoadIsSolved)
{
  constexpr double tolerance = 1e-5;
  Comparison glass(gripped(test::quick_contact_study()), { friction, height });
  EXPECT_LT(glass.difference(glass.x), tolerance);
  std::mt19937 random(4);
  std::uniform_real_distribution<double> moved(-0.2, 0.2);
  for (int i = 0; i < 3; ++i)
  {
    const Eigen::VectorXd at = glass.x + Eigen::Vector2d(moved(random), moved(random) / 2);
    glass.spin_ups.solve_at(at);
    EXPECT_LT(glass.difference(at), tolerance) << at.transpose();
  }
  EXPECT_TRUE(glass.spin_ups.interpolates());
  // Between the loads, some 0.01 from the last one and 0.1 from the others.
  const Eigen::VectorXd centre = glass.spin_ups.centre();
  EXPECT_LT(glass.difference(centre + Eigen::Vector2d(0.01, -0.005)), 10 * tolerance);
}

/// The lowest centre of mass at which the rim is loaded all round at rest and lifts off before the last spin.
TEST(SpinUps, FollowAGlassThatLiftsOff)
{
  Study study = gripped(test::quick_contact_study());
  double &raised = study.motion.orbit.centre_of_mass_height;
  const auto lifts_off_on_the_way = [&]
  {
    const Comparison glass(study, { friction });
    const SharedLoad load = glass.load_of(study);
    const double last = ring::answer(*load, spin_question(study)).omega_terminal().value();
    load->at(last);
    return load->lift_off_margin(0) > 0 && load->lift_off_margin(last) < 0;
  };
  for (raised = 0.1; raised < 0.12 && !lifts_off_on_the_way(); raised += 2.5e-4)
    ;
  ASSERT_LT(raised, 0.12);
  Comparison glass(study, { friction });
  EXPECT_LT(glass.difference(glass.x), 1e-5);
  const Eigen::VectorXd at = glass.x + Eigen::VectorXd::Constant(1, 0.03);
  glass.spin_ups.solve_at(at);
  EXPECT_LT(glass.difference(at), 1e-5);
  EXPECT_TRUE(glass.spin_ups.interpolates());
}

/// Derivatives by grip, inertia and friction are those of solved spin-ups by central differences.
TEST(SpinUps, DerivativesAreThoseOfTheSpinUps)
{
  const Study study = read_study("", { "Load/Source=first harmonic", "Motion/Grip torque=4e-4" });
  Comparison glass(study, { grip, inertia, friction });
  EXPECT_FALSE(glass.spin_ups.interpolates());
  for (Eigen::Index j = 0; j < 3; ++j)
  {
    constexpr double step = 1e-4, tolerance = 1e-5;
    Eigen::VectorXd more = glass.x, less = glass.x;
    more(j) += step;
    less(j) -= step;
    const SpinCourse derivative = glass.spin_ups.derivative(glass.x, j);
    const std::vector<ring::YawSample> after = glass.solved(more), before = glass.solved(less);
    double largest = 0, miss = 0, angle = 0, angle_miss = 0;
    for (std::size_t i = 0; i < after.size(); ++i)
    {
      const double spin = (after[i].omega - before[i].omega) / (2 * step),
                   turned = (after[i].yaw_angle - before[i].yaw_angle) / (2 * step);
      largest = std::max(largest, std::abs(spin));
      angle = std::max(angle, std::abs(turned));
      miss = std::max(miss, std::abs(derivative.spin(after[i].time) - spin));
      angle_miss = std::max(angle_miss, std::abs(derivative.yaw_angle(after[i].time) - turned));
    }
    // Of friction the program has a difference of torques over 2e-3 itself.
    EXPECT_LT(miss, (j < 2 ? 1 : 10) * tolerance * largest) << j;
    EXPECT_LT(angle_miss, (j < 2 ? 1 : 10) * tolerance * angle) << j;
  }
}

/// A run of the study itself, with a noise that is known.
TEST(SpinUps, AFitTakesFewContactsAndTellsWhatItInterpolates)
{
  const Study truth = gripped(test::quick_contact_study());
  Comparison glass(truth, { friction });
  RunToFit run = { "run.csv", truth, {} };
  run.study.motion.orbit.friction_coefficient *= 0.9;
  run.study.motion.grip_torque *= 1.3;
  const std::vector<ring::YawSample> samples = glass.solved(glass.x);
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    run.data.times.push_back(3 + samples[i].time);
    run.data.values.push_back(samples[i].omega + 0.01 * std::sin(1e4 * static_cast<double>(i * i)));
  }
  FitQuestion question;
  question.free = { { friction }, { grip } };
  question.with_profiles = question.with_next_run = false;
  const FitResult free = fit({ run }, question, glass.executor);
  EXPECT_LT(free.n_contacts, 60u);
  EXPECT_GT(free.load_shift, 0);
  EXPECT_LT(free.load_shift, 0.01);
  EXPECT_NEAR(free.entries[0].value, truth.motion.orbit.friction_coefficient, 3 * free.entries[0].spread);
  EXPECT_NEAR(free.entries[1].value, truth.motion.grip_torque, 3 * free.entries[1].spread);
  EXPECT_NEAR(free.runs[0].start, 3, 3 * free.runs[0].start_spread);
  question.start = Prior{ 3, 0 };
  const FitResult held = fit({ run }, question, glass.executor);
  EXPECT_NEAR(held.runs[0].start, 3, 1e-6);
  EXPECT_LT(held.entries[0].spread, free.entries[0].spread);
}

} // namespace
} // namespace stemware::pipeline
