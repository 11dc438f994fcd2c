#include "fem/pipeline/analysis/fit.h"

#include "fem/pipeline/analysis/fit_minimum.h"
#include "fem/pipeline/analysis/fit_sentences.h"
#include "fem/pipeline/study/study_checks.h"
#include "fem/pipeline/study/study_entries.h"
#include "fem/pipeline/support/failures.h"
#include "fem/pipeline/support/numbers.h"
#include "fem/pipeline/variants/solve.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <utility>

namespace stemware::pipeline
{

namespace
{

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

std::vector<FitParameter> parameters_of(const std::vector<RunToFit> &given, const FitQuestion &question)
{
  ensure(!given.empty(), "There are no runs to fit; give --data run.csv.");
  ensure(!question.free.empty(), "No entry is free; give --free \"Motion/Friction coefficient\".");
  std::vector<FitParameter> parameters;
  for (const FreeEntry &free : question.free)
  {
    parameters.push_back(fit_parameter(given.front().study, free));
    for (std::size_t j = 0; j + 1 < parameters.size(); ++j)
      ensure(parameters[j].path != parameters.back().path, "--free " + free.path + " is given twice.");
  }
  return parameters;
}

std::vector<PreparedRun> prepared_runs(const std::vector<RunToFit> &given,
                                       const std::vector<FitParameter> &parameters, const Executor &executor)
{
  std::vector<PreparedRun> runs;
  for (const RunToFit &run : given)
    runs.push_back(prepared(run, parameters, executor));
  return runs;
}

FittedRun described_run(const FitMinimum &found, std::size_t r, Index row)
{
  const FitProblem &problem = found.problem;
  const VectorXd &x = found.x;
  const MatrixXd covariance = found.covariance();
  const PreparedRun &run = problem.runs[r];
  const MeasuredRun &data = run.given.data;
  const Index own = problem.of_run(r);
  FittedRun fitted = { run.given.name, data.is_angle };
  fitted.start = x(own) * run.time_scale;
  fitted.start_spread = std::sqrt(std::max(covariance(own, own), 0.)) * run.time_scale;
  fitted.zero = x(own + 1);
  fitted.zero_spread = std::sqrt(std::max(covariance(own + 1, own + 1), 0.));
  VectorXd residuals;
  problem(x, residuals);
  const VectorXd mine = residuals.segment(row, run.n_points());
  fitted.autocorrelation = autocorrelation(mine);
  fitted.noise = run.noise / std::sqrt(widening(fitted.autocorrelation, run.n_points()));
  fitted.times = data.times;
  fitted.measured = data.values;
  for (Index i = 0; i < run.n_points(); ++i)
    fitted.fitted.push_back(data.values[static_cast<std::size_t>(i)] + mine(i) * run.noise);
  return fitted;
}

FitResult described(const FitMinimum &found, const FitQuestion &question)
{
  FitResult result;
  const FitProblem &problem = found.problem;
  const VectorXd &x = found.x;
  const Index k = problem.n_parameters;
  const MatrixXd covariance = found.covariance();
  const VectorXd spread = covariance.diagonal().head(k).cwiseMax(1e-300).cwiseSqrt();
  VectorXd relative(k);
  for (Index j = 0; j < k; ++j)
  {
    const FitParameter &parameter = found.parameters[static_cast<std::size_t>(j)];
    relative(j) = parameter.is_log || x(j) == 0 ? 1 : 1 / std::abs(x(j));
  }
  result.covariance = relative.asDiagonal() * covariance.topLeftCorner(k, k) * relative.asDiagonal();
  result.correlation =
    spread.cwiseInverse().asDiagonal() * covariance.topLeftCorner(k, k) * spread.cwiseInverse().asDiagonal();
  result.study = with_parameters(problem.runs.front().given.study, found.parameters, x.head(k));
  result.chi_square = problem.chi_square(x);
  result.load_shift = found.load_shift;
  for (const PreparedRun &run : problem.runs)
    result.n_contacts += run.spin_ups->n_contacts();
  result.n_free_points = found.n_free_points;
  VectorXd per_percent = VectorXd::Zero(k), by_band = VectorXd::Zero(k);
  bool has_band = false;
  Index row = 0;
  for (std::size_t r = 0; r < problem.runs.size(); ++r)
  {
    const PreparedRun &run = problem.runs[r];
    result.runs.push_back(described_run(found, r, row));
    // A spin that is too large everywhere by a share, and how the fit answers.
    VectorXd model(run.n_points());
    const FittedRun &fitted = result.runs.back();
    for (Index i = 0; i < run.n_points(); ++i)
      model(i) = (fitted.fitted[static_cast<std::size_t>(i)] - fitted.zero) / run.noise;
    const VectorXd answer =
      -(covariance * (found.jacobian.middleRows(row, run.n_points()).transpose() * model)).head(k);
    per_percent += 0.01 * answer;
    if (const auto band = question.band
                            ? question.band(with_parameters(run.given.study, found.parameters, x.head(k)))
                            : std::nullopt)
    {
      by_band += *band * answer;
      has_band = true;
    }
    row += run.n_points();
  }
  for (Index j = 0; j < k; ++j)
  {
    const FitParameter &parameter = found.parameters[static_cast<std::size_t>(j)];
    FittedEntry entry = { parameter.path, parameter.unit, parameter.value(x(j)), parameter.is_log };
    const double slope = parameter.is_log ? entry.value : parameter.scale;
    entry.spread = slope * spread(j);
    entry.is_never_negative = parameter.is_never_negative;
    entry.is_determined = spread(j) < 1;
    const auto range = [&](double n_sigma)
    {
      const double half = found.student(n_sigma) * spread(j);
      return FittedRange{ parameter.allowed(x(j) - half), parameter.allowed(x(j) + half) };
    };
    entry.range_68 = range(1);
    entry.range_95 = range(1.959964);
    entry.per_percent = slope * per_percent(j);
    if (has_band)
      entry.band = std::abs(slope * by_band(j));
    result.entries.push_back(entry);
  }
  return result;
}

/// Goes one and two standard deviations to either side, all else fitted again.
void add_profiles(FitMinimum &found, FitResult &result, Progress &progress)
{
  constexpr double enough = 0.01; // of a spread
  constexpr int most_loads = 3;
  FitProblem &problem = found.problem;
  const VectorXd &x = found.x;
  const MatrixXd covariance = found.covariance();
  const double least = result.chi_square;
  for (Index j = 0; j < problem.n_parameters; ++j)
  {
    FittedEntry &entry = result.entries[static_cast<std::size_t>(j)];
    entry.profile_68 = FittedRange();
    entry.profile_95 = FittedRange();
    const double spread = std::min(std::sqrt(covariance(j, j)), 1.);
    for (const int side : { -1, 1 })
    {
      double roots[3] = { 0, 0, 0 };
      for (const int n : { 1, 2 })
      {
        problem.held = { j, x(j) + side * n * spread };
        problem.held_to = 1e-4 * spread;
        VectorXd moved = problem.minimum(x + covariance.col(j) / covariance(j, j) * side * n * spread);
        for (int i = 0; i < most_loads && found.solve_loads(moved) > enough; ++i)
          moved = problem.minimum(moved);
        roots[n] = std::sqrt(std::max(problem.chi_square(moved) - least, 0.));
        problem.held.reset();
      }
      const auto end_at = [&](double n_sigma, FittedRange &range)
      {
        const double wanted = found.student(n_sigma), r1 = roots[1], r2 = roots[2];
        if (!(r2 > r1) || !(r1 > 0) || r2 < 0.5 * wanted)
          return;
        // The parabola through rest and both points: the distance as a function of the root.
        const double distance =
          wanted * (wanted - r2) / (r1 * (r1 - r2)) + 2 * wanted * (wanted - r1) / (r2 * (r2 - r1));
        (side < 0 ? range.lower : range.upper) =
          found.parameters[static_cast<std::size_t>(j)].allowed(x(j) + side * distance * spread);
      };
      end_at(1, *entry.profile_68);
      end_at(1.959964, *entry.profile_95);
    }
    progress.pieces_done("profiles", static_cast<std::size_t>(j) + 1, found.parameters.size());
  }
}

/// Tries hands at other heights and speeds, with the points and the noise of the first run.
void add_next_run(const FitMinimum &found, const FitQuestion &question, const Executor &executor,
                  FitResult &result)
{
  const FitProblem &problem = found.problem;
  const Index k = problem.n_parameters;
  if (k < 2)
    return;
  const MatrixXd covariance = found.covariance().topLeftCorner(k, k);
  const Eigen::SelfAdjointEigenSolver<MatrixXd> axes(covariance);
  const VectorXd worst = axes.eigenvectors().col(k - 1);
  const double now = std::sqrt(axes.eigenvalues()(k - 1));
  const RunToFit &first = problem.runs.front().given;
  const ring::Motion &motion = first.study.motion.orbit;
  std::vector<std::pair<std::string, double>> tried;
  for (const double shift : { -0.04, -0.02, 0.02, 0.04 })
    if (motion.centre_of_mass_height + motion.force_offset + shift > 0.005)
      tried.emplace_back("Motion/Force offset", motion.force_offset + shift);
  for (const double factor : { 0.7, 1.4 })
    tried.emplace_back("Motion/Orbit speed", factor * motion.orbit_speed);
  for (const auto &[path, value] : tried)
    try
    {
      if (std::any_of(found.parameters.begin(), found.parameters.end(),
                      [&, &entry = path](const FitParameter &parameter) { return parameter.path == entry; }))
        continue;
      RunToFit other = first;
      assign(study_entries(other.study), "", path, to_text(value));
      check_values(other.study);
      FitProblem alone(found.parameters, prepared_runs({ other }, found.parameters, executor),
                       question.gyroscope_zero, question.start);
      alone.runs.front().noise = problem.runs.front().noise;
      VectorXd at = found.x.head(alone.inputs());
      MatrixXd rows;
      alone.df(at, rows);
      // What the run tells with its own start and zero, added to what is known.
      const MatrixXd data = rows.topRows(alone.n_points()), entries = data.leftCols(k),
                     own = data.rightCols(2);
      const Eigen::Matrix2d nuisance = rows.rightCols(2).transpose() * rows.rightCols(2);
      const MatrixXd mixed = own.transpose() * entries;
      const MatrixXd information =
        entries.transpose() * entries - mixed.transpose() * nuisance.ldlt().solve(mixed);
      const MatrixXd then = (covariance.inverse() + information).inverse();
      const double spread = std::sqrt(worst.dot(then * worst));
      if (spread < 0.7 * (result.next_run ? result.next_run->spread_then / 0.7 : now))
        result.next_run = NextRun{ path, value, now, spread };
    }
    catch (const std::exception &failure)
    {
      if (!is_variant_failure(failure))
        throw;
    }
}

} // namespace

FitResult fit(const std::vector<RunToFit> &runs, const FitQuestion &question, const Executor &executor,
              Progress &progress)
{
  const std::vector<FitParameter> parameters = parameters_of(runs, question);
  FitMinimum found(parameters,
                   FitProblem(parameters, prepared_runs(runs, parameters, executor), question.gyroscope_zero,
                              question.start),
                   question.start, progress);
  FitResult result = described(found, question);
  progress.stage_done("fit");
  if (question.with_profiles)
    add_profiles(found, result, progress);
  if (question.with_next_run)
    add_next_run(found, question, executor, result);
  result.sentences = fit_sentences(parameters, result);
  progress.stage_done("profiles");
  return result;
}

} // namespace stemware::pipeline
