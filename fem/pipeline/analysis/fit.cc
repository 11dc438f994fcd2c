#include "fem/pipeline/analysis/fit.h"

#include "fem/pipeline/analysis/fit_problem.h"
#include "fem/pipeline/analysis/fit_sentences.h"
#include "fem/pipeline/study/study_checks.h"
#include "fem/pipeline/study/study_entries.h"
#include "fem/pipeline/support/failures.h"
#include "fem/pipeline/support/numbers.h"
#include "fem/pipeline/variants/solve.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <boost/math/distributions/students_t.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
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

double autocorrelation(const VectorXd &residuals)
{
  const Index n = residuals.size();
  const VectorXd centred = residuals.array() - residuals.mean();
  const double square = centred.squaredNorm();
  return n < 3 || square == 0 ? 0 : centred.head(n - 1).dot(centred.tail(n - 1)) / square;
}

/// Fit in the making.
class Fit
{
public:
  Fit(const std::vector<RunToFit> &given, const FitQuestion &question, const Executor &executor,
      Progress &progress)
      : question(question)
      , executor(executor)
      , progress(progress)
      , parameters(parameters_of(given, question))
      , problem(parameters, runs_of(given), question.gyroscope_zero, question.start)
      , x(problem.inputs())
  {
  }

  FitResult find()
  {
    find_minimum();
    FitResult result;
    describe(result);
    progress.stage_done("fit");
    if (question.with_profiles)
      add_profiles(result);
    if (question.with_next_run)
      add_next_run(result);
    result.sentences = fit_sentences(parameters, result);
    progress.stage_done("profiles");
    return result;
  }

private:
  static std::vector<FitParameter> parameters_of(const std::vector<RunToFit> &given,
                                                 const FitQuestion &question)
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

  std::vector<PreparedRun> runs_of(const std::vector<RunToFit> &given) const
  {
    std::vector<PreparedRun> runs;
    for (const RunToFit &run : given)
      runs.push_back(prepared(run, parameters, executor));
    return runs;
  }

  /// Fits with the noise of the residuals, which the fit itself tells, and the loads solved where the search
  /// ends.
  void find_minimum()
  {
    constexpr int max_rounds = 10;
    constexpr double enough = 0.01, enough_of_spread = 1e-3;
    for (std::size_t j = 0; j < parameters.size(); ++j)
      x(static_cast<Index>(j)) = parameters[j].start;
    for (std::size_t r = 0; r < problem.runs.size(); ++r)
    {
      require_same_sense(problem.runs[r]);
      guess_start(problem, r, question.start, x);
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

  void require_same_sense(const PreparedRun &run) const
  {
    const std::vector<double> &values = run.given.data.values;
    const double measured = run.given.data.is_angle ? values.back() - values.front() : values.back(),
                 model = run.spin_ups->at(x.head(problem.n_parameters)).spin(1e9);
    ensure(measured * model >= 0 || std::abs(measured) < 10 * run.noise,
           "--data " + run.given.name + ": the measured glass turns " +
             (measured > 0 ? "counter-clockwise" : "clockwise") +
             ", the glass of the study the other way; change the sign of the values, or Motion/Orbit sense.");
  }

  /// Solves the loads at @p unknowns, where loads are interpolated. Returns how far that moves what is
  /// fitted, in spreads of the combination of unknowns that moves most.
  double solve_loads(const VectorXd &unknowns, bool is_centre)
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

  /// Shift of what is fitted by a @p change of the residuals, in spreads of the combination that shifts most.
  static double shift_by(const VectorXd &change, const MatrixXd &slopes)
  {
    const VectorXd pull = slopes.transpose() * change;
    return std::sqrt(std::max(pull.dot(covariance_of(slopes) * pull), 0.));
  }

  double shift_by_missed_torques()
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

  /// Solves a load beside the fitted one for each entry, for the derivatives: as far away as the entry may
  /// well be, within a tenth.
  void solve_slopes()
  {
    problem.df(x, jacobian);
    const MatrixXd covariance = covariance_of_all();
    for (Index j = 0; j < problem.n_parameters; ++j)
      if (parameters[static_cast<std::size_t>(j)].acts_on_load())
        for (PreparedRun &run : problem.runs)
        {
          VectorXd beside = x.head(problem.n_parameters);
          beside(j) += std::clamp(2 * std::sqrt(covariance(j, j)), 0.01, 0.1);
          run.spin_ups->solve_at(beside, false);
        }
  }

  /// Sets the noise of each run by its residuals. Returns the largest relative change.
  double take_noise()
  {
    problem.df(x, jacobian);
    const MatrixXd covariance = covariance_of_all();
    VectorXd residuals;
    problem(x, residuals);
    double change = 0;
    Index row = 0;
    n_free_points = 0;
    for (PreparedRun &run : problem.runs)
    {
      const MatrixXd rows = jacobian.middleRows(row, run.n_points());
      const VectorXd own = residuals.segment(row, run.n_points());
      const double n_fitted = (rows * covariance).cwiseProduct(rows).sum(),
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

  MatrixXd covariance_of_all() const { return covariance_of(jacobian); }

  static MatrixXd covariance_of(const MatrixXd &slopes)
  {
    return (slopes.transpose() * slopes).ldlt().solve(MatrixXd::Identity(slopes.cols(), slopes.cols()));
  }

  /// Half-width of an interval of @p n_sigma normal standard deviations, in standard deviations.
  double student(double n_sigma) const
  {
    const double tail = std::erfc(n_sigma / std::sqrt(2.)) / 2;
    return boost::math::quantile(
      boost::math::complement(boost::math::students_t(std::max(n_free_points, 1.)), tail));
  }

  void describe(FitResult &result) const
  {
    const Index k = problem.n_parameters;
    const MatrixXd covariance = covariance_of_all();
    const VectorXd spread = covariance.diagonal().head(k).cwiseMax(1e-300).cwiseSqrt();
    VectorXd relative(k);
    for (Index j = 0; j < k; ++j)
    {
      const FitParameter &parameter = parameters[static_cast<std::size_t>(j)];
      relative(j) = parameter.is_log || x(j) == 0 ? 1 : 1 / std::abs(x(j));
    }
    result.covariance = relative.asDiagonal() * covariance.topLeftCorner(k, k) * relative.asDiagonal();
    result.correlation = spread.cwiseInverse().asDiagonal() * covariance.topLeftCorner(k, k) *
                         spread.cwiseInverse().asDiagonal();
    result.study = with_parameters(problem.runs.front().given.study, parameters, x.head(k));
    result.chi_square = problem.chi_square(x);
    result.load_shift = load_shift;
    for (const PreparedRun &run : problem.runs)
      result.n_contacts += run.spin_ups->n_contacts();
    result.n_free_points = n_free_points;
    VectorXd per_percent = VectorXd::Zero(k), by_band = VectorXd::Zero(k);
    bool has_band = false;
    Index row = 0;
    for (std::size_t r = 0; r < problem.runs.size(); ++r)
    {
      const PreparedRun &run = problem.runs[r];
      result.runs.push_back(described(r, covariance, row));
      // A spin that is too large everywhere by a share, and how the fit answers.
      VectorXd model(run.n_points());
      const FittedRun &fitted = result.runs.back();
      for (Index i = 0; i < run.n_points(); ++i)
        model(i) = (fitted.fitted[static_cast<std::size_t>(i)] - fitted.zero) / run.noise;
      const VectorXd answer =
        -(covariance * (jacobian.middleRows(row, run.n_points()).transpose() * model)).head(k);
      per_percent += 0.01 * answer;
      if (const auto band = question.band
                              ? question.band(with_parameters(run.given.study, parameters, x.head(k)))
                              : std::nullopt)
      {
        by_band += *band * answer;
        has_band = true;
      }
      row += run.n_points();
    }
    for (Index j = 0; j < k; ++j)
    {
      const FitParameter &parameter = parameters[static_cast<std::size_t>(j)];
      FittedEntry entry = { parameter.path, parameter.unit, parameter.value(x(j)), parameter.is_log };
      const double slope = parameter.is_log ? entry.value : parameter.scale;
      entry.spread = slope * spread(j);
      entry.is_never_negative = parameter.is_never_negative;
      entry.is_determined = spread(j) < 1;
      const auto range = [&](double n_sigma)
      {
        const double half = student(n_sigma) * spread(j);
        return FittedRange{ parameter.allowed(x(j) - half), parameter.allowed(x(j) + half) };
      };
      entry.range_68 = range(1);
      entry.range_95 = range(1.959964);
      entry.per_percent = slope * per_percent(j);
      if (has_band)
        entry.band = std::abs(slope * by_band(j));
      result.entries.push_back(entry);
    }
  }

  FittedRun described(std::size_t r, const MatrixXd &covariance, Index row) const
  {
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

  /// Goes one and two standard deviations to either side, all else fitted again.
  void add_profiles(FitResult &result)
  {
    constexpr double enough = 0.01; // of a spread
    constexpr int most_loads = 3;
    const MatrixXd covariance = covariance_of_all();
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
          for (int i = 0; i < most_loads && solve_loads(moved, false) > enough; ++i)
            moved = problem.minimum(moved);
          roots[n] = std::sqrt(std::max(problem.chi_square(moved) - least, 0.));
          problem.held.reset();
        }
        const auto end_at = [&](double n_sigma, FittedRange &range)
        {
          const double wanted = student(n_sigma), r1 = roots[1], r2 = roots[2];
          if (!(r2 > r1) || !(r1 > 0) || r2 < 0.5 * wanted)
            return;
          // The parabola through rest and both points: the distance as a function of the root.
          const double distance =
            wanted * (wanted - r2) / (r1 * (r1 - r2)) + 2 * wanted * (wanted - r1) / (r2 * (r2 - r1));
          (side < 0 ? range.lower : range.upper) =
            parameters[static_cast<std::size_t>(j)].allowed(x(j) + side * distance * spread);
        };
        end_at(1, *entry.profile_68);
        end_at(1.959964, *entry.profile_95);
      }
      progress.pieces_done("profiles", static_cast<std::size_t>(j) + 1, parameters.size());
    }
  }

  /// Tries hands at other heights and speeds, with the points and the noise of the first run.
  void add_next_run(FitResult &result)
  {
    const Index k = problem.n_parameters;
    if (k < 2)
      return;
    const MatrixXd covariance = covariance_of_all().topLeftCorner(k, k);
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
        if (std::any_of(parameters.begin(), parameters.end(),
                        [&, &entry = path](const FitParameter &parameter)
                        { return parameter.path == entry; }))
          continue;
        RunToFit other = first;
        assign(study_entries(other.study), "", path, to_text(value));
        check_values(other.study);
        FitProblem alone(parameters, runs_of({ other }), question.gyroscope_zero, question.start);
        alone.runs.front().noise = problem.runs.front().noise;
        VectorXd at = x.head(alone.inputs());
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

  const FitQuestion &question;
  const Executor &executor;
  Progress &progress;
  const std::vector<FitParameter> parameters;
  FitProblem problem;
  VectorXd x;
  MatrixXd jacobian;
  double n_free_points = 0;
  double load_shift = 0; ///< see solve_loads(), of the last round
};

} // namespace

FitResult fit(const std::vector<RunToFit> &runs, const FitQuestion &question, const Executor &executor,
              Progress &progress)
{
  return Fit(runs, question, executor, progress).find();
}

} // namespace stemware::pipeline
