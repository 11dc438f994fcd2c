#include "fem/pipeline/analysis/sweep/distribution.h"

#include "fem/pipeline/analysis/sweep/varied_entry.h"
#include "fem/pipeline/study/quantity_text.h"
#include "fem/pipeline/study/study_file.h"
#include "fem/pipeline/support/failures.h"
#include "fem/pipeline/support/numbers.h"

#include <boost/math/distributions/normal.hpp>

#include <cmath>
#include <optional>
#include <random>
#include <stdexcept>

namespace stemware::pipeline
{

namespace
{

[[noreturn]] void refuse_distribution(const std::string &text, const std::string &trouble)
{
  throw BadInput("--random \"" + shortened(text) + "\" " + trouble +
                 "; write \"Section/Entry=mean+-deviation\", \"=mean+-10%\", \"=median*/factor\", "
                 "\"=least..most\" or \"=least..most:log\".");
}

/// The two numbers on either side of a mark, the second one perhaps with a tail.
struct Pair
{
  std::optional<double> first, second;
  bool has_tail = false; ///< and it was there
};

/// Numbers in @p unit; the unit of the second one holds for the first too, unless @p second_is_pure or it has
/// its own. Throws BadInput for units of another dimension.
std::optional<Pair> parse_pair(const std::string &text, const std::string &unit, const std::string &mark,
                               const std::string &tail = "", bool second_is_pure = false)
{
  const auto place = text.find(mark);
  if (place == std::string::npos)
    return std::nullopt;
  Pair pair;
  std::string second = text.substr(place + mark.size());
  pair.has_tail = !tail.empty() && second.size() > tail.size() &&
                  second.compare(second.size() - tail.size(), tail.size(), tail) == 0;
  if (pair.has_tail)
    second.erase(second.size() - tail.size());
  const bool is_share = pair.has_tail && tail == "%";
  std::vector<std::string> numbers = { text.substr(0, place), second };
  if (!second_is_pure && !is_share)
    numbers = with_shared_unit(numbers);
  const std::string second_unit = second_is_pure || is_share ? "1" : unit;
  for (const auto &[number, unit_of_it] : { std::pair(numbers[0], unit), std::pair(numbers[1], second_unit) })
    if (const std::string trouble = trouble_with_unit(number, unit_of_it); !trouble.empty())
      throw BadInput("--random: " + shortened(number) + trouble);
  const bool has_half_a_unit = unit_behind(numbers[1]).empty() && !unit_behind(numbers[0]).empty();
  if (has_half_a_unit && !second_is_pure && !is_share)
    throw BadInput("--random: \"" + shortened(text) +
                   "\" has a unit behind its first number only; put it behind the second one.");
  pair.first = parse_quantity(numbers[0], unit);
  pair.second = parse_quantity(numbers[1], second_unit);
  return pair;
}

Spread normal_spread(const std::string &text, const Pair &pair)
{
  if (!pair.first || !pair.second)
    refuse_distribution(text, "is not a mean and a standard deviation");
  const double deviation = pair.has_tail ? std::abs(*pair.first) * *pair.second / 100 : *pair.second;
  if (!(deviation > 0))
    refuse_distribution(text, "has a standard deviation that is not greater than 0");
  return { "", Spread::Kind::normal, *pair.first, deviation };
}

Spread lognormal_spread(const std::string &text, const Pair &pair)
{
  if (!pair.first || !pair.second || !(*pair.first > 0) || !(*pair.second > 1))
    refuse_distribution(text, "is not a median greater than 0 with a factor greater than 1");
  return { "", Spread::Kind::lognormal, *pair.first, *pair.second };
}

Spread uniform_spread(const std::string &text, const Pair &pair)
{
  if (!pair.first || !pair.second || !(*pair.first < *pair.second))
    refuse_distribution(text, "is not a range from a smaller to a larger number");
  if (pair.has_tail && !(*pair.first > 0))
    refuse_distribution(text, "goes by factors, but not between two numbers greater than 0");
  return { "", pair.has_tail ? Spread::Kind::log_uniform : Spread::Kind::uniform, *pair.first, *pair.second };
}

Spread parse_distribution(const std::string &text, const std::string &distribution, const std::string &unit)
{
  for (const char *mark : { "+-", "±" })
    if (const auto pair = parse_pair(distribution, unit, mark, "%"))
      return normal_spread(text, *pair);
  if (const auto pair = parse_pair(distribution, unit, "*/", "", true))
    return lognormal_spread(text, *pair);
  if (const auto pair = parse_pair(distribution, unit, "..", ":log"))
    return uniform_spread(text, *pair);
  refuse_distribution(text, "names no spread");
}

} // namespace

double Spread::quantile(double probability) const
{
  const auto standard_score = [&] { return boost::math::quantile(boost::math::normal(), probability); };
  switch (kind)
  {
  case Kind::normal:
    return first + second * standard_score();
  case Kind::lognormal:
    return first * std::pow(second, standard_score());
  case Kind::uniform:
    return first + (second - first) * probability;
  case Kind::log_uniform:
    return first * std::pow(second / first, probability);
  }
  throw std::logic_error("a spread without a distribution");
}

std::string Spread::description() const
{
  const std::string a = to_text(first), b = to_text(second);
  switch (kind)
  {
  case Kind::normal:
    return "normal, mean " + a + ", standard deviation " + b;
  case Kind::lognormal:
    return "lognormal, median " + a + ", factor " + b;
  case Kind::uniform:
    return "uniform, " + a + " to " + b;
  case Kind::log_uniform:
    return "uniform in the logarithm, " + a + " to " + b;
  }
  throw std::logic_error("a spread without a distribution");
}

Spread parse_spread(const std::string &text)
{
  const auto [path, distribution] = split_assignment("--random", text);
  Spread spread = parse_distribution(text, distribution, unit_of(path));
  spread.path = path;
  return spread;
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
