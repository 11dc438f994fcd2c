#include "fem/pipeline/analysis/fit_minimum.h"

#include "fem/pipeline/support/failures.h"

#include <Eigen/Cholesky>
#include <boost/math/distributions/students_t.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace stemware::pipeline
{

namespace
{

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Start, if it is not @p given, and zero of run @p r that fit best with the parameters as they are in @p x.
void guess_start(const FitProblem &problem, std::size_t r, const std::optional<Prior> &given, VectorXd &x)
{
  constexpr int n_tried = 400;
  const PreparedRun &run = problem.runs[r];
  const MeasuredRun &data = run.given.data;
  const SpinUp &spin_up = run.spin_ups->at(x.head(problem.n_parameters));
  const double earliest = data.times.front() - 5 * run.time_scale;
  double best = std::numeric_limits<double>::infinity();
  for (int k = 0; k < (given ? 1 : n_tried); ++k)
  {
    const double start = given ? given->value : earliest + (data.times.back() - earliest) * k / n_tried;
    VectorXd difference(run.n_points());
    for (Index i = 0; i < run.n_points(); ++i)
      difference(i) = data.values[static_cast<std::size_t>(i)] - run.model(spin_up, i, start);
    const double zero = data.is_angle ? difference.mean() : problem.priors(problem.of_run(r) + 1);
    const double sum = (difference.array() - zero).square().sum();
    if (sum < best)
    {
      best = sum;
      x.segment<2>(problem.of_run(r)) << start / run.time_scale, zero;
    }
  }
}

MatrixXd covariance_of(const MatrixXd &slopes)
{
  return (slopes.transpose() * slopes).ldlt().solve(MatrixXd::Identity(slopes.cols(), slopes.cols()));
}

/// Shift of what is fitted by a @p change of the residuals, in spreads of the combination that shifts most.
double shift_by(const VectorXd &change, const MatrixXd &slopes)
{
  const VectorXd pull = slopes.transpose() * change;
  return std::sqrt(std::max(pull.dot(covariance_of(slopes) * pull), 0.));
}

} // namespace

FitMinimum::FitMinimum(const std::vector<FitParameter> &parameters, FitProblem given,
                       const std::optional<Prior> &start, Progress &progress)
    : parameters(parameters)
    , problem(std::move(given))
    , x(problem.inputs())
{
  constexpr int max_rounds = 10;
  constexpr double enough = 0.01, enough_of_spread = 1e-3;
  for (std::size_t j = 0; j < parameters.size(); ++j)
    x(static_cast<Index>(j)) = parameters[j].start;
  for (std::size_t r = 0; r < problem.runs.size(); ++r)
  {
    require_same_sense(problem.runs[r]);
    guess_start(problem, r, start, x);
  }
  for (int round = 0; round < max_rounds; ++round)
  {
    const VectorXd before = x;
    x = problem.minimum(x);
    progress.pieces_done("rounds", static_cast<std::size_t>(round) + 1, 0);
    const bool same_noise = take_noise() < enough;
    load_shift = solve_loads(x, true);
    if (!problem.has_spin_ups(x)) // the glass tips there, which loads between others did not tell
      x = before;
    else if (same_noise && load_shift < enough_of_spread)
      break;
  }
  x = problem.minimum(x);
  solve_slopes();
  load_shift += shift_by_missed_torques();
  for (std::size_t j = 0; j < parameters.size(); ++j)
    if (parameters[j].is_never_negative)
      x(static_cast<Index>(j)) = std::abs(x(static_cast<Index>(j)));
  problem.df(x, jacobian);
}

void FitMinimum::require_same_sense(const PreparedRun &run) const
{
  const std::vector<double> &values = run.given.data.values;
  const double measured = run.given.data.is_angle ? values.back() - values.front() : values.back(),
               model = run.spin_ups->at(x.head(problem.n_parameters)).spin(1e9);
  ensure(measured * model >= 0 || std::abs(measured) < 10 * run.noise,
         "--data " + run.given.name + ": the measured glass turns " +
           (measured > 0 ? "counter-clockwise" : "clockwise") +
           ", the glass of the study the other way; change the sign of the values, or Motion/Orbit sense.");
}

double FitMinimum::solve_loads(const VectorXd &unknowns, bool is_centre)
{
  MatrixXd slopes;
  VectorXd before, after;
  problem.df(unknowns, slopes);
  problem(unknowns, before);
  for (PreparedRun &run : problem.runs)
    run.spin_ups->solve_at(unknowns.head(problem.n_parameters), is_centre);
  problem(unknowns, after);
  return shift_by(after - before, slopes);
}

double FitMinimum::shift_by_missed_torques()
{
  problem.df(x, jacobian);
  VectorXd change = VectorXd::Zero(problem.values());
  Index row = 0;
  for (std::size_t r = 0; r < problem.runs.size(); ++r)
  {
    const PreparedRun &run = problem.runs[r];
    const SpinCourse missed = run.spin_ups->missed(x.head(problem.n_parameters));
    for (Index i = 0; i < run.n_points(); ++i)
      change(row++) = run.model(missed, i, x(problem.of_run(r)) * run.time_scale) / run.noise;
  }
  return shift_by(change, jacobian);
}

void FitMinimum::solve_slopes()
{
  problem.df(x, jacobian);
  const MatrixXd covariances = covariance();
  for (Index j = 0; j < problem.n_parameters; ++j)
    if (parameters[static_cast<std::size_t>(j)].acts_on_load())
      for (PreparedRun &run : problem.runs)
      {
        VectorXd beside = x.head(problem.n_parameters);
        beside(j) += std::clamp(2 * std::sqrt(covariances(j, j)), 0.01, 0.1);
        run.spin_ups->solve_at(beside, false);
      }
}

double FitMinimum::take_noise()
{
  problem.df(x, jacobian);
  const MatrixXd covariances = covariance();
  VectorXd residuals;
  problem(x, residuals);
  double change = 0;
  Index row = 0;
  n_free_points = 0;
  for (PreparedRun &run : problem.runs)
  {
    const MatrixXd rows = jacobian.middleRows(row, run.n_points());
    const VectorXd own = residuals.segment(row, run.n_points());
    const double n_fitted = (rows * covariances).cwiseProduct(rows).sum(),
                 n_free = std::max(static_cast<double>(run.n_points()) - n_fitted, 1.),
                 factor = widening(autocorrelation(own), run.n_points());
    const double noise = std::max(run.noise * std::sqrt(own.squaredNorm() / n_free * factor),
                                  1e-9 * std::abs(run.given.data.values.back()) + 1e-12);
    change = std::max(change, std::abs(noise / run.noise - 1));
    run.noise = noise;
    n_free_points += n_free / factor;
    row += run.n_points();
  }
  return change;
}

MatrixXd FitMinimum::covariance() const
{
  return covariance_of(jacobian);
}

double FitMinimum::student(double n_sigma) const
{
  const double tail = std::erfc(n_sigma / std::sqrt(2.)) / 2;
  return boost::math::quantile(
    boost::math::complement(boost::math::students_t(std::max(n_free_points, 1.)), tail));
}

double autocorrelation(const VectorXd &residuals)
{
  const Index n = residuals.size();
  const VectorXd centred = residuals.array() - residuals.mean();
  const double square = centred.squaredNorm();
  return n < 3 || square == 0 ? 0 : centred.head(n - 1).dot(centred.tail(n - 1)) / square;
}

} // namespace stemware::pipeline
