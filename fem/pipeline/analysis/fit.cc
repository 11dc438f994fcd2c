#include "fem/pipeline/analysis/fit.h"

#include "fem/pipeline/analysis/study_rows.h"
#include "fem/pipeline/study/quantity_text.h"
#include "fem/pipeline/study/study_checks.h"
#include "fem/pipeline/study/study_entries.h"
#include "fem/pipeline/support/failures.h"
#include "fem/pipeline/support/numbers.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <boost/algorithm/string/replace.hpp>
#include <boost/algorithm/string/trim.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <boost/math/interpolators/cardinal_cubic_b_spline.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <unsupported/Eigen/NonLinearOptimization>
#include <utility>

namespace stemware::pipeline
{

namespace
{

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Spline = boost::math::interpolators::cardinal_cubic_b_spline<double>;

/// Standard deviation of a number of which nothing is known: of a logarithm, or over the number's scale.
constexpr double anything = 5;

/// Free entry as the fit moves it: x is the logarithm of a positive entry, else the entry over `scale`.
struct Parameter
{
  std::string path, name, unit;
  bool is_log = false;
  bool is_never_negative = false;
  double scale = 1;
  double start = 0;                          ///< of x
  double prior = 0, prior_spread = anything; ///< of x

  double value(double x) const { return is_log ? std::exp(x) : x * scale; }
  double allowed(double x) const { return is_never_negative ? std::max(value(x), 0.) : value(x); }
};

Parameter parameter_of(const Study &study, const FreeEntry &free)
{
  const std::vector<StudyEntry> entries = entries_of(study);
  const StudyEntry &entry = entry_at(entries, "--free ", free.path);
  Parameter parameter = { entry.path(), entry.name, entry.unit };
  const double given = free.prior ? free.prior->value : std::get<double>(entry.value());
  const double usual = entry.plausible ? std::max(std::abs(entry.plausible->min), entry.plausible->max) : 1;
  parameter.is_log = !entry.assign("0"); // of a copy
  parameter.is_never_negative = !parameter.is_log && !entry.assign("-1e-9");
  require(!parameter.is_log || given > 0, "--free " + entry.path() + ": the value is not greater than 0.");
  parameter.scale = parameter.is_log ? 1 : given != 0 ? std::abs(given) : usual / 100;
  parameter.start = parameter.is_log ? std::log(given) : given / parameter.scale;
  parameter.prior = parameter.start;
  if (free.prior)
    parameter.prior_spread = free.prior->spread / (parameter.is_log ? given : parameter.scale);
  return parameter;
}

/// @p study with @p parameters at @p x; an entry that may not be negative gets the absolute value.
Study with_parameters(Study study, const std::vector<Parameter> &parameters, const VectorXd &x)
{
  const std::vector<StudyEntry> entries = study_entries(study);
  for (std::size_t j = 0; j < parameters.size(); ++j)
  {
    const StudyEntry &entry = entry_at(entries, "--free ", parameters[j].path);
    const double value = parameters[j].value(x(static_cast<Index>(j)));
    if (!entry.assign(to_text(value)))
      assign(entry, "--free ", to_text(std::abs(value)));
  }
  check_values(study);
  return study;
}

/// Spin and yaw angle from rest over the time; 0 before.
class SpinUp
{
public:
  SpinUp(const std::vector<ring::YawSample> &samples, double step)
      : end(step * static_cast<double>(samples.size() - 1))
      , last(samples.back())
      , omega(spline(samples, &ring::YawSample::omega, step))
      , angle(spline(samples, &ring::YawSample::yaw_angle, step))
  {
  }

  double spin(double time) const { return time <= 0 ? 0 : time >= end ? last.omega : omega(time); }
  double acceleration(double time) const { return time <= 0 || time >= end ? 0 : omega.prime(time); }
  double yaw_angle(double time) const
  {
    return time <= 0 ? 0 : time >= end ? last.yaw_angle + (time - end) * last.omega : angle(time);
  }

private:
  static Spline spline(const std::vector<ring::YawSample> &samples, double ring::YawSample::*value,
                       double step)
  {
    std::vector<double> values;
    for (const ring::YawSample &sample : samples)
      values.push_back(sample.*value);
    return { values.begin(), values.end(), 0., step };
  }

  double end;
  ring::YawSample last;
  Spline omega, angle;
};

/// Spin-ups of one study for values of the free entries. Loads are kept: grip and yaw inertia do not change
/// them.
class SpinUps
{
public:
  SpinUps(const Study &study, const std::vector<Parameter> &parameters, const Executor &executor)
      : study(study)
      , parameters(parameters)
      , executor(executor)
  {
  }

  /// Throws what find_load() and ring::answer() throw.
  const SpinUp &at(const VectorXd &x)
  {
    const std::vector<double> key(x.begin(), x.end());
    const auto known = spin_ups.find(key);
    return known != spin_ups.end() ? known->second : spin_ups.emplace(key, find(x)).first->second;
  }

private:
  SpinUp find(const VectorXd &x)
  {
    constexpr int n_steps = 1200;
    constexpr double n_time_constants = 60; // of the spin without grip
    const Study now = with_parameters(study, parameters, x);
    const ring::SharedLoad load = load_of(now, x);
    const ring::Motion &motion = now.motion.orbit;
    const double torque = motion.friction_at_rest() * motion.normal_force() * load->radius(),
                 step = n_time_constants / n_steps * motion.yaw_inertia * load->spin_scale(motion) / torque;
    ring::Question question = spin_question(now);
    question.with_minima = false;
    for (int i = 0; i <= n_steps; ++i)
      question.times.push_back(i * step);
    const ring::Answer found = ring::answer(*load, question).value();
    if (found.fall)
      throw ring::NoBalance(found.reason);
    return { found.spin_up, step };
  }

  /// The load between rest and the terminal spin without grip.
  ring::SharedLoad load_of(const Study &now, const VectorXd &x)
  {
    std::vector<double> key;
    bool on_same_foot = true;
    for (std::size_t j = 0; j < parameters.size(); ++j)
    {
      const std::string &path = parameters[j].path;
      if (path == "Motion/Grip torque" || path == "Motion/Yaw inertia")
        continue;
      key.push_back(x(static_cast<Index>(j)));
      on_same_foot = on_same_foot && path.rfind("Motion/", 0) == 0;
    }
    ring::SharedLoad &load = loads[key];
    if (load)
      return load;
    Variant variant = { "", "", now };
    variant.on_same_foot = on_same_foot && foot;
    const std::shared_ptr<ElasticFoot> own = foot_of(variant, foot, executor);
    const ring::SharedLoad exact = find_load(now, own);
    if (!foot)
      foot = own;
    if (!exact->is_costly())
      return load = exact;
    ring::Question free = spin_question(now);
    free.grip_torque = 0;
    free.with_minima = false;
    const double last = ring::answer(*exact, free).value().last_spin().value();
    return load = ring::interpolated(exact, std::min(0., 1.001 * last), std::max(0., 1.001 * last));
  }

  const Study study;
  const std::vector<Parameter> &parameters;
  const Executor &executor;
  std::shared_ptr<ElasticFoot> foot; ///< of the first load
  std::map<std::vector<double>, ring::SharedLoad> loads;
  std::map<std::vector<double>, SpinUp> spin_ups;
};

/// Run, its spin-ups, and the noise of its points.
struct Run
{
  RunToFit given;
  std::shared_ptr<SpinUps> spin_ups;
  double time_scale; ///< of the spin-up [s]
  double noise = 1;

  Index n_points() const { return static_cast<Index>(given.data.times.size()); }
  double model(const SpinUp &spin_up, Index i, double start) const
  {
    const double time = given.data.times[static_cast<std::size_t>(i)] - start;
    return given.data.is_angle ? spin_up.yaw_angle(time) : spin_up.spin(time);
  }
};

/// Least-squares problem of all runs, as Eigen's Levenberg-Marquardt asks it. Unknowns: the parameters, then
/// start over the time scale, and zero, of each run. Residuals over their noise: the points of each run, then
/// the priors of all unknowns, then that of an unknown held at a value.
class Problem
{
public:
  // The names are Eigen's.
  using Scalar = double;         // NOLINT
  using InputType = VectorXd;    // NOLINT
  using ValueType = VectorXd;    // NOLINT
  using JacobianType = MatrixXd; // NOLINT
  enum
  {
    InputsAtCompileTime = Eigen::Dynamic, // NOLINT
    ValuesAtCompileTime = Eigen::Dynamic  // NOLINT
  };

  Problem(const std::vector<Parameter> &parameters, std::vector<Run> all_runs, const Prior &gyroscope_zero)
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
      priors.segment<2>(of_run(r)) << data.times.front() / runs[r].time_scale,
        is_angle ? data.values.front() : gyroscope_zero.value;
      constexpr double fixed = 1e-9, any_turns = 1e4;
      spreads.segment<2>(of_run(r)) << 100 + (data.times.back() - data.times.front()) / runs[r].time_scale,
        is_angle ? any_turns : std::max(gyroscope_zero.spread, fixed);
    }
  }

  Index inputs() const { return priors.size(); }
  Index n_points() const
  {
    Index n = 0;
    for (const Run &run : runs)
      n += run.n_points();
    return n;
  }
  Index values() const { return n_points() + inputs() + 1; }
  Index of_run(std::size_t r) const { return n_parameters + 2 * static_cast<Index>(r); }

  /// Residuals; values that are too large everywhere for unknowns without a spin-up.
  int operator()(const VectorXd &x, VectorXd &residuals) const
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
          residuals(row) = (runs[r].model(spin_up, i, start) + zero -
                            runs[r].given.data.values[static_cast<std::size_t>(i)]) /
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

  /// Derivatives of the residuals; zero for unknowns without a spin-up, where the search ends.
  int df(const VectorXd &x, MatrixXd &jacobian) const
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

  void add_derivatives(const VectorXd &x, MatrixXd &jacobian) const
  {
    constexpr double step = 1e-3;
    Index row = 0;
    for (std::size_t r = 0; r < runs.size(); ++r)
    {
      const Run &run = runs[r];
      const SpinUp &spin_up = run.spin_ups->at(x.head(n_parameters));
      const double start = x(of_run(r)) * run.time_scale;
      for (Index j = 0; j < n_parameters; ++j)
      {
        VectorXd moved = x.head(n_parameters);
        const SpinUp *other = nullptr;
        for (const double way : { step, -step }) // one of them may be beyond a fall
          try
          {
            moved(j) = x(j) + way;
            other = other ? other : &run.spin_ups->at(moved);
            if (moved(j) == x(j) + way && other == &run.spin_ups->at(moved))
            {
              for (Index i = 0; i < run.n_points(); ++i)
                jacobian(row + i, j) =
                  (run.model(*other, i, start) - run.model(spin_up, i, start)) / (way * run.noise);
              break;
            }
          }
          catch (const std::exception &failure)
          {
            if (!is_variant_failure(failure))
              throw;
          }
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

  /// Sum of squares without that of the unknown that is held.
  double chi_square(const VectorXd &x) const
  {
    VectorXd residuals;
    (*this)(x, residuals);
    return residuals.head(values() - 1).squaredNorm();
  }

  VectorXd minimum(VectorXd x)
  {
    Eigen::LevenbergMarquardt<Problem> search(*this);
    search.parameters.xtol = 1e-7;
    search.parameters.ftol = 1e-9;
    search.parameters.maxfev = 100;
    search.minimize(x);
    return x;
  }

  std::vector<Run> runs;
  const Index n_parameters;
  VectorXd priors, spreads;
  std::optional<std::pair<Index, double>> held; ///< unknown and its value
  double held_to = 1;
};

/// Noise of a smooth curve by its second differences.
double rough_noise(const MeasuredRun &data)
{
  double sum = 0, largest = 0;
  for (std::size_t i = 1; i + 1 < data.values.size(); ++i)
    sum += std::pow(data.values[i - 1] - 2 * data.values[i] + data.values[i + 1], 2);
  for (const double value : data.values)
    largest = std::max(largest, std::abs(value));
  return std::max(std::sqrt(sum / 6 / static_cast<double>(data.values.size())), 1e-6 * largest);
}

/// Start and zero of run @p r that fit best with the parameters as they are in @p x.
void guess_start(const Problem &problem, std::size_t r, VectorXd &x)
{
  constexpr int n_tried = 400;
  const Run &run = problem.runs[r];
  const MeasuredRun &data = run.given.data;
  const SpinUp &spin_up = run.spin_ups->at(x.head(problem.n_parameters));
  const double earliest = data.times.front() - 5 * run.time_scale;
  double best = std::numeric_limits<double>::infinity();
  for (int k = 0; k < n_tried; ++k)
  {
    const double start = earliest + (data.times.back() - earliest) * k / n_tried;
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

/// Factor by which the variance of a mean grows if successive residuals are correlated beyond chance.
double widening(double correlation, Index n)
{
  const bool is_chance = correlation < 2 / std::sqrt(static_cast<double>(n));
  return is_chance ? 1 : (1 + correlation) / (1 - std::min(correlation, 0.99));
}

/// A run that refuses to be fitted.
void check(const RunToFit &run)
{
  constexpr std::size_t min_points = 5;
  require(run.data.times.size() >= min_points,
          "--data " + run.name + " has " + std::to_string(run.data.times.size()) +
            " points; measure at least " + std::to_string(min_points) + ".");
  require(run.data.times.back() > run.data.times.front(), "--data " + run.name + ": all times are equal.");
  require_flat(run.study, "fit");
  require(run.study.contact.goal == Goal::none,
          "A fit solves many studies on one mesh; set Contact/Goal = none.");
  require(!run.study.motion.orbit_speeds,
          "--data " + run.name +
            ": a fit has no table of the hand's speed; leave out Motion/Orbit speed file.");
  require(!run.study.load.is_static(), "--data " + run.name +
                                         ": the load has a given moment; a fit needs the moment of the hand, "
                                         "leave out the entries of Load but Source.");
}

std::string percent(double share)
{
  return to_short_text(rounded(100 * share, 2)) + " %";
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
      , problem(parameters, runs_of(given), question.gyroscope_zero)
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
    add_sentences(result);
    progress.stage_done("profiles");
    return result;
  }

private:
  static std::vector<Parameter> parameters_of(const std::vector<RunToFit> &given, const FitQuestion &question)
  {
    require(!given.empty(), "There are no runs to fit; give --data run.csv.");
    require(!question.free.empty(), "No entry is free; give --free \"Motion/Friction coefficient\".");
    std::vector<Parameter> parameters;
    for (const FreeEntry &free : question.free)
    {
      parameters.push_back(parameter_of(given.front().study, free));
      for (std::size_t j = 0; j + 1 < parameters.size(); ++j)
        require(parameters[j].path != parameters.back().path, "--free " + free.path + " is given twice.");
    }
    return parameters;
  }

  std::vector<Run> runs_of(const std::vector<RunToFit> &given) const
  {
    std::vector<Run> runs;
    for (const RunToFit &run : given)
    {
      check(run);
      const ring::Motion &motion = run.study.motion.orbit;
      const double radius = run.study.glass.profile.contact_radius;
      runs.push_back({ run, std::make_shared<SpinUps>(run.study, parameters, executor),
                       motion.yaw_inertia * motion.orbit_speed /
                         (motion.friction_at_rest() * motion.normal_force() * radius * radius),
                       rough_noise(run.data) });
    }
    return runs;
  }

  /// Fits with the noise of the residuals, which the fit itself tells.
  void find_minimum()
  {
    constexpr int max_rounds = 6;
    constexpr double enough = 0.01;
    for (std::size_t j = 0; j < parameters.size(); ++j)
      x(static_cast<Index>(j)) = parameters[j].start;
    for (std::size_t r = 0; r < problem.runs.size(); ++r)
    {
      require_same_sense(problem.runs[r]);
      guess_start(problem, r, x);
    }
    for (int round = 0; round < max_rounds; ++round)
    {
      x = problem.minimum(x);
      progress.pieces_done("rounds", static_cast<std::size_t>(round) + 1, 0);
      if (take_noise() < enough)
        break;
    }
    for (std::size_t j = 0; j < parameters.size(); ++j)
      if (parameters[j].is_never_negative)
        x(static_cast<Index>(j)) = std::abs(x(static_cast<Index>(j)));
    problem.df(x, jacobian);
  }

  void require_same_sense(const Run &run) const
  {
    const std::vector<double> &values = run.given.data.values;
    const double measured = run.given.data.is_angle ? values.back() - values.front() : values.back(),
                 model = run.spin_ups->at(x.head(problem.n_parameters)).spin(1e9);
    require(
      measured * model >= 0 || std::abs(measured) < 10 * run.noise,
      "--data " + run.given.name + ": the measured glass turns " +
        (measured > 0 ? "counter-clockwise" : "clockwise") +
        ", the glass of the study the other way; change the sign of the values, or Motion/Orbit sense.");
  }

  /// Sets the noise of each run by its residuals. Returns the largest relative change.
  double take_noise()
  {
    problem.df(x, jacobian);
    const MatrixXd covariance =
      (jacobian.transpose() * jacobian).ldlt().solve(MatrixXd::Identity(x.size(), x.size()));
    VectorXd residuals;
    problem(x, residuals);
    double change = 0;
    Index row = 0;
    n_free_points = 0;
    for (Run &run : problem.runs)
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

  MatrixXd covariance_of_all() const
  {
    return (jacobian.transpose() * jacobian).ldlt().solve(MatrixXd::Identity(x.size(), x.size()));
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
      const Parameter &parameter = parameters[static_cast<std::size_t>(j)];
      relative(j) = parameter.is_log || x(j) == 0 ? 1 : 1 / std::abs(x(j));
    }
    result.covariance = relative.asDiagonal() * covariance.topLeftCorner(k, k) * relative.asDiagonal();
    result.correlation = spread.cwiseInverse().asDiagonal() * covariance.topLeftCorner(k, k) *
                         spread.cwiseInverse().asDiagonal();
    result.study = with_parameters(problem.runs.front().given.study, parameters, x.head(k));
    result.chi_square = problem.chi_square(x);
    result.n_free_points = n_free_points;
    VectorXd per_percent = VectorXd::Zero(k), by_band = VectorXd::Zero(k);
    bool has_band = false;
    Index row = 0;
    for (std::size_t r = 0; r < problem.runs.size(); ++r)
    {
      const Run &run = problem.runs[r];
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
      const Parameter &parameter = parameters[static_cast<std::size_t>(j)];
      FittedEntry entry = { parameter.path, parameter.unit, parameter.value(x(j)), parameter.is_log };
      const double slope = parameter.is_log ? entry.value : parameter.scale;
      entry.spread = slope * spread(j);
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
    const Run &run = problem.runs[r];
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
          const VectorXd moved =
            problem.minimum(x + covariance.col(j) / covariance(j, j) * side * n * spread);
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
                        [&, &entry = path](const Parameter &parameter) { return parameter.path == entry; }))
          continue;
        RunToFit other = first;
        assign(study_entries(other.study), "", path, to_text(value));
        check_values(other.study);
        Problem alone(parameters, runs_of({ other }), question.gyroscope_zero);
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

  void add_sentences(FitResult &result) const
  {
    for (const FittedEntry &entry : result.entries)
      if (!entry.is_determined)
        result.sentences.push_back("The data do not determine " + entry.path + "; give a prior, --free \"" +
                                   entry.path + " = value ± spread\".");
    constexpr double strong = 0.95, worth_saying = 0.03;
    for (Index i = 0; i < problem.n_parameters; ++i)
      for (Index j = i + 1; j < problem.n_parameters; ++j)
        if (std::abs(result.correlation(i, j)) > strong &&
            std::sqrt(std::max(result.covariance(i, i), result.covariance(j, j))) > worth_saying)
          result.sentences.push_back(result.covariance(i, i) > result.covariance(j, j)
                                       ? words_of_pair(i, j, result)
                                       : words_of_pair(j, i, result));
    if (result.next_run && result.next_run->spread_now > worth_saying)
    {
      const NextRun &next = *result.next_run;
      const std::string unit = next.entry == "Motion/Orbit speed" ? " m/s" : " m";
      result.sentences.push_back("A run with " + next.entry + " = " + to_short_text(rounded(next.value, 3)) +
                                 unit + " beside the first would narrow what is known worst from " +
                                 percent(next.spread_now) + " to " + percent(next.spread_then) + ".");
    }
    for (const FittedRun &run : result.runs)
      if (widening(run.autocorrelation, static_cast<Index>(run.times.size())) > 1)
        result.sentences.push_back("The residuals of " + run.name + " are correlated (" +
                                   to_short_text(rounded(run.autocorrelation, 2)) +
                                   " from point to point): the model, or the sensor, is not what the fit "
                                   "takes it for. Errors are widened as for fewer points.");
    result.sentences.push_back("Errors are those of noise. They leave out the model's own: rigid fingers, a "
                               "steady hand, one friction law. If the model spins 1 % too fast, the values "
                               "change as the table says.");
  }

  /// "Motion/Grip torque and Motion/Friction coefficient are known together only: ..."; the first one is the
  /// one that is known worse.
  std::string words_of_pair(Index i, Index j, const FitResult &result) const
  {
    const Parameter &one = parameters[static_cast<std::size_t>(i)],
                    &other = parameters[static_cast<std::size_t>(j)];
    const double slope = result.covariance(i, j) / result.covariance(i, i),
                 left = std::sqrt(std::max(result.covariance(j, j) - slope * result.covariance(i, j), 0.));
    const auto spread = [&](Index k) { return percent(std::sqrt(result.covariance(k, k))); };
    return one.path + " and " + other.path + " are known together only (correlation " +
           to_short_text(rounded(result.correlation(i, j), 4)) + "): " + other.name + " / (" + one.name +
           ")^" + to_short_text(rounded(slope, 2)) + " to " + percent(left) + ", each alone to " + spread(i) +
           " and " + spread(j) + ".";
  }

  const FitQuestion &question;
  const Executor &executor;
  Progress &progress;
  const std::vector<Parameter> parameters;
  Problem problem;
  VectorXd x;
  MatrixXd jacobian;
  double n_free_points = 0;
};

} // namespace

std::optional<Prior> parse_prior(const std::string &text, const std::string &unit)
{
  std::string plain = text;
  for (const char *sign : { "+/-", "+-" })
    boost::replace_all(plain, sign, "±");
  const std::string mark = "±";
  const auto at = plain.find(mark);
  if (at == plain.npos)
    return std::nullopt;
  const std::vector<std::string> parts = with_shared_unit(
    { boost::trim_copy(plain.substr(0, at)), boost::trim_copy(plain.substr(at + mark.size())) });
  const auto value = parse_quantity(parts[0], unit), spread = parse_quantity(parts[1], unit);
  return value && spread && *spread >= 0 ? std::optional(Prior{ *value, *spread }) : std::nullopt;
}

FreeEntry parse_free_entry(const std::string &text)
{
  const auto equals = text.find('=');
  const std::vector<StudyEntry> entries = entries_of(Study());
  const StudyEntry &entry = entry_at(entries, "--free ", boost::trim_copy(text.substr(0, equals)));
  require(entry.quantity != nullptr, "--free " + entry.path() + " is no number that can be fitted.");
  FreeEntry free = { entry.path() };
  if (equals != text.npos)
  {
    free.prior = parse_prior(text.substr(equals + 1), entry.unit);
    require(free.prior && free.prior->spread > 0,
            "--free " + shortened(text) +
              " gives no prior; write value ± spread, or value +- spread, such as \"" + entry.path() +
              " = 0.3 +- 0.02\".");
  }
  return free;
}

Prior parse_gyroscope_zero(const std::string &text)
{
  const auto alone = parse_quantity(text, "rad/s");
  const auto prior = alone ? std::optional(Prior{ *alone, 0 }) : parse_prior(text, "rad/s");
  require(prior.has_value(), "--gyroscope-zero " + shortened(text) +
                               " is no spin; write \"0 +- 0.02 rad/s\", or 0 if there is no zero.");
  return *prior;
}

FitResult fit(const std::vector<RunToFit> &runs, const FitQuestion &question, const Executor &executor,
              Progress &progress)
{
  return Fit(runs, question, executor, progress).find();
}

} // namespace stemware::pipeline
