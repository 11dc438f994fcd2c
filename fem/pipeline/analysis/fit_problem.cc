#include "fem/pipeline/analysis/fit_problem.h"

#include "fem/pipeline/variants/solve.h"

#include <algorithm>
#include <cmath>
#include <unsupported/Eigen/NonLinearOptimization>

namespace stemware::pipeline
{

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

FitProblem::FitProblem(const std::vector<FitParameter> &parameters, std::vector<PreparedRun> all_runs,
                       const Prior &gyroscope_zero, const std::optional<Prior> &start)
    : runs(std::move(all_runs))
    , n_parameters(static_cast<Index>(parameters.size()))
    , priors(n_parameters + 2 * static_cast<Index>(runs.size()))
    , spreads(priors.size())
{
  for (Index j = 0; j < n_parameters; ++j)
  {
    priors(j) = parameters[static_cast<std::size_t>(j)].prior;
    spreads(j) = parameters[static_cast<std::size_t>(j)].prior_spread;
  }
  for (std::size_t r = 0; r < runs.size(); ++r)
  {
    const MeasuredRun &data = runs[r].given.data;
    const bool is_angle = data.is_angle;
    const double time_scale = runs[r].time_scale;
    constexpr double fixed = 1e-9, any_turns = 1e4;
    const Prior begins =
      start.value_or(Prior{ data.times.front(), 100 * time_scale + data.times.back() - data.times.front() });
    priors.segment<2>(of_run(r)) << begins.value / time_scale,
      is_angle ? data.values.front() : gyroscope_zero.value;
    spreads.segment<2>(of_run(r)) << std::max(begins.spread / time_scale, fixed),
      is_angle ? any_turns : std::max(gyroscope_zero.spread, fixed);
  }
}

Index FitProblem::n_points() const
{
  Index n = 0;
  for (const PreparedRun &run : runs)
    n += run.n_points();
  return n;
}

int FitProblem::operator()(const VectorXd &x, VectorXd &residuals) const
{
  constexpr double too_large = 1e6;
  residuals.setConstant(values(), too_large);
  try
  {
    Index row = 0;
    for (std::size_t r = 0; r < runs.size(); ++r)
    {
      const SpinUp &spin_up = runs[r].spin_ups->at(x.head(n_parameters));
      const double start = x(of_run(r)) * runs[r].time_scale, zero = x(of_run(r) + 1);
      for (Index i = 0; i < runs[r].n_points(); ++i, ++row)
        residuals(row) =
          (runs[r].model(spin_up, i, start) + zero - runs[r].given.data.values[static_cast<std::size_t>(i)]) /
          runs[r].noise;
    }
    residuals.segment(row, inputs()) = (x - priors).cwiseQuotient(spreads);
    residuals(values() - 1) = held ? (x(held->first) - held->second) / held_to : 0;
  }
  catch (const std::exception &failure)
  {
    if (!is_variant_failure(failure))
      throw;
  }
  return 0;
}

int FitProblem::df(const VectorXd &x, MatrixXd &jacobian) const
{
  jacobian.setZero(values(), inputs());
  try
  {
    add_derivatives(x, jacobian);
  }
  catch (const std::exception &failure)
  {
    if (!is_variant_failure(failure))
      throw;
    jacobian.setZero();
  }
  return 0;
}

void FitProblem::add_derivatives(const VectorXd &x, MatrixXd &jacobian) const
{
  Index row = 0;
  for (std::size_t r = 0; r < runs.size(); ++r)
  {
    const PreparedRun &run = runs[r];
    const VectorXd entries = x.head(n_parameters);
    const SpinUp spin_up = run.spin_ups->at(entries); // which a derivative may forget
    const double start = x(of_run(r)) * run.time_scale;
    for (Index j = 0; j < n_parameters; ++j)
    {
      const SpinCourse &derivative = run.spin_ups->derivative(entries, j);
      for (Index i = 0; i < run.n_points(); ++i)
        jacobian(row + i, j) = run.model(derivative, i, start) / run.noise;
    }
    for (Index i = 0; i < run.n_points(); ++i)
    {
      const double time = run.given.data.times[static_cast<std::size_t>(i)] - start;
      jacobian(row + i, of_run(r)) =
        -run.time_scale / run.noise *
        (run.given.data.is_angle ? spin_up.spin(time) : spin_up.acceleration(time));
      jacobian(row + i, of_run(r) + 1) = 1 / run.noise;
    }
    row += run.n_points();
  }
  jacobian.block(row, 0, inputs(), inputs()) = spreads.cwiseInverse().asDiagonal();
  if (held)
    jacobian(values() - 1, held->first) = 1 / held_to;
}

bool FitProblem::has_spin_ups(const VectorXd &x) const
{
  try
  {
    for (const PreparedRun &run : runs)
      run.spin_ups->at(x.head(n_parameters));
    return true;
  }
  catch (const std::exception &failure)
  {
    if (!is_variant_failure(failure))
      throw;
    return false;
  }
}

double FitProblem::chi_square(const VectorXd &x) const
{
  VectorXd residuals;
  (*this)(x, residuals);
  return residuals.head(values() - 1).squaredNorm();
}

VectorXd FitProblem::minimum(VectorXd x)
{
  Eigen::LevenbergMarquardt<FitProblem> search(*this);
  search.parameters.xtol = 1e-7;
  search.parameters.ftol = 1e-9;
  search.parameters.maxfev = 100;
  search.minimize(x);
  return x;
}

double widening(double correlation, Eigen::Index n)
{
  const bool is_chance = correlation < 2 / std::sqrt(static_cast<double>(n));
  return is_chance ? 1 : (1 + correlation) / (1 - std::min(correlation, 0.99));
}

} // namespace stemware::pipeline
