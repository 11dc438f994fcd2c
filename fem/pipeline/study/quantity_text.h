#pragma once

#include "fem/geometry/waviness.h"

#include <optional>
#include <string>
#include <vector>

namespace stemware::pipeline
{

/// Parses a quantity: a number in the SI unit @p unit ("kg", "Pa/m", "N m"; "1" for pure numbers),
/// or a number with any unit of the same dimension ("300 g", "70 GPa", "20 cm/s", "5 deg", "30 %" of a pure
/// number), with any Unicode blank or minus sign. Powers of ten shift the decimal exponent, so that 0.3 mm is
/// the double nearest to 3e-4. Returns the finite value in @p unit, or std::nullopt.
std::optional<double> parse_quantity(const std::string &text, const std::string &unit);

/// Returns the text after the leading number of @p text, "GPa" of "70 GPa"; empty without a number.
std::string trailing_unit(const std::string &text);

/// Appends the unit of the last of @p texts to the others, if they have none: "200, 250, 300 g".
std::vector<std::string> with_shared_unit(std::vector<std::string> texts);

/// Returns the rest of an error message that begins with "Motion/Mass = 30 mm", if the unit in @p text is
/// unknown or has another dimension than @p unit: error, remedy, available units. Empty otherwise.
std::string unit_error(const std::string &text, const std::string &unit);

/// Returns common units of a quantity with the SI unit @p unit, the usual one first: "g", "mg" for "kg".
std::vector<std::string> usual_units(const std::string &unit);

/// Waviness of rim or table: harmonics n >= 2 (n = 0 and 1, offset and tilt, are motions of the table).
using Waviness = std::vector<fem::WavinessHarmonic>;

/// Parses "2: 5e-6 @ 0.3, 3: 2e-6": harmonic, amplitude [m], azimuth [rad] (default 0). Returns std::nullopt
/// for other texts and harmonics below 2. Empty text: a perfect surface.
std::optional<Waviness> parse_waviness(const std::string &text);

/// Returns the text for parse_waviness(), in full precision.
std::string waviness_text(const Waviness &waviness);

/// Description of the texts that parse_waviness() accepts, as part of a sentence.
extern const char *const waviness_words;

} // namespace stemware::pipeline
