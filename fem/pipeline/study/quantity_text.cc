#include "fem/pipeline/study/quantity_text.h"

#include "fem/pipeline/support/failures.h"
#include "fem/pipeline/support/numbers.h"

#include <boost/algorithm/string/classification.hpp>
#include <boost/algorithm/string/replace.hpp>
#include <boost/algorithm/string/split.hpp>
#include <boost/algorithm/string/trim.hpp>

#include <array>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <map>

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
};

struct NamedUnit
{
  Unit unit;
  bool takes_prefixes = true;
};

const std::map<std::string, NamedUnit> named_units = {
  { "g", { { { 1, 0, 0, 0, 0 }, -3, 1 } } },
  { "m", { { { 0, 1, 0, 0, 0 }, 0, 1 } } },
  { "s", { { { 0, 0, 1, 0, 0 }, 0, 1 } } },
  { "N", { { { 1, 1, -2, 0, 0 }, 0, 1 } } },
  { "Pa", { { { 1, -1, -2, 0, 0 }, 0, 1 } } },
  { "rad", { { { 0, 0, 0, 1, 0 }, 0, 1 } } },
  { "B", { { { 0, 0, 0, 0, 1 }, 0, 1 } } },
  { "byte", { { { 0, 0, 0, 0, 1 }, 0, 1 }, false } },
  { "bytes", { { { 0, 0, 0, 0, 1 }, 0, 1 }, false } },
  { "deg", { { { 0, 0, 0, 1, 0 }, 0, M_PI / 180 }, false } },
  { "degrees", { { { 0, 0, 0, 1, 0 }, 0, M_PI / 180 }, false } },
  { "°", { { { 0, 0, 0, 1, 0 }, 0, M_PI / 180 }, false } },
  { "min", { { { 0, 0, 1, 0, 0 }, 0, 60 }, false } },
  { "h", { { { 0, 0, 1, 0, 0 }, 2, 36 }, false } },
  { "inch", { { { 0, 1, 0, 0, 0 }, -4, 254 }, false } },
  { "in", { { { 0, 1, 0, 0, 0 }, -4, 254 }, false } },
  { "ft", { { { 0, 1, 0, 0, 0 }, -4, 3048 }, false } },
  { "oz", { { { 1, 0, 0, 0, 0 }, -12, 28349523125. }, false } },
  { "lb", { { { 1, 0, 0, 0, 0 }, -8, 45359237 }, false } },
  { "bar", { { { 1, -1, -2, 0, 0 }, 5, 1 }, false } },
  { "%", { { { 0, 0, 0, 0, 0 }, -2, 1 }, false } },
  { "1", { { { 0, 0, 0, 0, 0 }, 0, 1 }, false } },
};

const std::map<std::string, int> prefixes = { { "n", -9 }, { "u", -6 }, { "µ", -6 }, { "μ", -6 }, { "m", -3 },
                                              { "c", -2 }, { "k", 3 },  { "M", 6 },  { "G", 9 } };

/// "mm", "kg", "GPa", without an exponent.
std::optional<Unit> parse_name(const std::string &name)
{
  if (const auto found = named_units.find(name); found != named_units.end())
    return found->second.unit;
  for (const auto &[prefix, decimal] : prefixes)
  {
    const auto found =
      name.rfind(prefix, 0) == 0 ? named_units.find(name.substr(prefix.size())) : named_units.end();
    if (found == named_units.end() || !found->second.takes_prefixes)
      continue;
    Unit unit = found->second.unit;
    unit.decimal += decimal;
    return unit;
  }
  return std::nullopt;
}

/// "m", "m^2", "m2", "s^-1".
std::optional<Unit> parse_power(const std::string &text)
{
  const auto digits = text.find_last_not_of("0123456789");
  if (digits == std::string::npos)
    return parse_name(text);
  auto end = digits + 1;
  if (end < text.size() && text[end - 1] == '-')
    --end;
  int exponent = 1;
  if (end < text.size())
  {
    const auto [last, error] = std::from_chars(text.data() + end, text.data() + text.size(), exponent);
    if (error != std::errc() || last != text.data() + text.size() || std::abs(exponent) > 9)
      return std::nullopt;
  }
  if (end > 0 && end < text.size() && text[end - 1] == '^')
    --end;
  auto unit = parse_name(text.substr(0, end));
  if (!unit)
    return std::nullopt;
  for (int &power : unit->dimension)
    power *= exponent;
  unit->decimal *= exponent;
  unit->factor = std::pow(unit->factor, exponent);
  return unit;
}

/// Products by blanks, * or ·, each part behind a / dividing: "N m", "g cm^2", "MPa/mm".
std::optional<Unit> parse_unit(std::string text)
{
  boost::replace_all(text, "²", "^2");
  boost::replace_all(text, "³", "^3");
  boost::replace_all(text, "·", " ");
  boost::replace_all(text, "*", " ");
  Unit product;
  std::vector<std::string> parts;
  boost::split(parts, text, boost::is_any_of("/"));
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    std::vector<std::string> names;
    boost::trim(parts[i]);
    boost::split(names, parts[i], boost::is_space(), boost::token_compress_on);
    const int sign = i == 0 ? 1 : -1;
    for (const std::string &name : names)
    {
      const auto unit = parse_power(name);
      if (!unit)
        return std::nullopt;
      for (std::size_t d = 0; d < product.dimension.size(); ++d)
        product.dimension[d] += sign * unit->dimension[d];
      product.decimal += sign * unit->decimal;
      product.factor *= std::pow(unit->factor, sign);
    }
  }
  return product;
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
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || !std::isfinite(value))
    return {};
  const auto n = static_cast<std::size_t>(end - text.data());
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
  return parse_number(fmt::format(FMT_STRING("{}e{}"), number.substr(0, mark), exponent + decimal));
}

/// What people know of quantities of one SI unit.
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
  std::string text;
  for (std::size_t i = 0; i < units.size(); ++i)
    text += (i == 0 ? " in " : i + 1 == units.size() ? " or " : ", ") + units[i];
  return text;
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
    return fmt::format(FMT_STRING(" has an unknown unit, \"{}\"; give {}{}{}{}"), shortened(parts.unit), name,
                       needed ? units_of(*needed) : "", example, alone);
  if (given->dimension == known_unit(unit).dimension)
    return "";
  const Kind *found = kind_of(given->dimension);
  return fmt::format(FMT_STRING(" is {}, but {} is needed{}{}"),
                     found ? found->name : "a quantity of another kind", name, example, alone);
}

std::vector<std::string> usual_units(const std::string &unit)
{
  const Kind *kind = kind_of(known_unit(unit).dimension);
  return kind ? kind->usual : std::vector<std::string>();
}

} // namespace stemware::pipeline
