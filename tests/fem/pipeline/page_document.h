#pragma once

#include "tests/fem/pipeline/program_runner.h"

namespace stemware::test
{

/// Document of the report.html in a folder of results, which its script draws. Keys: summary, tables, words,
/// entries, quantities, files.
inline nlohmann::json page_document(const std::filesystem::path &results)
{
  return nlohmann::json::parse(between(read_text(results / "report.html"), "id=\"document\">", "</script>"));
}

} // namespace stemware::test
