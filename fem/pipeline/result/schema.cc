#include "fem/pipeline/result/common_sections.h"
#include "fem/pipeline/result/curves.h"
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

/// Returns the files of an answer that has all columns.
std::vector<ResultFile> example_files()
{
  StudyAnswer example;
  example.contact.load = { fem::ContactLoad(ring::RingStack({ { 1, { 1 }, { 0 } }, { 2, { 1 }, { 0 } } })) };
  example.contact.foot = FootReport();
  example.contact.foot->footprint_at_end = fem::PressureMap();
  SpinStudy &spin = example.spin;
  spin.rows.by_harmonics.emplace_back().row.terminal = ring::TerminalSpin();
  example.budget.emplace().rows.emplace_back();
  spin.torque.n_first = 1;
  spin.spin_up.driven = DrivenSpinUp();
  spin.phases = PhaseStudy();
  spin.torque_effects.rows.emplace_back();
  std::vector<ResultFile> files = run_files(example);
  files.push_back(
    { "torque_changes.csv", "", torque_change_columns(spin.torque_effects).table({}, Face::file) });
  LoadReport load;
  load.azimuth_fraction = load.contact_width = load.peak_pressure = 1;
  ErrorBands bands;
  for (const QuantityOfInterest &quantity :
       quantities_of_interest({}, load, Eigen::Vector3d::Zero(), {}, { { 0.5, 0 }, { 1.5, 0 } }))
    bands.push_back({ quantity });
  files.push_back({ "converge.csv", "", level_table({}, bands) });
  return files;
}

Json sweep_file_columns()
{
  Json columns = { { "case", column_facts({ "case", "1", "", "case", "case" }) } };
  columns["*"] = column_facts(
    { "*", "*", "", "*", "an entry that differs from case to case, Section/Entry, in its unit" });
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
  Json columns = Json::object();
  for (const ResultFile &file : example_files())
    if (const Table *table = std::get_if<Table>(&file.content))
      columns[file.name] = columns_of(*table);
  columns["sweep.csv"] = sweep_file_columns();
  return columns;
}

Json schema()
{
  const Json text = { { "type", "string" } };
  const Json program = schema_of_object({ { "version", "", "Its version.", "", "", "", "", "", text },
                                          { "revision", "", "Its commit.", "", "", "", "", "", text } });
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
  for (const Json &verb :
       { run_fields().schema(), truncate_fields().schema(), converge_schema(), sweep_schema() })
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
  if (part == "sweep.csv")
    for (const Quantity &quantity : sweep_columns())
      if (quantity.key == key)
        return quantity.unit;
  const Json properties = run_fields().schema()["properties"];
  if (!properties.contains(part))
    return "";
  const Json &object = properties[part].contains("items") ? properties[part]["items"] : properties[part];
  const Json property = object["properties"].value(key, Json::object());
  const Json type = property.value("type", Json());
  const bool is_text = type == "string" || type == Json{ "string", "null" };
  return property.value("unit", is_text ? "" : "1");
}

} // namespace stemware::pipeline
