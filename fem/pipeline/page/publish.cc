#include "fem/pipeline/page/publish.h"

#include "fem/pipeline/base/console.h"
#include "fem/pipeline/base/failures.h"
#include "fem/pipeline/base/program.h"
#include "fem/pipeline/base/ranks.h"
#include "fem/pipeline/base/text_file.h"
#include "fem/pipeline/page/page.h"
#include "fem/pipeline/study/study_file.h"

#include <cmath>
#include <fmt/format.h>
#include <iostream>
#include <set>

namespace stemware::pipeline
{

namespace fs = std::filesystem;

namespace
{

/// Writes the files into the subfolder "fields" of @p folder. Precondition: the file system of @p folder is
/// shared by all ranks.
void write_fields(const std::vector<fem::FieldFile> &fields, const fs::path &folder)
{
  if (fields.empty())
    return;
  std::error_code error;
  fs::create_directory(folder / "fields", error); // another rank may have created the folder already
  if (error)
    throw OutputFailure(fmt::format(FMT_STRING("The folder fields of the results cannot be made ({}); choose "
                                               "a folder that all ranks can write to with --output."),
                                    error.message()));
  for (const fem::FieldFile &field : fields)
    write_text_file(folder / "fields" / field.name, field.text);
}

Json page_document(const Results &results, Json summary)
{
  for (const char *load : { "load", "load_at_terminal", "load_at_fall" })
    if (summary.contains(load) && summary[load].is_object())
      summary[load].erase("rings");
  Json files = Json::array();
  for (const ResultFile &file : results.files)
    if (!file.description.empty())
      files.push_back({ file.name, file.description });
  return { { "summary", summary },         { "tables", results.tables },         { "words", results.words },
           { "entries", results.entries }, { "quantities", results.quantities }, { "files", files } };
}

void write_results(const StudyOptions &options, Results &results, Stopwatch &stopwatch, const fs::path &place,
                   const fs::path &final_place)
{
  for (const ResultFile &file : results.files)
    if (const auto *text = std::get_if<std::string>(&file.content))
      write_text_file(place / file.name, *text);
    else if (const auto *table = std::get_if<Table>(&file.content))
      write_text_file(place / file.name, csv_table(*table));
  stopwatch.finish("tables");
  results.study = with_paths_from(final_place, results.study);
  write_text_file(place / "parameters.prm", study_as_prm(results.study));
  Json summary = summary_of(options.verb, results);
  write_text_file(place / "report.html",
                  page_of(page_document(results, summary), results.words["title"], results.words["answer"]));
  stopwatch.finish("report");
  std::set<std::string> files = { "summary.json", "timings.json", "report.html" };
  for (const ResultFile &file : results.files)
    files.insert(fs::path(file.name).begin()->string());
  summary["files"] = files;
  write_text_file(place / "summary.json", dump_utf8(summary, 2) + "\n");
  stopwatch.finish("summary");
  Json timings = Json::object();
  for (const auto &[stage, seconds] : stopwatch.times())
    timings[stage] = seconds;
  write_text_file(place / "timings.json", timings.dump(2) + "\n");
}

void print(const StudyOptions &options, const Results &results, const fs::path &final_place)
{
  console() << console_text(results);
  const fs::path place = options.results_place();
  console() << "Results   " << place.string() << "\nReport    " << (final_place / "report.html").string()
            << std::endl;
  if (!options.json)
    return;
  Json line = { { "verb", options.verb },
                { "results", place.string() },
                { "summary", (place / "summary.json").string() },
                { "report", (place / "report.html").string() } };
  line.update(results.key_figures);
  std::cout << dump_utf8(line) << std::endl;
}

} // namespace

Json summary_of(const std::string &verb, const Results &results)
{
  Json summary = { { "schema", 3 },
                   { "program", { { "version", program_version() }, { "revision", program_revision() } } },
                   { "verb", verb },
                   { "parameters", study_as_json(entries_of(results.study)) } };
  summary.update(results.summary);
  const Json flat = summary.flatten();
  for (const auto &[path, value] : flat.items())
    if (value.is_number_float() && !std::isfinite(value.get<double>()))
      throw std::runtime_error("The result summary" + path +
                               " is not a finite number; please report this study.");
  return summary;
}

void publish(const StudyOptions &options, Results results, ResultsFolder &folder, Stopwatch &stopwatch)
{
  // A killed run leaves no incomplete results: the working folder is renamed only when it is complete.
  folder.open();
  on_every_rank([&] { write_fields(results.fields, folder.working_folder()); });
  results.fields = {}; // frees memory
  on_first_rank(
    [&]
    {
      write_results(options, results, stopwatch, folder.working_folder(), folder.final_folder());
      folder.publish();
    });
  if (is_first_rank())
    print(options, results, folder.final_folder());
}

void publish_in(const fs::path &folder, const StudyOptions &options, Results results, Stopwatch &stopwatch)
{
  write_results(options, results, stopwatch, folder, fs::absolute(folder));
  print(options, results, fs::absolute(folder));
}

} // namespace stemware::pipeline
