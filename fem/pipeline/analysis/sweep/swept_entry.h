#pragma once

#include <nlohmann/json.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace stemware::pipeline
{

/// An entry of the study that differs from case to case.
struct SweptEntry
{
  std::string path;                ///< Section/Entry
  std::string unit;                ///< "1" for pure numbers, empty for words
  std::vector<std::string> values; ///< of a grid, as a study file writes them; empty for random samples
  bool by_factors = false;         ///< whether a logarithmic axis suits it: of a range, by equal factors
};

/// Reads what --vary was given:
///
///   Load/Moment ratio=0.1:1.9:50                from 0.1 to 1.9 in equal steps, 50 values
///   Table/Foundation modulus=1e8:1e12:20:log    by equal factors
///   Motion/Mass=200,250,300 g                   these; a unit behind the last one only holds for all
///   Motion/Closure=paper,hand,full              these
///
/// Numbers may have units, also in a range; the values are in SI units.
/// Values of a range are rounded to 15 digits, in equal steps to 15 digits of the larger end, so that a third
/// of the way from 0 to 0.9 is 0.3, and half the way from -0.3 to 0.3 is 0. Throws BadInput with one sentence
/// for anything else; whether the entry exists and takes the values is not looked at.
SweptEntry parse_varied_entry(const std::string &text);

/// The range that somebody may mean by a value in @p unit that is none: "0.1:0.5:5" for "0.1-0.5", "0.1..0.5"
/// and "0.1 to 0.5". Empty for everything else.
std::string range_meant_by(const std::string &value, const std::string &unit);

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

  /// The same for sweep.json: {"distribution": "normal", "mean": 0.3, "standard_deviation": 0.03}.
  nlohmann::ordered_json as_json() const;
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
