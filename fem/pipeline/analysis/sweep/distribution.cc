#include "fem/pipeline/analysis/sweep/distribution.h"

#include "fem/pipeline/analysis/sweep/varied_entry.h"
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
  throw BadInput("--random \"" + text + "\" " + trouble +
                 "; write \"Section/Entry=mean+-deviation\", \"=mean+-10%\", \"=median*/factor\", "
                 "\"=least..most\" or \"=least..most:log\".");
}

/// The two numbers on either side of a mark, the second one perhaps with a tail.
struct Pair
{
  std::optional<double> first, second;
  bool has_tail = false; ///< and it was there
};

std::optional<Pair> parse_pair(const std::string &text, const std::string &mark, const std::string &tail = "")
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
  pair.first = parse_number(text.substr(0, place));
  pair.second = parse_number(second);
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

Spread parse_distribution(const std::string &text, const std::string &distribution)
{
  for (const char *mark : { "+-", "±" })
    if (const auto pair = parse_pair(distribution, mark, "%"))
      return normal_spread(text, *pair);
  if (const auto pair = parse_pair(distribution, "*/"))
    return lognormal_spread(text, *pair);
  if (const auto pair = parse_pair(distribution, "..", ":log"))
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
  Spread spread = parse_distribution(text, distribution);
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
