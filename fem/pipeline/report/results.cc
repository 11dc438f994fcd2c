#include "fem/pipeline/report/results.h"

#include "fem/pipeline/report/render/table_renderers.h"
#include "fem/pipeline/support/failures.h"
#include "fem/pipeline/support/text.h"
#include "fem/pipeline/support/text_file.h"

#include <fmt/format.h>
#include <sstream>

namespace stemware::pipeline
{

namespace
{

std::string text_of(const ResultFile &file)
{
  if (const auto *text = std::get_if<std::string>(&file.content))
    return *text;
  const Table &table = std::get<Table>(file.content);
  return std::filesystem::path(file.name).extension() == ".csv" ? csv_table(table) : data_table(table);
}

/// Lines that fit the console as they are, longer ones wrapped.
std::string wrapped_lines(const std::string &text)
{
  std::istringstream lines(text);
  std::string result;
  for (std::string line; std::getline(lines, line);)
    result += (line.size() <= console_width ? line : wrapped(line)) + '\n';
  return result;
}

} // namespace

ReportSection file_section(const std::vector<ResultFile> &files)
{
  ReportSection section = { "Files" };
  for (const ResultFile &file : files)
    if (!file.description.empty())
      section.files.push_back({ file.name, file.description });
  return section;
}

void write_fields(const std::vector<fem::FieldFile> &fields, const std::filesystem::path &folder)
{
  if (fields.empty())
    return;
  std::error_code error;
  std::filesystem::create_directory(folder / "fields", error); // another rank may have been faster
  if (error)
    throw OutputFailure(fmt::format(FMT_STRING("The folder fields of the results cannot be made ({}); choose "
                                               "a folder that all ranks can write to with --output."),
                                    error.message()));
  for (const fem::FieldFile &field : fields)
    write_text_file(folder / "fields" / field.name, field.text);
}

void write_results(const Results &results, const std::filesystem::path &folder, Stopwatch &stopwatch)
{
  for (const ResultFile &file : results.files)
    if (!std::holds_alternative<std::monostate>(file.content))
      write_text_file(folder / file.name, text_of(file));
  stopwatch.finish("tables");
  write_report(results.report, folder);
  stopwatch.finish("report");
}

std::string console_text(const Results &results)
{
  std::string text;
  for (const ConsoleBlock &block : results.console)
  {
    if (!block.text.empty())
      text += '\n' + wrapped_lines(block.text);
    if (block.table)
      text += '\n' + console_table(*block.table);
  }
  return text + '\n';
}

} // namespace stemware::pipeline
