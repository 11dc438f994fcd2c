#include "fem/pipeline/result/schema.h"

#include "fem/pipeline/result/common_sections.h"
#include "fem/pipeline/result/verb_results.h"

namespace stemware::pipeline
{

namespace
{

Json column_facts(const Quantity &quantity)
{
  return { { "name", quantity.name }, { "unit", quantity.unit }, { "label", quantity.column } };
}

Json columns_of(const Table &table)
{
  Json columns = Json::object();
  for (const auto &[quantity, cells] : table.columns)
    columns[quantity.key] = column_facts(quantity);
  return columns;
}

/// Returns error bands of all quantities that converge.csv may contain.
ErrorBands all_bands()
{
  LoadReport load;
  load.azimuth_fraction = load.peak_pressure = load.contact_width = 1;
  ErrorBands bands;
  for (const QuantityOfInterest &quantity :
       quantities_of_interest({}, load, Eigen::Vector3d::Zero(), { 0, spins_of_interest(1), { 0, 0 } }))
    bands.push_back({ quantity });
  return bands;
}

Json sweep_file_columns()
{
  Json columns = { { "case", column_facts({ "case", "1", "", "case", "case" }) } };
  columns["*"] = { { "name", "*" },
                   { "unit", "*" },
                   { "label", "an entry that differs from case to case, Section/Entry, in its unit" } };
  for (Quantity quantity : sweep_columns())
  {
    quantity.name = quantity.key;
    columns[quantity.key] = column_facts(quantity);
  }
  for (const auto &[key, label] :
       { std::pair("contact_outcome", "ending of the contact at rest"),
         std::pair("status", "ok, tips or failed"), std::pair("message", "why the case failed") })
    columns[key] = column_facts({ key, "", "", key, label });
  return columns;
}

Json files()
{
  TorqueCurve torque;
  torque.n_first = 1;
  ring::TorqueEffects effects;
  effects.rows = { ring::TorqueEffect() };
  return { { "load.csv",
             columns_of(load_table(ring::RingStack({ { 1, { 1 }, { 0 } }, { 2, { 1 }, { 0 } } }))) },
           { "rings.csv", columns_of(ring_table(LoadReport().rings)) },
           { "load_lines.csv", columns_of(pointwise_table({})) },
           { "footprint.csv", columns_of(footprint_table({})) },
           { "footprint_at_end.csv", columns_of(footprint_table({})) },
           { "torque.csv", columns_of(torque_table(torque)) },
           { "spin_up.csv", columns_of(spin_up_table({})) },
           { "driven_spin_up.csv", columns_of(driven_spin_table({})) },
           { "phases.csv", columns_of(phase_table({})) },
           { "contact_history.csv", columns_of(history_table({})) },
           { "budget.csv", columns_of(chain_fields().table({}, Face::file)) },
           { "without.csv", columns_of(without_fields().table({}, Face::file)) },
           { "truncation.csv", columns_of(truncation_fields().table({}, Face::file)) },
           { "torque_changes.csv", columns_of(torque_change_table(effects)) },
           { "converge.csv", columns_of(level_table({}, all_bands())) },
           { "sweep.csv", sweep_file_columns() } };
}

Json schema()
{
  const auto text = [](const char *description) -> Json {
    return { { "type", "string" }, { "description", description } };
  };
  const Json program =
    schema_of_object({ { "version", "", "Its version.", "", "", "", "", "", text("Its version.") },
                       { "revision", "", "Its commit.", "", "", "", "", "", text("Its commit.") } });
  Json properties = {
    { "schema",
      { { "type", "integer" },
        { "description", "Version of this schema; increases if a key changes its meaning or is removed." },
        { "const", 3 } } },
    { "program", { { "description", "Name, version and revision of the program." } } },
    { "verb",
      { { "type", "string" },
        { "description", "Verb of the command." },
        { "enum", { "run", "truncate", "converge", "sweep" } } } },
    { "parameters",
      { { "type", "object" },
        { "description",
          "All entries of the study, by section and entry; numbers in the units of `stemware defaults`." },
        { "additionalProperties", { { "type", "object" } } } } },
    { "files",
      { { "type", "array" },
        { "description", "Names of all files in the folder." },
        { "items", { { "type", "string" } } } } }
  };
  properties["program"].update(program);
  for (const Json &verb : { run_schema(), truncate_schema(), converge_schema(), sweep_schema() })
    for (const auto &[key, property] : verb["properties"].items())
      if (!properties.contains(key))
        properties[key] = property;
  for (const char *load : { "load_at_terminal", "load_at_fall" })
    properties[load] = { { "description", properties[load]["description"] },
                         { "anyOf", { { { "$ref", "#/properties/load" } }, { { "type", "null" } } } } };
  return {
    { "$schema", "http://json-schema.org/draft-07/schema#" },
    { "title", "summary.json of Stemware" },
    { "description",
      "All results of a verb as numbers. SI units, angles in rad, slip frame (x along the direction of "
      "travel). Missing numbers are null." },
    { "definitions", { { "files", files() } } },
    { "type", "object" },
    { "properties", properties },
    { "required", { "schema", "program", "verb", "files" } },
    { "additionalProperties", false }
  };
}

} // namespace

std::string summary_schema()
{
  return schema().dump(1) + '\n';
}

std::string unit_in_summary(const std::string &part, const std::string &key)
{
  const Json properties = run_schema()["properties"];
  if (!properties.contains(part))
    return "";
  const Json &object = properties[part].contains("items") ? properties[part]["items"] : properties[part];
  const Json property = object["properties"].value(key, Json::object());
  const Json type = property.value("type", Json());
  const bool is_text = type == "string" || type == Json{ "string", "null" };
  return property.value("unit", is_text ? "" : "1");
}

} // namespace stemware::pipeline
