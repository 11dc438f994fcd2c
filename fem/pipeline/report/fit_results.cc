#include "fem/pipeline/report/fit_results.h"

#include "fem/pipeline/document/study_words.h"
#include "fem/pipeline/pictures/fit_pictures.h"

#include <boost/algorithm/string/join.hpp>

#include <fmt/format.h>

namespace stemware::pipeline
{

namespace
{

using Json = nlohmann::ordered_json;

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
  Results results = { document_of(found.study, "fit of measured runs") };
  Json &summary = results.findings.summary["fit"] = fit_summary(found);
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
  }
  const std::string unit = "rad/s or rad";
  const Table points = { "",
                         { numbers("run", "1", number), numbers("time", "s", time),
                           numbers("measured", unit, measured), numbers("fitted", unit, fitted) } };
  results.words["answer"] = answer_of(found);
  add_fit_columns(found, results);
  const std::string entries = "entry value spread per_percent band unit",
                    runs = "name measured points start start_spread zero zero_spread noise autocorrelation";
  results.add_rows("fit_entries", summary["entries"], entries, "fit");
  results.add_rows("fit_runs", summary["runs"], runs, "fit");
  results.files = { { "summary.json", "all numbers, for programs" },
                    { "parameters.prm", "the study with the fitted values, to be run" },
                    { "fit.csv", "measured and fitted points", points },
                    { "timings.json", "how long it took" } };
  results.console = { { results.words["answer"] }, { "", table_of(summary["entries"], entries, "fit") } };
  for (const FitSentence &sentence : found.sentences)
    results.console.push_back({ sentence.text });
  return results;
}

} // namespace stemware::pipeline
