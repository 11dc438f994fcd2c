#include "fem/pipeline/output/publish.h"

#include "fem/pipeline/study/study_entries.h"
#include "fem/pipeline/study/study_file.h"
#include "fem/pipeline/support/console.h"
#include "fem/pipeline/support/manifest.h"
#include "fem/pipeline/support/program.h"
#include "fem/pipeline/support/ranks.h"
#include "fem/pipeline/support/text_file.h"

#include <algorithm>
#include <cmath>
#include <iostream>

namespace stemware::pipeline
{

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace
{

std::string path_below(const std::string &path, const std::string &key)
{
  return path + "/" + key;
}

void require_finite(const Json &value, const std::string &path)
{
  if (value.is_number_float() && !std::isfinite(value.get<double>()))
    throw std::runtime_error("The result " + path + " is not a finite number; please report this study.");
  if (value.is_structured())
    for (const auto &[key, part] : value.items())
      require_finite(part, path_below(path, key));
}

/// summary.json as text. @p files are the names of all that is in the results folder.
std::string summary_text(const std::string &verb, const std::optional<Study> &study, const Json &findings,
                         const std::vector<std::string> &files)
{
  Json all = { { "schema", 1 },
               { "program", { { "version", program_version() }, { "revision", program_revision() } } },
               { "verb", verb } };
  if (study)
    all["parameters"] = study_as_json(*study);
  all.update(findings);
  all["files"] = files;
  require_finite(all, "summary");
  return all.dump(2) + "\n";
}

void write_and_publish(const StudyOptions &options, const std::optional<Study> &study,
                       const Findings &findings, Stopwatch &stopwatch, ResultsFolder &folder)
{
  const fs::path &place = folder.working_folder();
  std::optional<Study> echo;
  if (study)
  {
    echo = with_paths_from(folder.final_folder(), *study);
    write_text_file(place / "parameters.prm", study_as_prm(*echo));
  }
  std::vector<std::string> files = folder.contents();
  files.insert(files.end(), { "summary.json", "timings.json" });
  std::sort(files.begin(), files.end());
  write_text_file(place / "summary.json", summary_text(options.verb, echo, findings.summary, files));
  stopwatch.finish("summary");
  write_text_file(place / "timings.json", sealed_text(stopwatch.times()));
  folder.publish();
}

} // namespace

void publish(const StudyOptions &options, const std::optional<Study> &study, const Results &results,
             ResultsFolder &folder, Stopwatch &stopwatch)
{
  on_first_rank(
    [&]
    {
      write_results(results, folder.working_folder(), stopwatch);
      write_and_publish(options, study, results.findings, stopwatch, folder);
    });
  if (!is_first_rank())
    return;
  console() << console_text(results);
  const fs::path place = options.results_place();
  const fs::path report = place / "report.html";
  const bool has_report = fs::exists(report);
  console() << "Results   " << place.string() << '\n';
  if (has_report)
    console() << "Report    " << report.string() << '\n';
  console() << std::flush;
  if (!options.json)
    return;
  Json line = { { "verb", options.verb },
                { "results", place.string() },
                { "summary", (place / "summary.json").string() },
                { "report", has_report ? Json(report.string()) : Json(nullptr) } };
  line.update(results.findings.key_figures);
  std::cout << line.dump() << std::endl;
}

} // namespace stemware::pipeline
