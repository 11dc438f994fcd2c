#include "fem/pipeline/analysis/sweep_case.h"
#include "fem/pipeline/base/failures.h"
#include "fem/pipeline/base/numbers.h"
#include "fem/pipeline/base/text_file.h"
#include "fem/pipeline/study/data_files.h"
#include "fem/pipeline/study/quantity_text.h"
#include "fem/pipeline/study/study_entries.h"
#include "fem/pipeline/study/study_file.h"
#include "fem/pipeline/study/table_file.h"

#include <boost/algorithm/string/split.hpp>
#include <boost/algorithm/string/trim.hpp>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <set>

namespace stemware::pipeline
{

namespace
{

/// Maximum number of cases, so that their texts fit into memory.
constexpr std::size_t max_cases = 1000000;

/// Returns @p value as a study file would state it, in SI units. Assigns the value to @p entry.
std::string canonical(const StudyEntry &entry, const std::string &origin, const std::string &value)
{
  assign(entry, origin, value);
  if (entry.path_value != nullptr)
    require_regular_file(origin + entry.path() + " = " + shortened_path(value), value);
  return entry.text();
}

std::vector<std::string> pieces(const std::string &text, char separator)
{
  std::vector<std::string> parts;
  boost::split(parts, text, [separator](char letter) { return letter == separator; });
  for (std::string &part : parts)
    boost::trim(part);
  return parts;
}

/// Returns @p value, rounded to the 15th significant digit of the larger of |first| and |last|.
double snapped(double value, double first, double last)
{
  const double largest = std::max(std::abs(first), std::abs(last));
  if (largest == 0)
    return 0;
  const double unit = std::pow(10., std::floor(std::log10(largest)) - 14);
  return rounded(std::round(value / unit) * unit, 15) + 0.; // + 0. avoids -0
}

std::vector<std::string> range_values(const std::string &origin, const std::vector<std::string> &parts,
                                      const std::string &unit)
{
  const auto check = [&](bool is_good, const std::string &trouble)
  {
    ensure(is_good, origin + trouble +
                      "; write \"Section/Entry=first:last:number\", the same with :log at its end for equal "
                      "factors, or a list \"Section/Entry=a,b,c\".");
  };
  const bool is_log = parts.size() == 4 && parts.back() == "log";
  check(parts.size() == 3 || is_log, "is not a range");
  const std::vector<std::string> ends = with_shared_unit({ parts[0], parts[1] });
  for (const std::string &end : ends)
    if (const std::string trouble = unit_error(end, unit); !trouble.empty())
      throw BadInput(fmt::format(FMT_STRING("{}: {}{}"), origin, shortened(end), trouble));
  check(trailing_unit(ends[0]).empty() == trailing_unit(ends[1]).empty(),
        "has a unit behind its first number only");
  const auto first = parse_quantity(ends[0], unit), last = parse_quantity(ends[1], unit);
  const auto n = parse_count(parts[2]);
  check(first && last, "does not range from one number to another");
  check(n && *n >= 2 && *n <= max_cases,
        "does not ask for a whole number of values from 2 to " + std::to_string(max_cases));
  check(!is_log || (*first > 0 && *last > 0), "goes by factors, but not between two numbers greater than 0");
  std::vector<std::string> values;
  for (unsigned int i = 0; i < *n; ++i)
  {
    const double share = static_cast<double>(i) / (*n - 1);
    values.push_back(to_text(is_log ? rounded(*first * std::pow(*last / *first, share), 15)
                                    : snapped(*first + (*last - *first) * share, *first, *last)));
  }
  values.front() = to_text(*first);
  values.back() = to_text(*last);
  return values;
}

VariedEntry parse_varied(const std::string &text)
{
  const std::string quoted = "--vary \"" + shortened(text) + "\" ";
  const auto equal_sign = text.find('=');
  ensure(equal_sign != text.npos && text.find('/') < equal_sign,
         quoted + "is not of the form \"Section/Entry=values\"; `stemware sweep --help` shows examples.");
  const StudyEntry entry = find_entry("--vary: ", boost::trim_copy(text.substr(0, equal_sign)));
  const std::string given = boost::trim_copy(text.substr(equal_sign + 1));
  ensure(!given.empty(), quoted + "names no values; write \"" + entry.path() + "=first:last:number\".");
  VariedEntry varied = { entry.path(), entry.unit };
  const std::vector<std::string> parts = pieces(given, ':');
  if (parts.size() > 1 && !entry.unit.empty())
  {
    varied.values = range_values(quoted, parts, entry.unit);
    varied.by_factors = parts.size() == 4;
  }
  else
    varied.values = entry.unit.empty() ? pieces(given, ',') : with_shared_unit(pieces(given, ','));
  std::set<std::string> seen;
  for (std::string &value : varied.values)
  {
    value = canonical(entry, "--vary: ", value);
    ensure(seen.insert(value).second,
           "--vary: " + entry.path() + " = " + shortened(value) + " stands twice; give each value once.");
  }
  return varied;
}

void require_different(const CaseList &list)
{
  std::set<std::string> paths;
  for (const VariedEntry &entry : list.entries)
    ensure(paths.insert(entry.path).second,
           list.origin + " varies " + entry.path + " twice; give all its values in one place.");
}

void require_unit(const StudyEntry &entry, const std::string &name, const std::string &unit,
                  const std::string &place)
{
  const bool is_plain = unit.empty() || entry.unit.empty();
  const std::string trouble = is_plain ? "" : unit_error("1 " + unit, entry.unit);
  ensure(trouble.empty() && (unit.empty() || !entry.unit.empty()),
         place + name + " (" + shortened(unit) + ")" +
           (trouble.empty() ? " is words; leave the unit out." : trouble));
}

} // namespace

Study CaseList::study_of(std::size_t index) const
{
  std::vector<std::pair<std::string, std::string>> values;
  for (std::size_t i = 0; i < entries.size(); ++i)
    values.emplace_back(entries[i].path, cases.at(index)[i]);
  return with_values(base, origin, values);
}

std::string CaseList::values_of(std::size_t index) const
{
  std::string text;
  for (std::size_t i = 0; i < entries.size(); ++i)
  {
    const auto number = entries[i].unit.empty() ? std::nullopt : parse_number(cases.at(index)[i]);
    text += (i == 0 ? "" : ", ") + entries[i].path + " = " +
            (number ? to_short_text(*number) : shortened(cases[index][i])) +
            (number && entries[i].unit != "1" ? " " + entries[i].unit : "");
  }
  return text;
}

CaseList cases_of_grid(const std::vector<std::string> &varied)
{
  ensure(varied.size() <= 2,
         fmt::format(FMT_STRING("--vary names {} entries and takes one or two; write the cases of more "
                                "entries into a table and give it with --cases."),
                     varied.size()));
  CaseList list = { "--vary", {}, {}, { {} } };
  for (const std::string &text : varied)
  {
    const VariedEntry &entry = list.entries.emplace_back(parse_varied(text));
    ensure(list.cases.size() * entry.values.size() <= max_cases,
           fmt::format(FMT_STRING("--vary asks for {} cases, but at most {} are possible; ask for fewer."),
                       list.cases.size() * entry.values.size(), max_cases));
    std::vector<std::vector<std::string>> cases;
    for (const auto &before : list.cases)
      for (const std::string &value : entry.values)
        cases.emplace_back(before).push_back(value);
    list.cases = std::move(cases);
  }
  require_different(list);
  return list;
}

CaseList cases_from_file(const std::string &file)
{
  CaseList list = { "--cases " + shortened_path(file) };
  const TextTable table = parse_table(list.origin, read_input_text(list.origin, file));
  ensure(table.rows.size() >= 2,
         list.origin + " has no cases; write a first row of entries such as \"Motion/Mass (g)\", and a row "
                       "of values for each case.");
  const auto &header = table.rows.front();
  std::vector<StudyEntry> entries;
  std::vector<std::string> units;
  for (std::size_t i = 0; i < header.cells.size(); ++i)
  {
    const auto [name, unit] = parse_heading(header.cells[i]);
    const std::string place = position_in_table(list.origin, header.line, i);
    entries.push_back(find_entry(place, name));
    require_unit(entries.back(), name, unit, place);
    units.push_back(unit);
    list.entries.push_back({ entries.back().path(), entries.back().unit });
  }
  require_different(list);
  for (auto row = table.rows.begin() + 1; row != table.rows.end(); ++row)
  {
    ensure(row->cells.size() == entries.size(),
           fmt::format(FMT_STRING("{}, line {}: the row has {} cells, but there are {} columns; write one "
                                  "value for each."),
                       list.origin, row->line, row->cells.size(), entries.size()));
    std::vector<std::string> &values = list.cases.emplace_back();
    for (std::size_t i = 0; i < entries.size(); ++i)
    {
      const bool is_number = !entries[i].unit.empty();
      std::string cell = is_number ? table.with_point(row->cells[i]) : row->cells[i];
      if (is_number && parse_number(cell) && !units[i].empty())
        cell += ' ' + units[i];
      values.push_back(canonical(entries[i], position_in_table(list.origin, row->line, i), cell));
    }
  }
  ensure(list.cases.size() <= max_cases,
         fmt::format(FMT_STRING("{} has {} cases, but at most {} are possible; split it."), list.origin,
                     list.cases.size(), max_cases));
  return list;
}

} // namespace stemware::pipeline
