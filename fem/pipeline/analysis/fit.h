#pragma once

#include "fem/pipeline/analysis/free_entries.h"
#include "fem/pipeline/coupling/study_load.h"
#include "fem/pipeline/study/measured_run.h"
#include "fem/pipeline/support/progress.h"
#include "fem/pipeline/support/sentence.h"
#include "fem/pipeline/variants/executor.h"

#include <Eigen/Core>

#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace stemware::pipeline
{

/// Measured run and the study of its hand.
struct RunToFit
{
  std::string name;
  Study study;
  MeasuredRun data;
};

/// Question of a fit.
struct FitQuestion
{
  std::vector<FreeEntry> free = {};
  Prior gyroscope_zero = { 0., 0.01 }; ///< added to measured spins, of each run its own; spread 0: fixed
  /// Time at which the glass begins to slide, of each run its own [s]; spread 0: fixed. std::nullopt:
  /// unknown.
  std::optional<Prior> start = {};
  bool with_profiles = true;
  bool with_next_run = true; ///< whether FitResult::next_run is wanted
  /// Returns the relative error band of a study's terminal spin; std::nullopt if none is known.
  std::function<std::optional<double>(const Study &)> band = {};
};

/// Returns the question of texts: @p free as parse_free_entry(), @p gyroscope_zero as parse_gyroscope_zero(),
/// @p start as parse_start(); the last two may be empty. @p quick: without profiles and next run. Throws
/// BadInput.
FitQuestion fit_question(const std::vector<std::string> &free, const std::string &gyroscope_zero,
                         const std::string &start, bool quick);

/// Interval; an end that the data leave open is infinite.
struct FittedRange
{
  double lower = -std::numeric_limits<double>::infinity(), upper = std::numeric_limits<double>::infinity();
};

/// Fitted entry, in SI units.
struct FittedEntry
{
  std::string path, unit;
  double value = 0;
  bool is_positive = false;                 ///< fitted as logarithm: errors are factors
  bool is_never_negative = false;           ///< may be 0, but not less
  bool is_determined = false;               ///< by the data or the prior, to a factor of e or better
  double spread = 0;                        ///< standard deviation, of the logarithm if `is_positive`
  FittedRange range_68 = {}, range_95 = {}; ///< from the covariance, with Student's t
  std::optional<FittedRange> profile_68 = {}, profile_95 = {}; ///< from the profile likelihood
  std::optional<double> band = {}; ///< change of value by the error band of the discretisation
  double per_percent = 0;          ///< change of value if the model's spin is 1 % too large
};

/// Fitted run: its own numbers, which no other run shares, and its residuals.
struct FittedRun
{
  std::string name;
  bool is_angle = false;
  double start = 0, start_spread = 0; ///< time at which the glass begins to slide [s]
  double zero = 0, zero_spread = 0;   ///< zero of the gyroscope [rad/s], or angle at the start [rad]
  double noise = 0;                   ///< standard deviation of the residuals [rad/s] or [rad]
  double autocorrelation = 0;         ///< of successive residuals; 0 for noise
  std::vector<double> times = {}, measured = {}, fitted = {}; ///< [s]; [rad/s] or [rad]
};

/// Run that would separate the entries best.
struct NextRun
{
  std::string entry;
  double value = 0;                       ///< [SI unit]
  double spread_now = 0, spread_then = 0; ///< of the combination that is known worst, relative
};

/// Sentence about a fit.
using FitSentence = Sentence;

/// Fit of measured runs.
struct FitResult
{
  Study study; ///< of the first run, with the fitted values
  std::vector<FittedEntry> entries;
  std::vector<FittedRun> runs;
  Eigen::MatrixXd covariance;  ///< of relative changes of the entries. Shape [entry, entry].
  Eigen::MatrixXd correlation; ///< the same shape
  double chi_square = 0;       ///< residuals over their noise, priors included
  double n_free_points = 0;    ///< points without the fitted numbers
  /// Estimate of the shift of the entries by the loads that are interpolated between solved ones, in spreads
  /// of the combination that shifts most; 0 if every load is solved.
  double load_shift = 0;
  std::size_t n_contacts = 0; ///< contacts solved for all runs, without those of the next one
  std::optional<NextRun> next_run = {};
  std::vector<FitSentence> sentences = {}; ///< what the data do not determine, and what the errors leave out
};

/// Fits @p question.free to @p runs: Levenberg-Marquardt on spins or yaw angles of a spin-up from rest, of
/// which each run has a start and a zero of its own. The noise of a run is that of its residuals; if
/// successive residuals are correlated, errors are widened as for fewer points. Each spin-up is that of
/// find_load() and ring::answer(). Throws BadInput for runs that cannot be fitted, and what the first spin-up
/// throws.
FitResult fit(const std::vector<RunToFit> &runs, const FitQuestion &question, const Executor &executor,
              Progress &progress = silent_progress());

} // namespace stemware::pipeline
