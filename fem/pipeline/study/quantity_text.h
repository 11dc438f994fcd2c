#pragma once

#include "fem/geometry/waviness.h"

#include <optional>
#include <string>
#include <vector>

namespace stemware::pipeline
{

/// Reads a quantity as people write it: a number alone, in the SI unit @p unit ("kg", "Pa/m", "N m"; "1" or
/// empty for pure numbers), or a number with any unit of the same dimension ("300 g", "70 GPa", "20 cm/s",
/// "5 deg", "30 %" of a pure number), with any blank and any minus sign of Unicode's. Factors of ten shift
/// the decimal exponent, so that 0.3 mm is the double next to 3e-4. Returns the finite value in @p unit, or
/// nothing.
std::optional<double> parse_quantity(const std::string &text, const std::string &unit);

/// The text behind the number that @p text begins with, "GPa" of "70 GPa"; empty where there is no number, or
/// nothing behind it.
std::string trailing_unit(const std::string &text);

/// Numbers that share one unit: where only the last of @p texts has a unit ("200, 250, 300 g"), it is put
/// behind the others too.
std::vector<std::string> with_shared_unit(std::vector<std::string> texts);

/// The end of a sentence that begins with "Motion/Mass = 30 mm", where @p text is a number whose unit is not
/// known or has not the dimension of @p unit: what is wrong and what to write, with the units that there are.
/// Empty for every other text.
std::string unit_error(const std::string &text, const std::string &unit);

/// The units in which people give a quantity of that SI unit: "g", "mg" for "kg", the usual one first.
std::vector<std::string> usual_units(const std::string &unit);

/// Harmonics of an out-of-flat rim or table as a study states them, from n = 2 on: n = 0 and 1 are an offset
/// and a tilt, which the table motions absorb.
using Waviness = std::vector<fem::WavinessHarmonic>;

/// "2: 5e-6 @ 0.3, 3: 2e-6": harmonic, amplitude, azimuth (0 where it is left out); nothing for a text that
/// is not such a list, or has a harmonic below 2. The empty text is the perfect surface.
std::optional<Waviness> parse_waviness(const std::string &text);

/// The text that parse_waviness() reads, with all digits.
std::string waviness_text(const Waviness &waviness);

/// Words for the texts that parse_waviness() takes, as part of a sentence.
extern const char *const waviness_words;

} // namespace stemware::pipeline
