#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace stemware::pipeline
{

/// An entry of the study that is known up to a spread.
struct Spread
{
  enum class Kind
  {
    normal,     ///< first +- second: mean and standard deviation
    lognormal,  ///< first */ second: median, and the factor to the 84 % point
    uniform,    ///< first .. second
    log_uniform ///< first .. second, every factor being equally likely
  };

  std::string path; ///< Section/Entry
  Kind kind = Kind::normal;
  double first = 0;
  double second = 0;

  /// The value that is not exceeded with @p probability, in (0, 1).
  double quantile(double probability) const;

  /// Whether it goes by factors, so that the logarithm of the value is what spreads evenly.
  bool is_by_factors() const { return kind == Kind::lognormal || kind == Kind::log_uniform; }

  /// "normal, mean 0.3, standard deviation 0.03".
  std::string description() const;
};

/// Reads what --random was given:
///
///   Motion/Friction coefficient=0.3+-0.03       normal: mean and standard deviation
///   Motion/Mass=300 g+-10%                      the same, as a share of the mean
///   Table/Foundation modulus=1e10*/2            lognormal: median and factor of one standard deviation
///   Glass/Crown radius=0.002..0.004             uniform
///   Table/Foundation modulus=1e9..1e11:log      uniform in the logarithm
///
/// Numbers may have units; one behind the second number only holds for both. Throws BadInput with one
/// sentence for anything else; whether the entry exists is not looked at.
Spread parse_spread(const std::string &text);

/// Independent draws from all @p spreads, shape [n_samples][spreads], the same on every machine: 64-bit
/// Mersenne twister, inverse distribution functions, values rounded to 12 digits. The first samples of a
/// longer series are those of a shorter one.
std::vector<std::vector<double>> draw_samples(const std::vector<Spread> &spreads, unsigned int n_samples,
                                              std::uint64_t seed);

} // namespace stemware::pipeline
