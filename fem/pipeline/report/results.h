#pragma once

#include "fem/contact/foot.h"
#include "fem/pipeline/document/document.h"

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
  std::string description; ///< in the page's list of files; empty: not listed there
  /// A table, a text as it stands, or nothing for a file that is written elsewhere.
  std::variant<std::monostate, Table, std::string> content = {};
};

/// A part of what the console shows: a text, whose long lines are wrapped, and a table.
struct ConsoleBlock
{
  std::string text;
  std::optional<Table> table = {};
};

/// Results of a verb: the document of its page, files, and the console's texts.
struct Results : Document
{
  std::vector<ResultFile> files;
  std::vector<ConsoleBlock> console;
  std::vector<fem::FieldFile> fields = {}; ///< for fields/, those that this rank writes
};

/// The blocks, an empty line before each and after the last.
std::string console_text(const Results &results);

} // namespace stemware::pipeline
