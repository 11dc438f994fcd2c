#pragma once

#include "fem/pipeline/analysis/fit.h"
#include "ring_model/spin/answer.h"
#include "ring_model/yaw_motion.h"

#include <boost/math/interpolators/cardinal_cubic_b_spline.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace stemware::pipeline
{

/// Free entry as the fit moves it: x is the logarithm of a positive entry, else the entry over `scale`.
struct FitParameter
{
  std::string path, name, unit;
  bool is_log = false;
  bool is_never_negative = false;
  double scale = 1;
  double start = 0, prior = 0; ///< of x
  double prior_spread = 5;     ///< of x; 5: nothing is known

  double value(double x) const { return is_log ? std::exp(x) : x * scale; }
  double allowed(double x) const { return is_never_negative ? std::max(value(x), 0.) : value(x); }
};

/// Returns @p free as a parameter of a fit to runs of @p study. Throws BadInput for a start without a
/// logarithm.
FitParameter fit_parameter(const Study &study, const FreeEntry &free);

/// Returns @p study with @p parameters at @p x; an entry that may not be negative gets the absolute value.
Study with_parameters(Study study, const std::vector<FitParameter> &parameters, const Eigen::VectorXd &x);

/// Spin and yaw angle from rest over the time; 0 before.
class SpinUp
{
public:
  /// @p samples at multiples of @p step [s], from 0 on.
  SpinUp(const std::vector<ring::YawSample> &samples, double step);

  double spin(double time) const { return time <= 0 ? 0 : time >= end ? last.omega : omega(time); }
  double acceleration(double time) const { return time <= 0 || time >= end ? 0 : omega.prime(time); }
  double yaw_angle(double time) const
  {
    return time <= 0 ? 0 : time >= end ? last.yaw_angle + (time - end) * last.omega : angle(time);
  }

private:
  double end;
  ring::YawSample last;
  boost::math::interpolators::cardinal_cubic_b_spline<double> omega, angle;
};

/// Spin-ups of one study for values of the free entries. Loads are kept: grip and yaw inertia do not change
/// them.
class SpinUps
{
public:
  SpinUps(const Study &study, const std::vector<FitParameter> &parameters, const Executor &executor)
      : study(study)
      , parameters(parameters)
      , executor(executor)
  {
  }

  /// Returns the spin-up for unknowns @p x of the parameters. Throws what find_load() and ring::answer()
  /// throw.
  const SpinUp &at(const Eigen::VectorXd &x);

private:
  SpinUp find(const Eigen::VectorXd &x);
  /// The load between rest and the terminal spin without grip.
  ring::SharedLoad load_of(const Study &now, const Eigen::VectorXd &x);

  const Study study;
  const std::vector<FitParameter> &parameters;
  const Executor &executor;
  std::shared_ptr<ElasticFoot> foot; ///< of the first load
  std::map<std::vector<double>, ring::SharedLoad> loads;
  std::map<std::vector<double>, SpinUp> spin_ups;
};

/// Measured run, its spin-ups, and the noise of its points.
struct PreparedRun
{
  RunToFit given;
  std::shared_ptr<SpinUps> spin_ups;
  double time_scale; ///< of the spin-up [s]
  double noise = 1;

  Eigen::Index n_points() const { return static_cast<Eigen::Index>(given.data.times.size()); }
  double model(const SpinUp &spin_up, Eigen::Index i, double start) const
  {
    const double time = given.data.times[static_cast<std::size_t>(i)] - start;
    return given.data.is_angle ? spin_up.yaw_angle(time) : spin_up.spin(time);
  }
};

/// Least-squares problem of all runs, as Eigen's Levenberg-Marquardt asks it. Unknowns: the parameters, then
/// start over the time scale, and zero, of each run. Residuals over their noise: the points of each run, then
/// the priors of all unknowns, then that of an unknown held at a value.
class FitProblem
{
public:
  // The names are Eigen's.
  using Scalar = double;                // NOLINT
  using InputType = Eigen::VectorXd;    // NOLINT
  using ValueType = Eigen::VectorXd;    // NOLINT
  using JacobianType = Eigen::MatrixXd; // NOLINT
  enum
  {
    InputsAtCompileTime = Eigen::Dynamic, // NOLINT
    ValuesAtCompileTime = Eigen::Dynamic  // NOLINT
  };

  FitProblem(const std::vector<FitParameter> &parameters, std::vector<PreparedRun> all_runs,
             const Prior &gyroscope_zero);

  Eigen::Index inputs() const { return priors.size(); }
  Eigen::Index n_points() const;
  Eigen::Index values() const { return n_points() + inputs() + 1; }
  Eigen::Index of_run(std::size_t r) const { return n_parameters + 2 * static_cast<Eigen::Index>(r); }

  /// Residuals; values that are too large everywhere for unknowns without a spin-up.
  int operator()(const Eigen::VectorXd &x, Eigen::VectorXd &residuals) const;

  /// Derivatives of the residuals; zero for unknowns without a spin-up, where the search ends.
  int df(const Eigen::VectorXd &x, Eigen::MatrixXd &jacobian) const;

  /// Sum of the squared residuals; the prior of a held unknown is left out.
  double chi_square(const Eigen::VectorXd &x) const;

  /// Returns the unknowns with the least sum of squares, searched from @p x on.
  Eigen::VectorXd minimum(Eigen::VectorXd x);

  std::vector<PreparedRun> runs;
  const Eigen::Index n_parameters;
  Eigen::VectorXd priors, spreads;
  std::optional<std::pair<Eigen::Index, double>> held; ///< unknown and its value
  double held_to = 1;

private:
  void add_derivatives(const Eigen::VectorXd &x, Eigen::MatrixXd &jacobian) const;
};

/// Returns the factor by which the variance of a mean of @p n values grows if successive residuals are
/// correlated beyond chance.
double widening(double correlation, Eigen::Index n);

} // namespace stemware::pipeline
