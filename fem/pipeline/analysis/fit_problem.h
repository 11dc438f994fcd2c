#pragma once

#include "fem/pipeline/analysis/fit.h"
#include "fem/pipeline/analysis/fit_parameters.h"
#include "fem/pipeline/analysis/prepared_run.h"

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace stemware::pipeline
{

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
             const Prior &gyroscope_zero, const std::optional<Prior> &start);

  Eigen::Index inputs() const { return priors.size(); }
  Eigen::Index n_points() const;
  Eigen::Index values() const { return n_points() + inputs() + 1; }
  Eigen::Index of_run(std::size_t r) const { return n_parameters + 2 * static_cast<Eigen::Index>(r); }

  /// Residuals; values that are too large everywhere for unknowns without a spin-up.
  int operator()(const Eigen::VectorXd &x, Eigen::VectorXd &residuals) const;

  /// Derivatives of the residuals; zero for unknowns without a spin-up, where the search ends.
  int df(const Eigen::VectorXd &x, Eigen::MatrixXd &jacobian) const;

  /// Returns whether all runs have a spin-up.
  bool has_spin_ups(const Eigen::VectorXd &x) const;

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
