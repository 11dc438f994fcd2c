#pragma once

#include "tests/fem/pipeline/program_runner.h"

namespace stemware::test
{

/// Returns the JSON document embedded in report.html in @p results. Keys: summary, tables, words, entries,
/// quantities, files.
inline nlohmann::json page_document(const std::filesystem::path &results)
{
  return nlohmann::json::parse(between(read_text(results / "report.html"), "id=\"document\">", "</script>"));
}

} // namespace stemware::test
