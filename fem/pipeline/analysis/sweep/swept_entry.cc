#include "fem/pipeline/analysis/sweep/swept_entry.h"

#include "fem/pipeline/study/quantity_text.h"
#include "fem/pipeline/study/study_file.h"
#include "fem/pipeline/support/failures.h"
#include "fem/pipeline/support/numbers.h"

#include <boost/algorithm/string/predicate.hpp>
#include <boost/algorithm/string/split.hpp>
#include <boost/algorithm/string/trim.hpp>
#include <boost/math/distributions/normal.hpp>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <random>

namespace stemware::pipeline
{

namespace
{

constexpr unsigned int most_values = 100000;

constexpr char forms_of_range[] =
  "\"Section/Entry=first:last:number\", the same with :log at its end for equal factors, or a list "
  "\"Section/Entry=a,b,c\"";
constexpr char forms_of_spread[] =
  "\"Section/Entry=mean+-deviation\", \"=mean+-10%\", \"=median*/factor\", \"=least..most\" or "
  "\"=least..most:log\"";

/// An option as it was given, of which a part cannot be understood.
struct GivenOption
{
  std::string option; ///< "--vary"
  std::string text;
  std::string forms; ///< that it may have

  std::string quoted() const { return option + " \"" + shortened(text) + "\""; }
  void require(bool is_good, const std::string &trouble) const
  {
    pipeline::require(is_good, quoted() + " " + trouble + "; write " + forms + ".");
  }
};

/// "Section/Entry=rest" in its two parts, without blanks around them.
std::pair<std::string, std::string> split_assignment(const GivenOption &given)
{
  const std::string &text = given.text;
  const auto equal_sign = text.find('=');
  require(equal_sign != std::string::npos && text.find('/') <= equal_sign,
          given.quoted() +
            " is not of the form \"Section/Entry=...\"; `stemware sweep --help` shows examples.");
  return { boost::trim_copy(text.substr(0, equal_sign)), boost::trim_copy(text.substr(equal_sign + 1)) };
}

/// The number of a text in @p unit. Throws BadInput, with @p where in front, for a unit of another dimension.
std::optional<double> number_of(const std::string &text, const std::string &unit, const std::string &where)
{
  const std::string trouble = trouble_with_unit(text, unit);
  require(trouble.empty(), where + shortened(text) + trouble);
  return parse_quantity(text, unit);
}

/// Whether a unit is behind the first of two numbers only: one behind the second holds for both.
bool have_half_a_unit(const std::vector<std::string> &texts)
{
  return unit_behind(texts[1]).empty() && !unit_behind(texts[0]).empty();
}

std::vector<std::string> pieces(const std::string &text, char separator)
{
  std::vector<std::string> parts;
  boost::split(parts, text, [separator](char letter) { return letter == separator; });
  for (std::string &part : parts)
    boost::trim(part);
  return parts;
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
std::vector<std::string> range_values(const GivenOption &given, const std::vector<std::string> &parts,
                                      const std::string &unit)
{
  const bool is_log = parts.size() == 4 && parts.back() == "log";
  given.require(parts.size() != 2,
                "is not a range (did you mean \"" + shortened(given.text) + ":5\", five values?)");
  given.require(parts.size() == 3 || is_log, "is not a range");
  const std::vector<std::string> ends = with_shared_unit({ parts[0], parts[1] });
  const auto first = number_of(ends[0], unit, given.quoted() + ": "),
             last = number_of(ends[1], unit, given.quoted() + ": ");
  given.require(!have_half_a_unit(ends), "has a unit behind its first number only");
  const auto number = parse_count(parts[2]);
  given.require(first && last, "does not range from one number to another");
  given.require(number && *number >= 2 && *number <= most_values,
                "does not ask for a whole number of values from 2 to " + std::to_string(most_values));
  given.require(!is_log || (*first > 0 && *last > 0),
                "goes by factors, but not between two numbers greater than 0");
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

/// Names of a kind of spread and of its two numbers.
struct SpreadWords
{
  const char *description;
  const char *key, *first, *second; ///< in sweep.json
};

const SpreadWords &words_of(Spread::Kind kind)
{
  static constexpr SpreadWords words[] = {
    { "normal, mean {}, standard deviation {}", "normal", "mean", "standard_deviation" },
    { "lognormal, median {}, factor {}", "lognormal", "median", "factor" },
    { "uniform, {} to {}", "uniform", "least", "most" },
    { "uniform in the logarithm, {} to {}", "log-uniform", "least", "most" }
  };
  return words[static_cast<std::size_t>(kind)];
}

/// The spread of @p first and @p second, the texts on either side of the mark of @p kind. @p has_tail: "%"
/// was behind a deviation, ":log" behind a range.
Spread spread_of(const GivenOption &given, Spread::Kind kind, const std::string &first,
                 const std::string &second, bool has_tail, const std::string &unit)
{
  const bool is_normal = kind == Spread::Kind::normal;
  const bool second_is_pure = kind == Spread::Kind::lognormal || (is_normal && has_tail);
  const std::vector<std::string> texts = { first, second }, shared = with_shared_unit(texts);
  const auto a = number_of(second_is_pure ? first : shared[0], unit, given.option + ": "),
             b = number_of(second, second_is_pure ? "1" : unit, given.option + ": ");
  require(second_is_pure || !have_half_a_unit(texts),
          given.option + ": \"" + shortened(given.text) +
            "\" has a unit behind its first number only; put it behind the second one.");
  if (is_normal)
  {
    given.require(a && b, "is not a mean and a standard deviation");
    const double deviation = has_tail ? std::abs(*a) * *b / 100 : *b;
    given.require(deviation > 0, "has a standard deviation that is not greater than 0");
    return { "", kind, *a, deviation };
  }
  if (kind == Spread::Kind::lognormal)
    given.require(a && b && *a > 0 && *b > 1, "is not a median greater than 0 with a factor greater than 1");
  else
    given.require(a && b && *a < *b, "is not a range from a smaller to a larger number");
  given.require(!has_tail || *a > 0, "goes by factors, but not between two numbers greater than 0");
  return { "", has_tail ? Spread::Kind::log_uniform : kind, *a, *b };
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

SweptEntry parse_varied_entry(const std::string &text)
{
  const GivenOption given = { "--vary", text, forms_of_range };
  const auto [path, values] = split_assignment(given);
  given.require(!values.empty(), "names no values");
  const std::string unit = unit_of(path);
  if (values.find(':') != std::string::npos)
  {
    const std::vector<std::string> parts = pieces(values, ':');
    return { path, unit, range_values(given, parts, unit), parts.size() == 4 };
  }
  std::vector<std::string> list = pieces(values, ',');
  if (!unit.empty())
    list = with_shared_unit(list);
  for (std::string &value : list)
    if (const auto number = parse_quantity(value, unit);
        number && !unit.empty() && !unit_behind(value).empty())
      value = to_text(*number);
  return { path, unit, list };
}

double Spread::quantile(double probability) const
{
  const bool is_even = kind == Kind::uniform || kind == Kind::log_uniform;
  const double score = is_even ? probability : boost::math::quantile(boost::math::normal(), probability);
  if (is_by_factors())
    return first * std::pow(is_even ? second / first : second, score);
  return first + (is_even ? second - first : second) * score;
}

std::string Spread::description() const
{
  return fmt::format(fmt::runtime(words_of(kind).description), to_text(first), to_text(second));
}

nlohmann::ordered_json Spread::as_json() const
{
  const SpreadWords &words = words_of(kind);
  return { { "distribution", words.key }, { words.first, first }, { words.second, second } };
}

Spread parse_spread(const std::string &text)
{
  const GivenOption given = { "--random", text, forms_of_spread };
  const auto [path, distribution] = split_assignment(given);
  /// A way to write a spread: what stands between its numbers, and what may stand behind them.
  struct Form
  {
    std::string mark, tail;
    Spread::Kind kind;
  };
  const Form forms[] = { { "+-", "%", Spread::Kind::normal },
                         { "±", "%", Spread::Kind::normal },
                         { "*/", "", Spread::Kind::lognormal },
                         { "..", ":log", Spread::Kind::uniform } };
  for (const auto &[mark, tail, kind] : forms)
  {
    const auto place = distribution.find(mark);
    if (place == std::string::npos)
      continue;
    std::string second = distribution.substr(place + mark.size());
    const bool has_tail = !tail.empty() && boost::ends_with(second, tail);
    if (has_tail)
      second.erase(second.size() - tail.size());
    Spread spread = spread_of(given, kind, distribution.substr(0, place), second, has_tail, unit_of(path));
    spread.path = path;
    return spread;
  }
  given.require(false, "names no spread");
  return {};
}

std::vector<std::vector<double>> draw_samples(const std::vector<Spread> &spreads, unsigned int n_samples,
                                              std::uint64_t seed)
{
  std::mt19937_64 engine(seed);
  std::vector<std::vector<double>> samples(n_samples);
  for (std::vector<double> &sample : samples)
    for (const Spread &spread : spreads)
    {
      // The middle of one of 2^53 equal parts of (0, 1): never an end of it.
      const double probability = (static_cast<double>(engine() >> 11) + 0.5) * std::ldexp(1., -53);
      // The last bits of pow() and of the normal quantile are the machine's; those of the table shall not be.
      sample.push_back(rounded(spread.quantile(probability), 12));
    }
  return samples;
}

} // namespace stemware::pipeline
