#pragma once

#include "fem/contact/foot.h"
#include "fem/pipeline/document/table.h"

#include <map>
#include <string>
#include <vector>

namespace stemware::pipeline
{

/// Findings of a verb as programs read them. SI units, or those of the study.
struct Findings
{
  /// The verb's own parts of summary.json, which stand between "parameters" and "files".
  nlohmann::ordered_json summary = nlohmann::ordered_json::object();
  /// The few numbers of the last line of --json.
  nlohmann::ordered_json key_figures = nlohmann::ordered_json::object();
};

/// Findings of a verb, and all that a template may show of them. SI units, or those of the study.
struct Document
{
  Findings findings; ///< for summary.json and --json
  /// Words, flags and derived numbers for sentences, and rows of tables; both see the findings too.
  nlohmann::ordered_json facts = nlohmann::ordered_json::object();
  std::map<std::string, Table> tables = {};                 ///< data files made of columns
  std::map<std::string, std::string> texts = {};            ///< files that are no table
  std::map<std::string, nlohmann::ordered_json> plots = {}; ///< values of a picture's own, by its name
  /// Quantities whose names depend on the study, as quantity_named() takes them.
  nlohmann::ordered_json quantities = nullptr;
};

} // namespace stemware::pipeline
