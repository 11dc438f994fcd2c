#include "fem/pipeline/report/publish.h"

#include "fem/pipeline/study/study_entries.h"
#include "fem/pipeline/study/study_file.h"
#include "fem/pipeline/support/console.h"
#include "fem/pipeline/support/json_text.h"
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

void require_finite(const Json &value, const std::string &path)
{
  if (value.is_number_float() && !std::isfinite(value.get<double>()))
    throw std::runtime_error("The result " + path + " is not a finite number; please report this study.");
  if (value.is_structured())
    for (const auto &[key, part] : value.items())
      require_finite(part, path + "/" + key);
}

void write_and_publish(const StudyOptions &options, const std::optional<Study> &study,
                       const Findings &findings, Stopwatch &stopwatch, ResultsFolder &folder)
{
  const fs::path &place = folder.working_folder();
  Json summary = { { "schema", 2 },
                   { "program", { { "version", program_version() }, { "revision", program_revision() } } },
                   { "verb", options.verb } };
  if (study)
  {
    const Study echo = with_paths_from(folder.final_folder(), *study);
    write_text_file(place / "parameters.prm", study_as_prm(echo));
    summary["parameters"] = study_as_json(echo);
  }
  summary.update(findings.summary);
  std::vector<std::string> files = folder.contents();
  files.insert(files.end(), { "summary.json", "timings.json" });
  std::sort(files.begin(), files.end());
  summary["files"] = files;
  require_finite(summary, "summary");
  write_text_file(place / "summary.json", summary.dump(2) + "\n");
  stopwatch.finish("summary");
  write_text_file(place / "timings.json", sealed_text(stopwatch.times()));
  folder.publish();
}

} // namespace

void publish(const StudyOptions &options, const std::optional<Study> &study, const Results &results,
             ResultsFolder &folder, Stopwatch &stopwatch)
{
  // The folder is whole before it gets its name.
  on_every_rank([&] { write_fields(results.fields, folder.working_folder()); });
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
  const std::string report = (place / "report.html").string();
  console() << "Results   " << place.string() << "\nReport    "
            << fs::absolute(report).lexically_normal().string() << std::endl;
  if (!options.json)
    return;
  Json line = { { "verb", options.verb },
                { "results", place.string() },
                { "summary", (place / "summary.json").string() },
                { "report", report } };
  line.update(results.findings.key_figures);
  std::cout << line.dump() << std::endl;
}

} // namespace stemware::pipeline
