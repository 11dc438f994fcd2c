#include "fem/pipeline/study/quantity_text.h"

#include "fem/pipeline/support/failures.h"
#include "fem/pipeline/support/numbers.h"
#include "fem/pipeline/support/text.h"

#include <boost/algorithm/string/replace.hpp>
#include <boost/algorithm/string/trim.hpp>
#include <boost/lexical_cast/try_lexical_convert.hpp>

#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <sstream>

namespace stemware::pipeline
{

namespace
{

/// Exponents of kg, m, s, rad and byte.
using Dimension = std::array<int, 5>;

/// A unit in terms of those of SI: 10^decimal times factor.
struct Unit
{
  Dimension dimension = {};
  int decimal = 0;
  double factor = 1;

  void multiply(const Unit &other, int exponent)
  {
    for (std::size_t d = 0; d < dimension.size(); ++d)
      dimension[d] += exponent * other.dimension[d];
    decimal += exponent * other.decimal;
    factor *= std::pow(other.factor, exponent);
  }
};

using Units = std::map<std::string, Unit>;
namespace dimension
{
constexpr Dimension mass = { 1 }, length = { 0, 1 }, time = { 0, 0, 1 }, angle = { 0, 0, 0, 1 },
                    memory = { 0, 0, 0, 0, 1 }, force = { 1, 1, -2 }, pressure = { 1, -1, -2 };
}

/// Units that take prefixes, and units that do not.
const Units metric_units = { { "g", { dimension::mass, -3 } },  { "m", { dimension::length } },
                             { "s", { dimension::time } },      { "N", { dimension::force } },
                             { "Pa", { dimension::pressure } }, { "rad", { dimension::angle } },
                             { "B", { dimension::memory } } };
const Units other_units = {
  { "byte", { dimension::memory } },
  { "bytes", { dimension::memory } },
  { "deg", { dimension::angle, 0, M_PI / 180 } },
  { "degrees", { dimension::angle, 0, M_PI / 180 } },
  { "°", { dimension::angle, 0, M_PI / 180 } },
  { "min", { dimension::time, 0, 60 } },
  { "h", { dimension::time, 2, 36 } },
  { "inch", { dimension::length, -4, 254 } },
  { "in", { dimension::length, -4, 254 } },
  { "ft", { dimension::length, -4, 3048 } },
  { "oz", { dimension::mass, -12, 28349523125. } },
  { "lb", { dimension::mass, -8, 45359237 } },
  { "bar", { dimension::pressure, 5 } },
  { "%", { {}, -2 } },
  { "1", {} },
};
const std::map<std::string, int> prefixes = {
  { "", 0 },   { "n", -9 }, { "u", -6 }, { "µ", -6 }, { "μ", -6 },
  { "m", -3 }, { "c", -2 }, { "k", 3 },  { "M", 6 },  { "G", 9 }
};

/// "mm", "kg", "GPa", without an exponent.
std::optional<Unit> parse_name(const std::string &name)
{
  if (const auto other = other_units.find(name); other != other_units.end())
    return other->second;
  for (const auto &[prefix, decimal] : prefixes)
    if (name.rfind(prefix, 0) == 0)
      if (const auto metric = metric_units.find(name.substr(prefix.size())); metric != metric_units.end())
        return Unit{ metric->second.dimension, metric->second.decimal + decimal };
  return std::nullopt;
}

/// Products by blanks, * or ·, all behind a / dividing, powers as m^2, m2 or s^-1: "N m", "g cm^2", "MPa/mm".
std::optional<Unit> parse_unit(std::string text)
{
  for (const auto &[mark, plain] : { std::pair("²", "^2"), std::pair("³", "^3"), std::pair("·", " "),
                                     std::pair("*", " "), std::pair("/", " / ") })
    boost::replace_all(text, mark, plain);
  std::istringstream words(text);
  Unit product;
  int sign = 1;
  bool is_whole = false; // begins and ends with a name
  for (std::string word; words >> word;)
  {
    if (word == "/" && !is_whole)
      return std::nullopt;
    is_whole = word != "/";
    if (!is_whole)
    {
      sign = -1;
      continue;
    }
    const auto end = word == "1" ? 1 : word.find_last_not_of("-0123456789") + 1;
    const bool has_mark = 0 < end && end < word.size() && word[end - 1] == '^';
    const auto unit = parse_name(word.substr(0, has_mark ? end - 1 : end));
    int exponent = 1;
    if (!unit || (end < word.size() && !boost::conversion::try_lexical_convert(word.substr(end), exponent)) ||
        std::abs(exponent) > 9)
      return std::nullopt;
    product.multiply(*unit, sign * exponent);
  }
  return is_whole ? std::optional(product) : std::nullopt;
}

/// A number and what stands behind it.
struct Parts
{
  std::string number;
  std::string unit;
};

Parts split_number(const std::string &whole)
{
  std::string text = boost::trim_copy(whole);
  boost::replace_first(text, "\u2212", "-"); // a minus copied from a report
  if (text.size() > 1 && text[0] == '+' && text[1] != '-')
    text.erase(0, 1);
  const auto [value, n] = leading_number(text);
  if (n == 0 || !std::isfinite(value))
    return {};
  return { text.substr(0, n), boost::trim_copy(text.substr(n)) };
}

/// The decimal number times 10^decimal, rounded once.
std::optional<double> shifted(const std::string &number, int decimal)
{
  const auto mark = number.find_first_of("eE");
  int exponent = 0;
  if (mark != std::string::npos)
  {
    const auto begin = mark + (number[mark + 1] == '+' ? 2 : 1);
    std::from_chars(number.data() + begin, number.data() + number.size(), exponent);
  }
  return parse_number(number.substr(0, mark) + "e" + std::to_string(exponent + decimal));
}

/// Words for quantities of one SI unit, and the units that people use.
struct Kind
{
  std::string unit;
  std::string name;                      ///< "a mass"
  std::string example;                   ///< a value that a study may have
  std::vector<std::string> usual;        ///< units beside that, the commonest first
  std::vector<std::string> further = {}; ///< units that are taken too
};

const std::vector<Kind> kinds = {
  { "kg", "a mass", "300 g", { "g" }, { "mg", "oz", "lb" } },
  { "m", "a length", "30 mm", { "mm", "cm", "um" }, { "nm", "in", "ft" } },
  { "s", "a time", "500 ms", { "ms" }, { "us", "min", "h" } },
  { "m/s", "a speed", "35 cm/s", { "cm/s", "mm/s" }, { "km/h" } },
  { "m/s^2", "an acceleration", "9.81 m/s^2", { "mm/s^2" }, { "cm/s^2" } },
  { "N", "a force", "3 N", { "mN" }, { "kN" } },
  { "Pa", "a modulus or pressure", "70 GPa", { "GPa", "MPa", "kPa" }, { "N/mm^2", "bar" } },
  { "Pa/m", "a pressure per length", "10 GPa/m", { "GPa/m", "MPa/mm", "MPa/m" }, { "N/mm^3" } },
  { "N m", "a moment of force", "1.4 mN m", { "mN m" }, { "N mm" } },
  { "kg m^2", "a moment of inertia", "3000 g cm^2", { "g cm^2" }, { "kg cm^2" } },
  { "rad", "an angle", "5 deg", { "deg" } },
  { "rad/s", "a spin", "-3.6 rad/s", { "deg/s" } },
  { "B", "an amount of memory", "8 GB", { "GB", "MB" }, { "kB" } },
  { "1", "a pure number", "0.3", { "%" } },
};

const Kind *kind_of(const Dimension &dimension)
{
  for (const Kind &kind : kinds)
    if (parse_unit(kind.unit)->dimension == dimension)
      return &kind;
  return nullptr;
}

Unit known_unit(const std::string &unit)
{
  return parse_unit(unit.empty() ? "1" : unit).value();
}

/// " in kg, g, mg, oz or lb"; of a pure number ", also in %".
std::string units_of(const Kind &kind)
{
  std::vector<std::string> units = { kind.unit };
  units.insert(units.end(), kind.usual.begin(), kind.usual.end());
  units.insert(units.end(), kind.further.begin(), kind.further.end());
  if (kind.unit == "1")
    return ", also in %";
  return " in " + listed(units);
}

} // namespace

std::optional<double> parse_quantity(const std::string &text, const std::string &unit)
{
  const Parts parts = split_number(text);
  if (parts.number.empty())
    return std::nullopt;
  if (parts.unit.empty())
    return parse_number(parts.number);
  const auto given = parse_unit(parts.unit);
  const Unit wanted = known_unit(unit);
  if (!given || given->dimension != wanted.dimension)
    return std::nullopt;
  const auto value = shifted(parts.number, given->decimal - wanted.decimal);
  const double factor = given->factor / wanted.factor;
  return value && std::isfinite(*value * factor) ? std::optional(*value * factor) : std::nullopt;
}

std::string unit_behind(const std::string &text)
{
  return split_number(text).unit;
}

std::vector<std::string> with_shared_unit(std::vector<std::string> texts)
{
  const std::string unit = texts.empty() ? "" : unit_behind(texts.back());
  for (std::string &text : texts)
    if (const Parts parts = split_number(text); !parts.number.empty() && parts.unit.empty() && !unit.empty())
      text = parts.number + ' ' + unit;
  return texts;
}

std::string trouble_with_unit(const std::string &text, const std::string &unit)
{
  const Parts parts = split_number(text);
  if (parts.unit.empty())
    return "";
  const Kind *needed = kind_of(known_unit(unit).dimension);
  const std::string name = needed ? needed->name : "a quantity in " + unit;
  const std::string example = needed ? ", such as " + needed->example : "";
  const std::string alone =
    needed && needed->unit == "1" ? "." : "; a number alone is in " + (unit.empty() ? "1" : unit) + '.';
  const auto given = parse_unit(parts.unit);
  if (!given && parts.unit.front() == ',')
    return " has a comma; write decimals with a point, and nothing between thousands.";
  if (!given)
    return " has an unknown unit, \"" + shortened(parts.unit) + "\"; give " + name +
           (needed ? units_of(*needed) : "") + example + alone;
  if (given->dimension == known_unit(unit).dimension)
    return "";
  const Kind *found = kind_of(given->dimension);
  return " is " + (found ? found->name : "a quantity of another kind") + ", but " + name + " is needed" +
         example + alone;
}

std::vector<std::string> usual_units(const std::string &unit)
{
  const Kind *kind = kind_of(known_unit(unit).dimension);
  return kind ? kind->usual : std::vector<std::string>();
}

} // namespace stemware::pipeline
