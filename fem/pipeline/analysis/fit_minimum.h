#pragma once

#include "fem/pipeline/analysis/fit_problem.h"
#include "fem/pipeline/support/progress.h"

#include <Eigen/Core>

#include <optional>

namespace stemware::pipeline
{

/// Minimum of a fit, with the noise that the residuals tell and the loads solved where the search ends.
class FitMinimum
{
public:
  /// Searches the minimum of @p problem with the entries @p parameters, which must outlive it; @p start:
  /// FitQuestion::start. Throws BadInput for a run that turns the other way than its study.
  FitMinimum(const std::vector<FitParameter> &parameters, FitProblem problem,
             const std::optional<Prior> &start, Progress &progress);

  /// Solves the loads at @p unknowns, where loads are interpolated. Returns how far that moves what is
  /// fitted, in spreads of the combination of unknowns that moves most.
  double solve_loads(const Eigen::VectorXd &unknowns, bool is_centre = false);

  /// Covariance of all unknowns.
  Eigen::MatrixXd covariance() const;
  /// Half-width of an interval of @p n_sigma normal standard deviations, in standard deviations.
  double student(double n_sigma) const;

  const std::vector<FitParameter> &parameters;
  FitProblem problem;
  Eigen::VectorXd x;        ///< unknowns
  Eigen::MatrixXd jacobian; ///< FitProblem::df() there
  double n_free_points = 0;
  double load_shift = 0; ///< FitResult::load_shift

private:
  void require_same_sense(const PreparedRun &run) const;
  double shift_by_missed_torques();
  /// Solves a load beside the fitted one for each entry, for the derivatives: as far away as the entry may
  /// well be, within a tenth.
  void solve_slopes();
  /// Sets the noise of each run by its residuals. Returns the largest relative change.
  double take_noise();
};

/// Correlation of successive residuals; 0 for noise.
double autocorrelation(const Eigen::VectorXd &residuals);

} // namespace stemware::pipeline
