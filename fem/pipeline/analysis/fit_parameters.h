#pragma once

#include "fem/pipeline/analysis/free_entries.h"
#include "fem/pipeline/study/study.h"
#include "fem/pipeline/study/study_entries.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <string>
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
  /// Returns the derivative by @p x of the entry that with_parameters() sets.
  double slope(double x) const { return is_log ? std::exp(x) : is_never_negative && x < 0 ? -scale : scale; }

  bool is_grip() const { return path == "Motion/Grip torque"; }
  bool is_inertia() const { return path == "Motion/Yaw inertia"; }
  /// Returns whether the load depends on the entry.
  bool acts_on_load() const { return !is_grip() && !is_inertia(); }
};

/// Returns @p free as a parameter of a fit to runs of @p study. Throws BadInput for a start without a
/// logarithm.
FitParameter fit_parameter(const Study &study, const FreeEntry &free);

/// Study whose parameters move. Its entries are listed once, which takes longer than to set some of them.
class MovedStudy
{
public:
  /// @p parameters must outlive it.
  MovedStudy(const Study &study, const std::vector<FitParameter> &parameters);
  MovedStudy(const MovedStudy &) = delete;
  MovedStudy &operator=(const MovedStudy &) = delete;

  /// Returns the study with the parameters at @p x until the next call; an entry that may not be negative
  /// gets the absolute value. Throws BadInput for values that are not allowed.
  const Study &at(const Eigen::VectorXd &x);

private:
  Study now;
  const std::vector<StudyEntry> entries; ///< of `now`
  const std::vector<FitParameter> &parameters;
};

/// Returns MovedStudy::at() of @p study.
Study with_parameters(const Study &study, const std::vector<FitParameter> &parameters,
                      const Eigen::VectorXd &x);

} // namespace stemware::pipeline
