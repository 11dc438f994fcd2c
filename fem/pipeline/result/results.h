#pragma once

#include "fem/contact/foot.h"
#include "fem/pipeline/result/document.h"

#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace stemware::pipeline
{

/// A file of the results folder.
struct ResultFile
{
  std::string name; ///< relative to the results folder; .csv decides for CSV, anything else for a data table
  std::string description; ///< description in the page's list of files; empty: not listed
  /// Table, text, or std::monostate for a file written elsewhere.
  std::variant<std::monostate, Table, std::string> content = {};
};

/// Part of the console output: a text, whose long lines are wrapped, and a table.
struct ConsoleBlock
{
  std::string text;
  std::optional<Table> table = {};
};

/// Results of a verb: the document of its page, files, and the console's texts.
struct Results : Document
{
  std::vector<ResultFile> files = {};
  std::vector<ConsoleBlock> console = {};
  std::vector<fem::FieldFile> fields = {}; ///< files of fields/ to be written by this rank
};

/// Returns the blocks, with an empty line before each and after the last.
std::string console_text(const Results &results);

} // namespace stemware::pipeline
