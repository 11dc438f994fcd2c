#pragma once

#include "fem/pipeline/analysis/fit.h"
#include "fem/pipeline/analysis/fit_parameters.h"
#include "fem/pipeline/analysis/spin_ups.h"

#include <Eigen/Core>

#include <cstddef>
#include <memory>
#include <vector>

namespace stemware::pipeline
{

/// Measured run, its spin-ups, and the noise of its points.
struct PreparedRun
{
  RunToFit given;
  std::shared_ptr<SpinUps> spin_ups;
  double time_scale; ///< of the spin-up [s]
  double noise = 1;

  Eigen::Index n_points() const { return static_cast<Eigen::Index>(given.data.times.size()); }
  /// Returns spin or yaw angle of @p course at point @p i, or their derivative by an entry.
  double model(const SpinCourse &course, Eigen::Index i, double start) const
  {
    const double time = given.data.times[static_cast<std::size_t>(i)] - start;
    return given.data.is_angle ? course.yaw_angle(time) : course.spin(time);
  }
};

/// Returns @p run with its spin-ups and the noise of its second differences; keeps references to
/// @p parameters and @p executor. Throws BadInput for a run that cannot be fitted.
PreparedRun prepared(const RunToFit &run, const std::vector<FitParameter> &parameters,
                     const Executor &executor);

} // namespace stemware::pipeline
