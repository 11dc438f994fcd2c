#include "fem/pipeline/study/quantity_text.h"

#include "fem/pipeline/base/failures.h"
#include "fem/pipeline/base/numbers.h"
#include "fem/pipeline/base/text.h"
#include "ring_model/load/constants.h"

#include <boost/algorithm/string/classification.hpp>
#include <boost/algorithm/string/replace.hpp>
#include <boost/algorithm/string/split.hpp>
#include <boost/algorithm/string/trim.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <map>
#include <sstream>
#include <utility>

namespace stemware::pipeline
{

namespace
{

/// Exponents of kg, m, s, rad and byte.
using Dimension = std::array<int, 5>;
constexpr Dimension mass = { 1 }, length = { 0, 1 }, duration = { 0, 0, 1 }, angle = { 0, 0, 0, 1 },
                    memory = { 0, 0, 0, 0, 1 }, force = { 1, 1, -2 }, pressure = { 1, -1, -2 };

/// Unit = 10^decimal * factor SI units.
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

/// Units that take prefixes.
const std::map<std::string, Unit> metric_units = { { "g", { mass, -3 } },  { "m", { length } },
                                                   { "s", { duration } },  { "N", { force } },
                                                   { "Pa", { pressure } }, { "rad", { angle } },
                                                   { "B", { memory } } };

const std::map<std::string, Unit> other_units = { { "1", {} },
                                                  { "%", { {}, -2 } },
                                                  { "byte", { memory } },
                                                  { "bytes", { memory } },
                                                  { "deg", { angle, 0, ring::pi / 180 } },
                                                  { "degrees", { angle, 0, ring::pi / 180 } },
                                                  { "°", { angle, 0, ring::pi / 180 } },
                                                  { "min", { duration, 0, 60 } },
                                                  { "h", { duration, 2, 36 } },
                                                  { "inch", { length, -4, 254 } },
                                                  { "in", { length, -4, 254 } },
                                                  { "ft", { length, -4, 3048 } },
                                                  { "oz", { mass, -12, 28349523125. } },
                                                  { "lb", { mass, -8, 45359237 } },
                                                  { "bar", { pressure, 5 } },
                                                  { "rev", { angle, 0, 2 * ring::pi } },
                                                  { "rpm", { { 0, 0, -1, 1 }, 0, ring::pi / 30 } } };
const std::map<std::string, int> prefixes = {
  { "", 0 },   { "n", -9 }, { "u", -6 }, { "µ", -6 }, { "μ", -6 },
  { "m", -3 }, { "c", -2 }, { "k", 3 },  { "M", 6 },  { "G", 9 }
};

/// Parses a unit without exponent, e.g. "mm", "kg", "GPa".
std::optional<Unit> parse_name(const std::string &name)
{
  if (const auto found = other_units.find(name); found != other_units.end())
    return found->second;
  for (const auto &[prefix, decimal] : prefixes)
    if (name.rfind(prefix, 0) == 0)
      if (const auto metric = metric_units.find(name.substr(prefix.size())); metric != metric_units.end())
        return Unit{ metric->second.dimension, metric->second.decimal + decimal };
  return std::nullopt;
}

/// Parses a unit with products (blank, * or ·), divisions (everything after a / is in the denominator) and
/// powers (m^2, m2, s^-1): "N m", "g cm^2", "MPa/mm".
std::optional<Unit> parse_unit(std::string text)
{
  for (const auto &[mark, plain] : { std::pair("²", "^2"), std::pair("³", "^3"), std::pair("·", " "),
                                     std::pair("*", " "), std::pair("/", " / ") })
    boost::replace_all(text, mark, plain);
  std::istringstream words(text);
  Unit product;
  int sign = 1;
  bool is_whole = false; // true if the last word is a name, after which the unit may end
  for (std::string word; words >> word;)
  {
    if (word == "/")
    {
      if (!is_whole)
        return std::nullopt;
      is_whole = false;
      sign = -1;
      continue;
    }
    is_whole = true;
    const auto end = word == "1" ? 1 : word.find_last_not_of("-0123456789") + 1;
    const bool has_mark = 0 < end && end < word.size() && word[end - 1] == '^';
    const auto unit = parse_name(word.substr(0, has_mark ? end - 1 : end));
    const auto exponent = end < word.size() ? parse_number(word.substr(end)) : 1;
    if (!unit || !exponent || std::abs(*exponent) > 9)
      return std::nullopt;
    product.multiply(*unit, sign * static_cast<int>(*exponent));
  }
  return is_whole ? std::optional(product) : std::nullopt;
}

/// Returns the leading number of a text and the unit behind it; empty texts without a finite number.
std::pair<std::string, std::string> split_number(const std::string &whole)
{
  std::string text = boost::trim_copy(as_typed(whole));
  if (text.size() > 1 && text[0] == '+' && text[1] != '-')
    text.erase(0, 1);
  const auto [value, n] = leading_number(text);
  if (n == 0 || !std::isfinite(value))
    return {};
  return { text.substr(0, n), boost::trim_copy(text.substr(n)) };
}

/// Returns @p number times 10^@p decimal with a single rounding.
std::optional<double> shifted(const std::string &number, int decimal)
{
  const auto mark = std::min(number.find_first_of("eE"), number.size());
  const long exponent = mark < number.size() ? std::strtol(number.c_str() + mark + 1, nullptr, 10) : 0;
  return parse_number(number.substr(0, mark) + "e" +
                      std::to_string(std::clamp(exponent, -9999L, 9999L) + decimal));
}

/// Kind of quantity: all quantities with the same SI unit.
struct Kind
{
  std::string unit;
  std::string name;                      ///< e.g. "a mass"
  std::string example;                   ///< plausible value
  std::vector<std::string> usual;        ///< usual units other than the SI unit, most common first
  std::vector<std::string> further = {}; ///< further accepted units
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
  { "rad/s", "a spin", "-3.6 rad/s", { "deg/s" }, { "rpm", "rev/s" } },
  { "B", "an amount of memory", "8 GB", { "GB", "MB" }, { "kB" } },
  { "1", "a pure number", "0.3", { "%" } },
};

const Kind *kind_of(const Unit &unit)
{
  for (const Kind &kind : kinds)
    if (parse_unit(kind.unit)->dimension == unit.dimension)
      return &kind;
  return nullptr;
}

std::string units_of(const Kind &kind)
{
  if (kind.unit == "1")
    return ", also in %";
  std::vector<std::string> units = kind.usual;
  units.insert(units.begin(), kind.unit);
  units.insert(units.end(), kind.further.begin(), kind.further.end());
  return " in " + listed(units);
}

/// Parses a harmonic such as "2: 5 um @ 20 deg"; the azimuth is optional.
std::optional<fem::WavinessHarmonic> parse_harmonic(const std::string &text)
{
  const auto colon = text.find(':'), at = std::min(text.find('@'), text.size());
  if (colon > at)
    return std::nullopt;
  const auto order = parse_count(text.substr(0, colon));
  const auto amplitude = parse_quantity(text.substr(colon + 1, at - colon - 1), "m");
  const auto azimuth = at < text.size() ? parse_quantity(text.substr(at + 1), "rad") : 0.;
  constexpr double end_of_amplitudes = 1, end_of_azimuths = 1000;
  if (!order || *order < 2 || !amplitude || !azimuth || !(std::abs(*amplitude) < end_of_amplitudes) ||
      !(std::abs(*azimuth) < end_of_azimuths))
    return std::nullopt;
  return fem::WavinessHarmonic{ *order, *amplitude, *azimuth };
}

} // namespace

std::optional<double> parse_quantity(const std::string &text, const std::string &unit)
{
  const auto [number, unit_text] = split_number(text);
  if (number.empty() || unit_text.empty())
    return parse_number(number);
  const auto given = parse_unit(unit_text);
  const Unit wanted = parse_unit(unit).value();
  if (!given || given->dimension != wanted.dimension)
    return std::nullopt;
  const auto value = shifted(number, given->decimal - wanted.decimal);
  const double factor = given->factor / wanted.factor;
  return value && std::isfinite(*value * factor) ? std::optional(*value * factor) : std::nullopt;
}

std::string trailing_unit(const std::string &text)
{
  return split_number(text).second;
}

std::vector<std::string> with_shared_unit(std::vector<std::string> texts)
{
  const std::string unit = texts.empty() ? "" : trailing_unit(texts.back());
  for (std::string &text : texts)
    if (const auto [number, own] = split_number(text); !number.empty() && own.empty() && !unit.empty())
      text = number + ' ' + unit;
  return texts;
}

std::string unit_error(const std::string &text, const std::string &unit)
{
  const std::string unit_text = trailing_unit(text);
  if (unit_text.empty())
    return "";
  const Kind *needed = kind_of(parse_unit(unit).value());
  const std::string name = needed ? needed->name : "a quantity in " + unit;
  const std::string example = needed ? ", such as " + needed->example : "";
  const std::string alone = needed && needed->unit == "1" ? "." : "; a number alone is in " + unit + '.';
  const auto given = parse_unit(unit_text);
  if (!given && unit_text.front() == ',')
    return " has a comma; write decimals with a point, and nothing between thousands.";
  if (!given && std::isdigit(static_cast<unsigned char>(unit_text.front())))
    return " has blanks between its digits; write the number without them.";
  if (!given)
    return " has an unknown unit, \"" + shortened(unit_text) + "\"; give " + name +
           (needed ? units_of(*needed) : "") + example + alone;
  if (given->dimension == parse_unit(unit).value().dimension)
    return "";
  const Kind *found = kind_of(*given);
  return " is " + (found ? found->name : "a quantity of another kind") + ", but " + name + " is needed" +
         example + alone;
}

std::vector<std::string> usual_units(const std::string &unit)
{
  const Kind *kind = kind_of(parse_unit(unit).value());
  return kind ? kind->usual : std::vector<std::string>();
}

const char *const waviness_words =
  "harmonics \"n: amplitude @ azimuth\" (m, rad) separated by commas, such as 2: 5 um @ 20 deg, 3: 2e-6, "
  "with n from 2 on (n = 0 is an offset and n = 1 a tilt, which the table's motions absorb) and amplitudes "
  "below 1 m, or nothing";

std::optional<Waviness> parse_waviness(const std::string &text)
{
  Waviness waviness;
  std::vector<std::string> parts;
  if (!boost::trim_copy(text).empty())
    boost::split(parts, text, boost::is_any_of(","));
  for (const std::string &part : parts)
    if (const auto harmonic = parse_harmonic(part))
      waviness.push_back(*harmonic);
    else
      return std::nullopt;
  return waviness;
}

std::string waviness_text(const Waviness &waviness)
{
  std::string text;
  for (const fem::WavinessHarmonic &harmonic : waviness)
    text += (text.empty() ? "" : ", ") + std::to_string(harmonic.n) + ": " + to_text(harmonic.amplitude) +
            (harmonic.azimuth == 0 ? "" : " @ " + to_text(harmonic.azimuth));
  return text;
}

} // namespace stemware::pipeline
