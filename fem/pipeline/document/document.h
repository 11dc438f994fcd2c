#pragma once

#include "fem/pipeline/document/table.h"
#include "fem/pipeline/pictures/pictures.h"

#include <string>

namespace stemware::pipeline
{

/// Machine-readable results of a verb, in SI units (or the study's consistent units).
struct Findings
{
  /// The verb's own parts of summary.json, between "parameters" and "files".
  nlohmann::ordered_json summary = nlohmann::ordered_json::object();
  /// Key figures in the last line of --json.
  nlohmann::ordered_json key_figures = nlohmann::ordered_json::object();
};

/// Findings of a verb with the words, tables and quantities of its page.
struct Document : Pictures
{
  Findings findings; ///< for summary.json and --json
  /// Heading, unit and digits of the columns, by table and key.
  nlohmann::ordered_json quantities = nlohmann::ordered_json::object();
  nlohmann::ordered_json entries = nlohmann::ordered_json::array(); ///< all entries of the study

  /// Adds the table @p name of table_of(@p rows, @p keys, @p section) with its quantities; @p section is by
  /// default the name.
  void add_rows(const std::string &name, const nlohmann::ordered_json &rows, const std::string &keys = "",
                const std::string &section = "");

  /// Adds the listed numbers of the part @p name of the findings as the table @p name, one row each.
  void add_list(const std::string &name);
};

} // namespace stemware::pipeline
