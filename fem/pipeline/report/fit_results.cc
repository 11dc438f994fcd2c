#include "fem/pipeline/report/fit_results.h"

#include "fem/pipeline/document/study_words.h"

#include <boost/algorithm/string/join.hpp>

#include <fmt/format.h>

namespace stemware::pipeline
{

namespace
{

using Json = nlohmann::ordered_json;

Json ends_of(const FittedRange &range)
{
  return { finite_or_null(range.lower), finite_or_null(range.upper) };
}

Json ends_of(const std::optional<FittedRange> &range)
{
  return range ? ends_of(*range) : Json(nullptr);
}

Json entry_summary(const FittedEntry &entry)
{
  return { { "entry", entry.path },
           { "unit", entry.unit },
           { "value", entry.value },
           { "spread", entry.spread },
           { "range_68", ends_of(entry.range_68) },
           { "range_95", ends_of(entry.range_95) },
           { "profile_68", ends_of(entry.profile_68) },
           { "profile_95", ends_of(entry.profile_95) },
           { "band", entry.band },
           { "per_percent", entry.per_percent },
           { "determined", entry.is_determined } };
}

Json run_summary(const FittedRun &run)
{
  Json json = { { "name", run.name },
                { "measured", run.is_angle ? "angle" : "spin" },
                { "points", run.times.size() } };
  json.update(STEMWARE_JSON(run, start, start_spread, zero, zero_spread, noise, autocorrelation));
  return json;
}

Json summary_of_fit(const FitResult &found)
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
  summary["chi_square"] = found.chi_square;
  summary["free_points"] = found.n_free_points;
  summary["next_run"] =
    to_json_or_null(found.next_run, [](const NextRun &next)
                    { return STEMWARE_JSON(next, entry, value, spread_now, spread_then); });
  summary["sentences"] = found.sentences;
  return summary;
}

std::string answer_of(const FitResult &found)
{
  std::vector<std::string> values;
  std::size_t n_points = 0;
  for (const FittedEntry &entry : found.entries)
    values.push_back(fmt::format(FMT_STRING("{} = {:.5g} ± {:.2g}{}"), entry.path, entry.value, entry.spread,
                                 entry.unit == "1" || entry.unit.empty() ? "" : " " + entry.unit));
  for (const FittedRun &run : found.runs)
    n_points += run.times.size();
  return fmt::format(FMT_STRING("{}, from {} points of {}."), boost::join(values, ", "), n_points,
                     found.runs.size() == 1 ? "one run" : std::to_string(found.runs.size()) + " runs");
}

} // namespace

Results tabulate_fit(const FitResult &found)
{
  Results results;
  Json &summary = results.findings.summary["fit"] = summary_of_fit(found);
  for (const FittedEntry &entry : found.entries)
    results.findings.key_figures[entry.path] = { entry.value, entry.spread };
  std::vector<double> number, time, measured, fitted;
  for (std::size_t r = 0; r < found.runs.size(); ++r)
  {
    const FittedRun &run = found.runs[r];
    number.insert(number.end(), run.times.size(), static_cast<double>(r) + 1);
    time.insert(time.end(), run.times.begin(), run.times.end());
    measured.insert(measured.end(), run.measured.begin(), run.measured.end());
    fitted.insert(fitted.end(), run.fitted.begin(), run.fitted.end());
    results.add_columns("fit_of_run_" + std::to_string(r + 1),
                        { { "time", run.times }, { "measured", run.measured }, { "fitted", run.fitted } });
  }
  const std::string unit = "rad/s or rad";
  const Table points = { "",
                         { numbers("run", "1", number), numbers("time", "s", time),
                           numbers("measured", unit, measured), numbers("fitted", unit, fitted) } };
  results.words = { { "title", title_of(found.study) + ": fit of measured runs" },
                    { "inputs", inputs_of(found.study) },
                    { "answer", answer_of(found) },
                    { "remarks", found.sentences },
                    { "sketch", sketch_labels(found.study) },
                    { "glasses", Json::array() } };
  results.entries = all_entries(found.study);
  results.add_rows("study_differences", changed_entries(found.study));
  const std::string entries = "entry value spread per_percent band unit",
                    runs = "name measured points start start_spread zero zero_spread noise autocorrelation";
  results.add_rows("fit_entries", summary["entries"], entries, "fit");
  results.add_rows("fit_runs", summary["runs"], runs, "fit");
  results.files = { { "summary.json", "all numbers, for programs" },
                    { "parameters.prm", "the study with the fitted values, to be run" },
                    { "fit.csv", "measured and fitted points", points },
                    { "timings.json", "how long it took" } };
  results.console = { { results.words["answer"] }, { "", table_of(summary["entries"], entries, "fit") } };
  for (const std::string &sentence : found.sentences)
    results.console.push_back({ sentence });
  return results;
}

} // namespace stemware::pipeline
