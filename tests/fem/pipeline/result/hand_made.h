#pragma once

#include "fem/pipeline/analysis/spin_study.h"
#include "fem/pipeline/coupling/contact_report.h"
#include "fem/pipeline/result/results.h"
#include "fem/pipeline/result/table_renderers.h"
#include "tests/fem/pipeline/csv_table.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

/// Results made by hand, whose numbers are all different: a swapped column, unit or digit shows.
namespace stemware::test
{

/// 1.0101234567, 1.0201234567, ... 1.9901234567, 2.0001234567, ...
class Numbers
{
public:
  double operator()()
  {
    ++n;
    return std::stod(fmt::format(FMT_STRING("{}.{:02}01234567"), 1 + n / 100, n % 100));
  }

private:
  unsigned int n = 0;
};

/// Two rings with two harmonics.
inline ring::RingStack hand_made_rings(Numbers &next)
{
  std::vector<ring::RingStack::Ring> rings;
  for (unsigned int j = 0; j < 2; ++j)
  {
    const double radius = next(), a0 = next(), a1 = next(), b1 = next(), a2 = next(), b2 = next();
    rings.push_back({ radius, { a0, a1, a2 }, { 0, b1, b2 } });
  }
  return ring::RingStack(rings);
}

/// A ring with two harmonics.
inline ring::RingStack hand_made_load(Numbers &next)
{
  const double a0 = next(), a1 = next(), b1 = next(), a2 = next(), b2 = next(), radius = next();
  return ring::RingStack({ a0, a1, a2 }, { 0, b1, b2 }, radius);
}

inline ring::RingState hand_made_state(Numbers &next)
{
  ring::RingState state = { {}, hand_made_load(next) };
  state.friction = { next(), next(), next() };
  state.moment_ratio = next();
  state.minimum = -next();
  state.pulling_share = next() / 100;
  return state;
}

/// A row with everything.
inline ring::Answer hand_made_row(Numbers &next, unsigned int harmonics)
{
  ring::Answer row;
  row.harmonics = harmonics;
  row.at_rest = hand_made_state(next);
  const double omega = -next(), slope = -next();
  row.terminal = ring::TerminalSpin{ omega, slope, next(), true };
  row.at_terminal = hand_made_state(next);
  next();
  for (int i = 0; i < 3; ++i) // numbers that no row has
    next();
  row.status = ring::Status::lift_off;
  row.relative_change = next() / 100;
  for (int i = 0; i < 5; ++i) // numbers that no row has
    next();
  return row;
}

/// A row without a balance of moments at rest.
inline ring::Answer missing_row(unsigned int harmonics)
{
  ring::Answer row;
  row.harmonics = harmonics;
  row.status = ring::Status::no_balance;
  row.reason = "No balance of moments was found";
  return row;
}

inline pipeline::LoadReport hand_made_load_report(Numbers &next)
{
  pipeline::LoadReport load = { hand_made_rings(next) };
  load.normal_force = next();
  load.moment = { next(), next() };
  load.moment_ratio = next();
  load.mean_radius = next();
  load.contact_fraction = next() / 10;
  load.minimum = next();
  load.pointwise = { { 0.5, next() }, { 1.5, next() } };
  return load;
}

/// Columns as lines "heading: value value ...", so that a heading stands beside its values.
inline std::string as_lines(const std::vector<std::vector<std::string>> &columns)
{
  std::string lines;
  for (const std::vector<std::string> &column : columns)
    for (std::size_t i = 0; i < column.size(); ++i)
      lines += column[i] + (i == 0 ? ": " : i + 1 < column.size() ? " | " : "\n");
  return lines;
}

/// A data table, its title first, then a line for each column.
inline std::string data_lines(const std::string &text)
{
  std::istringstream lines(text);
  std::string title, line;
  std::vector<std::vector<std::string>> columns;
  std::getline(lines, title);
  while (std::getline(lines, line))
    if (line[0] == '#')
      columns.push_back({ line.substr(line.find(':') + 2) });
    else
    {
      std::istringstream numbers(line);
      for (std::vector<std::string> &column : columns)
        numbers >> column.emplace_back();
    }
  return title + '\n' + as_lines(columns);
}

/// A list of JSON objects, a line for each key.
inline std::string json_lines(const nlohmann::ordered_json &rows)
{
  std::vector<std::vector<std::string>> columns;
  for (const auto &[key, value] : rows.at(0).items())
    columns.push_back({ key });
  for (const auto &row : rows)
  {
    std::size_t c = 0;
    for (const auto &[key, value] : row.items())
      columns.at(c++).push_back(value.dump());
    if (c != columns.size())
      throw std::out_of_range("objects differ in their keys");
  }
  return as_lines(columns);
}

/// The results file of that name as it is written.
inline std::string file_text(const pipeline::Results &results, const std::string &name)
{
  for (const pipeline::ResultFile &file : results.files)
    if (file.name == name)
    {
      if (const auto *text = std::get_if<std::string>(&file.content))
        return *text;
      const auto &table = std::get<pipeline::Table>(file.content);
      return name.find(".csv") == std::string::npos ? data_table(table) : csv_table(table);
    }
  throw std::out_of_range("no file " + name);
}

/// The table that is the content of a results file, a line for each column, as data_lines() shows it.
inline std::string file_lines(const pipeline::Results &results, const std::string &name)
{
  for (const pipeline::ResultFile &file : results.files)
    if (file.name == name)
    {
      const std::string lines = data_lines(data_table(std::get<pipeline::Table>(file.content)));
      return lines.substr(lines.find('\n') + 1); // no file shows the title
    }
  throw std::out_of_range("no file " + name);
}

/// A table of the page, a line for each column, with its heading and unit as the page shows them.
inline std::string page_lines(const pipeline::Results &results, const std::string &name)
{
  const auto &table = results.tables.at(name);
  std::vector<std::vector<std::string>> columns;
  for (std::size_t c = 0; c < table["keys"].size(); ++c)
  {
    const auto &quantity = results.quantities.at(name).at(table["keys"][c].get<std::string>());
    const std::string unit = quantity["unit"];
    columns.push_back({ pipeline::with_unit(quantity["heading"], unit == "1" ? "" : unit) });
    for (const auto &cell : table["values"][c])
      columns.back().push_back(cell.is_string() ? cell.get<std::string>() : cell.dump());
  }
  return as_lines(columns);
}

} // namespace stemware::test
