#include "fem/pipeline/analysis/sweep/varied_entry.h"

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
  throw BadInput("--vary \"" + text + "\" " + trouble +
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

/// The values of first:last:number or first:last:number:log.
std::vector<std::string> range_values(const std::string &text, const std::vector<std::string> &parts)
{
  const bool is_log = parts.size() == 4 && parts.back() == "log";
  if (parts.size() != 3 && !is_log)
    refuse_range(text, "is not a range");
  const auto first = parse_number(parts[0]);
  const auto last = parse_number(parts[1]);
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

std::pair<std::string, std::string> split_assignment(const std::string &option, const std::string &text)
{
  const auto equal_sign = text.find('=');
  if (equal_sign == std::string::npos || text.find('/') > equal_sign)
    throw BadInput(option + " \"" + text +
                   "\" is not of the form \"Section/Entry=...\"; `stemware sweep --help` shows examples.");
  return { boost::trim_copy(text.substr(0, equal_sign)), boost::trim_copy(text.substr(equal_sign + 1)) };
}

VariedEntry parse_varied_entry(const std::string &text)
{
  const auto [path, values] = split_assignment("--vary", text);
  if (values.empty())
    refuse_range(text, "names no values");
  if (values.find(':') != std::string::npos)
  {
    const std::vector<std::string> parts = pieces(values, ':');
    return { path, range_values(text, parts), parts.size() == 4 };
  }
  return { path, pieces(values, ',') };
}

} // namespace stemware::pipeline
