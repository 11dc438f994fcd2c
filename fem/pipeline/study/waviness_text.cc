#include "fem/pipeline/study/waviness_text.h"

#include "fem/pipeline/study/quantity_text.h"
#include "fem/pipeline/support/numbers.h"

#include <boost/algorithm/string/classification.hpp>
#include <boost/algorithm/string/split.hpp>
#include <boost/algorithm/string/trim.hpp>

#include <cmath>
#include <fmt/format.h>

namespace stemware::pipeline
{

namespace
{

/// The text before and after the first @p separator, trimmed; nothing for the second where there is none.
std::pair<std::string, std::optional<std::string>> cut(const std::string &text, char separator)
{
  const auto place = text.find(separator);
  if (place == std::string::npos)
    return { boost::trim_copy(text), std::nullopt };
  return { boost::trim_copy(text.substr(0, place)), boost::trim_copy(text.substr(place + 1)) };
}

std::optional<fem::WavinessHarmonic> parse_harmonic(const std::string &text)
{
  const auto [order_text, rest] = cut(text, ':');
  if (!rest)
    return std::nullopt;
  const auto [amplitude_text, azimuth_text] = cut(*rest, '@');
  const auto order = parse_count(order_text);
  const auto amplitude = parse_quantity(amplitude_text, "m");
  const auto azimuth = azimuth_text ? parse_quantity(*azimuth_text, "rad") : 0.;
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
    text +=
      fmt::format(FMT_STRING("{}{}: {}"), text.empty() ? "" : ", ", harmonic.n, to_text(harmonic.amplitude));
    if (harmonic.azimuth != 0)
      text += " @ " + to_text(harmonic.azimuth);
  }
  return text;
}

} // namespace stemware::pipeline
