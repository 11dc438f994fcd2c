#include "fem/pipeline/pictures/fit_pictures.h"

#include "fem/pipeline/support/json.h"

#include <Eigen/Core>
#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace stemware::pipeline
{

namespace
{

using Json = nlohmann::ordered_json;

Json ends_of(const FittedRange &range)
{
  return { finite_or_null(range.lower), finite_or_null(range.upper) };
}

Json entry_summary(const FittedEntry &entry)
{
  Json summary = { { "entry", entry.path } };
  summary.update(STEMWARE_JSON(entry, unit, value, spread));
  summary.update({ { "range_68", ends_of(entry.range_68) },
                   { "range_95", ends_of(entry.range_95) },
                   { "profile_68", to_json_or_null(entry.profile_68, ends_of) },
                   { "profile_95", to_json_or_null(entry.profile_95, ends_of) } });
  summary.update(STEMWARE_JSON(entry, band, per_percent));
  summary["determined"] = entry.is_determined;
  return summary;
}

Json run_summary(const FittedRun &run)
{
  Json summary = { { "name", run.name },
                   { "measured", run.is_angle ? "angle" : "spin" },
                   { "points", run.times.size() } };
  summary.update(STEMWARE_JSON(run, start, start_spread, zero, zero_spread, noise, autocorrelation));
  return summary;
}

using Point = std::array<double, 2>;

/// The part of a closed convex border in which coordinate @p k is not negative.
std::vector<Point> without_negative(const std::vector<Point> &border, std::size_t k)
{
  std::vector<Point> kept;
  for (std::size_t i = 0; i + 1 < border.size(); ++i)
  {
    const Point &from = border[i], &to = border[i + 1];
    if (from[k] >= 0)
      kept.push_back(from);
    if ((from[k] < 0) != (to[k] < 0))
    {
      const double share = from[k] / (from[k] - to[k]);
      Point end = { from[0] + share * (to[0] - from[0]), from[1] + share * (to[1] - from[1]) };
      end[k] = 0;
      kept.push_back(end);
    }
  }
  if (!kept.empty())
    kept.push_back(kept.front());
  return kept;
}

/// Border of the region in which @p one and @p other, normally distributed in what is fitted, lie with 95 %:
/// an ellipse, in the logarithm of a positive entry, and without the part below 0 of an entry that is never
/// negative.
std::vector<std::pair<std::string, std::vector<double>>>
ellipse_of(const FittedEntry &one, const FittedEntry &other, double correlation)
{
  constexpr int n_points = 72;
  const double reach = std::sqrt(-2 * std::log(0.05));
  const auto at = [&](const FittedEntry &entry, double deviations)
  {
    const double shift = reach * deviations * entry.spread;
    return entry.is_positive ? entry.value * std::exp(shift / entry.value) : entry.value + shift;
  };
  std::vector<Point> border;
  for (int k = 0; k <= n_points; ++k)
  {
    const double angle = boost::math::double_constants::two_pi * k / n_points;
    border.push_back(
      { at(one, std::cos(angle)),
        at(other, correlation * std::cos(angle) +
                    std::sqrt(std::max(1 - correlation * correlation, 0.)) * std::sin(angle)) });
  }
  if (one.is_never_negative)
    border = without_negative(border, 0);
  if (other.is_never_negative)
    border = without_negative(border, 1);
  std::vector<double> x, y;
  for (const Point &point : border)
  {
    x.push_back(point[0]);
    y.push_back(point[1]);
  }
  return { { "x", x }, { "y", y } };
}

} // namespace

nlohmann::ordered_json fit_summary(const FitResult &found)
{
  Json summary = { { "entries", Json::array() },
                   { "correlation", Json::array() },
                   { "runs", Json::array() } };
  for (const FittedEntry &entry : found.entries)
    summary["entries"].push_back(entry_summary(entry));
  for (const auto &row : found.correlation.rowwise())
    summary["correlation"].push_back(std::vector<double>(row.begin(), row.end()));
  for (const FittedRun &run : found.runs)
    summary["runs"].push_back(run_summary(run));
  summary.update(STEMWARE_JSON(found, chi_square, n_free_points, load_shift, n_contacts));
  summary["next_run"] =
    to_json_or_null(found.next_run, [](const NextRun &run)
                    { return STEMWARE_JSON(run, entry, value, spread_now, spread_then); });
  summary["sentences"] = Json::array();
  for (const FitSentence &sentence : found.sentences)
    summary["sentences"].push_back(sentence.text);
  return summary;
}

void add_fit_columns(const FitResult &found, Pictures &pictures)
{
  for (std::size_t r = 0; r < found.runs.size(); ++r)
  {
    const FittedRun &run = found.runs[r];
    pictures.add_columns("fit_of_run_" + std::to_string(r + 1),
                         { { "time", run.times }, { "measured", run.measured }, { "fitted", run.fitted } });
  }
  for (std::size_t i = 0; i < found.entries.size(); ++i)
    for (std::size_t j = i + 1; j < found.entries.size(); ++j)
      pictures.add_columns(
        "fit_ellipse_" + std::to_string(i + 1) + "_" + std::to_string(j + 1),
        ellipse_of(found.entries[i], found.entries[j],
                   found.correlation(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j))));
  Json &sentences = pictures.words["fit_sentences"] = Json::array();
  for (const FitSentence &sentence : found.sentences)
    sentences.push_back(
      { { "key", sentence.key }, { "text", sentence.text }, { "values", sentence.values } });
}

} // namespace stemware::pipeline
