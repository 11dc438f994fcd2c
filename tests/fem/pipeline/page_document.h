#pragma once

#include "tests/fem/pipeline/program_runner.h"

namespace stemware::test
{

/// Returns the JSON document embedded in the report.html of a results folder. Keys: summary, tables, words,
/// entries, quantities, files.
inline nlohmann::json page_document(const std::filesystem::path &results)
{
  return nlohmann::json::parse(between(read_text(results / "report.html"), "id=\"document\">", "</script>"));
}

} // namespace stemware::test
