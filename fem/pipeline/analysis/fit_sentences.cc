#include "fem/pipeline/analysis/fit_sentences.h"

#include "fem/pipeline/support/numbers.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

namespace stemware::pipeline
{

namespace
{

using Eigen::Index;

std::string percent(double share)
{
  return to_short_text(rounded(100 * share, 2)) + " %";
}

/// "Motion/Grip torque and Motion/Friction coefficient are known together only: ..."; the first one is the
/// one that is known worse.
FitSentence words_of_pair(const std::vector<FitParameter> &parameters, Index i, Index j,
                          const FitResult &result)
{
  const FitParameter &one = parameters[static_cast<std::size_t>(i)],
                     &other = parameters[static_cast<std::size_t>(j)];
  const double slope = result.covariance(i, j) / result.covariance(i, i),
               left = std::sqrt(std::max(result.covariance(j, j) - slope * result.covariance(i, j), 0.));
  const auto spread = [&](Index k) { return percent(std::sqrt(result.covariance(k, k))); };
  return sentence("together",
                  "{0} and {1} are known together only (correlation {2}): {3} / ({4})^{5} to {6}, each alone "
                  "to {7} and {8}.",
                  { one.path, other.path, to_short_text(rounded(result.correlation(i, j), 4)), other.name,
                    one.name, to_short_text(rounded(slope, 2)), percent(left), spread(i), spread(j) });
}

} // namespace

std::vector<FitSentence> fit_sentences(const std::vector<FitParameter> &parameters, const FitResult &result)
{
  std::vector<FitSentence> sentences;
  for (const FittedEntry &entry : result.entries)
    if (!entry.is_determined)
      sentences.push_back(
        sentence("open", "The data do not determine {0}; give a prior, --free \"{0} = value ± spread\".",
                 { entry.path }));
  const auto n_parameters = static_cast<Index>(parameters.size());
  constexpr double strong = 0.95, worth_saying = 0.03;
  for (Index i = 0; i < n_parameters; ++i)
    for (Index j = i + 1; j < n_parameters; ++j)
      if (std::abs(result.correlation(i, j)) > strong &&
          std::sqrt(std::max(result.covariance(i, i), result.covariance(j, j))) > worth_saying)
        sentences.push_back(result.covariance(i, i) > result.covariance(j, j)
                              ? words_of_pair(parameters, i, j, result)
                              : words_of_pair(parameters, j, i, result));
  if (result.next_run && result.next_run->spread_now > worth_saying)
  {
    const NextRun &next = *result.next_run;
    const std::string unit = next.entry == "Motion/Orbit speed" ? " m/s" : " m";
    sentences.push_back(sentence("next",
                                 "A run with {0} = {1} beside the first would narrow what is known "
                                 "worst from {2} to {3}.",
                                 { next.entry, to_short_text(rounded(next.value, 3)) + unit,
                                   percent(next.spread_now), percent(next.spread_then) }));
  }
  for (const FittedRun &run : result.runs)
    if (widening(run.autocorrelation, static_cast<Index>(run.times.size())) > 1)
      sentences.push_back(sentence("correlated",
                                   "The residuals of {0} are correlated ({1} from point to point): the "
                                   "model, or the sensor, is not what the fit takes it for. Errors are "
                                   "widened as for fewer points.",
                                   { run.name, to_short_text(rounded(run.autocorrelation, 2)) }));
  if (constexpr double worth_telling = 0.01; result.load_shift > worth_telling)
    sentences.push_back(sentence("interpolated",
                                 "The loads between solved ones are interpolated; that may shift the values "
                                 "by {0} of their spread.",
                                 { percent(result.load_shift) }));
  sentences.push_back(sentence("errors",
                               "Errors are those of noise. They leave out the model's own: rigid "
                               "fingers, a steady hand, one friction law. If the model spins 1 % too "
                               "fast, the values change as the table says.",
                               {}));
  return sentences;
}

} // namespace stemware::pipeline
