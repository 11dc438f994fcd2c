#include "fem/pipeline/study/waviness_text.h"

#include "fem/pipeline/study/quantity_text.h"
#include "fem/pipeline/support/numbers.h"

#include <boost/algorithm/string/classification.hpp>
#include <boost/algorithm/string/split.hpp>
#include <boost/algorithm/string/trim.hpp>

#include <algorithm>
#include <cmath>

namespace stemware::pipeline
{

namespace
{

/// "2: 5 um @ 20 deg"; the azimuth may be left out.
std::optional<fem::WavinessHarmonic> parse_harmonic(const std::string &text)
{
  const auto colon = text.find(':'), at = std::min(text.find('@'), text.size());
  if (colon > at)
    return std::nullopt;
  const auto order = parse_count(text.substr(0, colon));
  const auto amplitude = parse_quantity(text.substr(colon + 1, at - colon - 1), "m");
  const auto azimuth = at < text.size() ? parse_quantity(text.substr(at + 1), "rad") : 0.;
  constexpr double end_of_amplitudes = 1, end_of_azimuths = 1000;
  if (!order || *order < 2 || !amplitude || !azimuth || !(std::abs(*amplitude) < end_of_amplitudes) ||
      !(std::abs(*azimuth) < end_of_azimuths))
    return std::nullopt;
  return fem::WavinessHarmonic{ *order, *amplitude, *azimuth };
}

} // namespace

const char *const waviness_words =
  "harmonics \"n: amplitude @ azimuth\" (m, rad) separated by commas, such as 2: 5 um @ 20 deg, 3: 2e-6, "
  "with n from 2 on (n = 0 is an offset and n = 1 a tilt, which the table's motions absorb) and amplitudes "
  "below "
  "1 m, or nothing";

std::optional<Waviness> parse_waviness(const std::string &text)
{
  Waviness waviness;
  if (boost::trim_copy(text).empty())
    return waviness;
  std::vector<std::string> parts;
  boost::split(parts, text, boost::is_any_of(","));
  for (const std::string &part : parts)
  {
    const auto harmonic = parse_harmonic(part);
    if (!harmonic)
      return std::nullopt;
    waviness.push_back(*harmonic);
  }
  return waviness;
}

std::string waviness_text(const Waviness &waviness)
{
  std::string text;
  for (const fem::WavinessHarmonic &harmonic : waviness)
  {
    text += (text.empty() ? "" : ", ") + std::to_string(harmonic.n) + ": " + to_text(harmonic.amplitude);
    if (harmonic.azimuth != 0)
      text += " @ " + to_text(harmonic.azimuth);
  }
  return text;
}

} // namespace stemware::pipeline
