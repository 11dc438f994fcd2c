#pragma once

#include "fem/pipeline/analysis/quantity.h"
#include "fem/pipeline/result/pictures.h"

#include <string>

namespace stemware::pipeline
{

/// Machine-readable results of a verb, in SI units (or the study's consistent units).
struct Findings
{
  Json summary = Json::object(); ///< the verb's own parts of summary.json, between "parameters" and "files"
  Json key_figures = Json::object(); ///< key figures in the last line of --json
};

/// Findings of a verb with the words, tables and quantities of its page.
struct Document : Pictures
{
  Findings findings;                ///< for summary.json and --json
  Json quantities = Json::object(); ///< heading, unit and digits of the columns, by table and key
  Json entries = Json::array();     ///< all entries of the study

  /// Adds a table of the page.
  void add_table(const std::string &name, const Table &table);
};

} // namespace stemware::pipeline
