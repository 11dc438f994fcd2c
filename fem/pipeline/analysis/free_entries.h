#pragma once

#include <optional>
#include <string>

namespace stemware::pipeline
{

/// Value that is known beforehand, with its standard deviation, in SI units.
struct Prior
{
  double value = 0, spread = 0;
};

/// Parses "0.3 ± 0.02" or "300 +- 2 g"; std::nullopt for another text. @p unit: SI unit.
std::optional<Prior> parse_prior(const std::string &text, const std::string &unit);

/// Entry that is fitted, the same in all runs.
struct FreeEntry
{
  std::string path;
  std::optional<Prior> prior = {};
};

/// Parses "Motion/Friction coefficient" or "Motion/Friction coefficient = 0.3 ± 0.02". Throws BadInput, also
/// for an entry that takes no real numbers.
FreeEntry parse_free_entry(const std::string &text);

/// Parses --gyroscope-zero: "0 ± 0.02 rad/s", or a value alone, which is then fixed. Throws BadInput.
Prior parse_gyroscope_zero(const std::string &text);

/// Parses --start: "1.2 ± 0.05 s", or a value alone, which is then fixed. Throws BadInput.
Prior parse_start(const std::string &text);

} // namespace stemware::pipeline
