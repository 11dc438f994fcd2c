#include "fem/pipeline/analysis/sweep/varied_entry.h"

#include "fem/pipeline/study/quantity_text.h"
#include "fem/pipeline/study/study_file.h"
#include "fem/pipeline/support/failures.h"
#include "fem/pipeline/support/numbers.h"

#include <boost/algorithm/string/split.hpp>
#include <boost/algorithm/string/trim.hpp>

#include <algorithm>
#include <cmath>

namespace stemware::pipeline
{

namespace
{

constexpr unsigned int most_values = 100000;

std::vector<std::string> pieces(const std::string &text, char separator)
{
  std::vector<std::string> parts;
  boost::split(parts, text, [separator](char letter) { return letter == separator; });
  for (std::string &part : parts)
    boost::trim(part);
  return parts;
}

[[noreturn]] void refuse_range(const std::string &text, const std::string &trouble)
{
  throw BadInput("--vary \"" + shortened(text) + "\" " + trouble +
                 "; write \"Section/Entry=first:last:number\", the same with :log at its end for equal "
                 "factors, or a list \"Section/Entry=a,b,c\".");
}

/// @p value with the digits that are known of numbers between @p first and @p last: 15 of the larger one.
double snapped(double value, double first, double last)
{
  const double largest = std::max(std::abs(first), std::abs(last));
  if (largest == 0)
    return 0;
  const double unit = std::pow(10., std::floor(std::log10(largest)) - 14);
  return rounded(std::round(value / unit) * unit, 15) + 0.; // no -0
}

/// The values of first:last:number or first:last:number:log, in @p unit.
std::vector<std::string> range_values(const std::string &text, const std::vector<std::string> &parts,
                                      const std::string &unit)
{
  const bool is_log = parts.size() == 4 && parts.back() == "log";
  if (parts.size() == 2)
    refuse_range(text, "is not a range (did you mean \"" + shortened(text) + ":5\", five values?)");
  if (parts.size() != 3 && !is_log)
    refuse_range(text, "is not a range");
  const std::vector<std::string> ends = with_shared_unit({ parts[0], parts[1] });
  if (unit_behind(ends.front()).empty() != unit_behind(ends.back()).empty())
    refuse_range(text, "has a unit behind its first number only");
  const auto first = parse_quantity(ends.front(), unit);
  const auto last = parse_quantity(ends.back(), unit);
  for (const std::string &end : ends)
    if (const std::string trouble = trouble_with_unit(end, unit); !trouble.empty())
      throw BadInput("--vary \"" + shortened(text) + "\": " + shortened(end) + trouble);
  const auto number = parse_count(parts[2]);
  if (!first || !last)
    refuse_range(text, "does not range from one number to another");
  if (!number || *number < 2 || *number > most_values)
    refuse_range(text, "does not ask for a whole number of values from 2 to " + std::to_string(most_values));
  if (is_log && !(*first > 0 && *last > 0))
    refuse_range(text, "goes by factors, but not between two numbers greater than 0");
  std::vector<std::string> values;
  for (unsigned int i = 0; i < *number; ++i)
  {
    const double share = static_cast<double>(i) / (*number - 1);
    values.push_back(to_text(is_log ? rounded(*first * std::pow(*last / *first, share), 15)
                                    : snapped(*first + (*last - *first) * share, *first, *last)));
  }
  values.front() = to_text(*first);
  values.back() = to_text(*last);
  return values;
}

} // namespace

std::string range_meant_by(const std::string &value, const std::string &unit)
{
  constexpr std::size_t longest = 60;
  if (unit.empty() || value.size() > longest)
    return "";
  for (const std::string mark : { "..", " to ", "\u2013", "-" })
    for (std::size_t at = value.find(mark, 1); at != std::string::npos; at = value.find(mark, at + 1))
    {
      const std::vector<std::string> ends = { boost::trim_copy(value.substr(0, at)),
                                              boost::trim_copy(value.substr(at + mark.size())) };
      const std::vector<std::string> numbers = with_shared_unit(ends);
      if (parse_quantity(numbers[0], unit) && parse_quantity(numbers[1], unit))
        return ends[0] + ':' + ends[1] + ":5";
    }
  return "";
}

std::pair<std::string, std::string> split_assignment(const std::string &option, const std::string &text)
{
  const auto equal_sign = text.find('=');
  if (equal_sign == std::string::npos || text.find('/') > equal_sign)
    throw BadInput(option + " \"" + shortened(text) +
                   "\" is not of the form \"Section/Entry=...\"; `stemware sweep --help` shows examples.");
  return { boost::trim_copy(text.substr(0, equal_sign)), boost::trim_copy(text.substr(equal_sign + 1)) };
}

VariedEntry parse_varied_entry(const std::string &text)
{
  const auto [path, values] = split_assignment("--vary", text);
  if (values.empty())
    refuse_range(text, "names no values");
  const std::string unit = unit_of(path);
  if (values.find(':') != std::string::npos)
  {
    const std::vector<std::string> parts = pieces(values, ':');
    return { path, range_values(text, parts, unit), parts.size() == 4 };
  }
  std::vector<std::string> list = pieces(values, ',');
  if (unit.empty())
    return { path, list };
  list = with_shared_unit(list);
  for (std::string &value : list)
    if (const auto number = parse_quantity(value, unit); number && !unit_behind(value).empty())
      value = to_text(*number);
  return { path, list };
}

} // namespace stemware::pipeline
