#pragma once

#include "fem/geometry/waviness.h"

#include <optional>
#include <string>
#include <vector>

namespace stemware::pipeline
{

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
