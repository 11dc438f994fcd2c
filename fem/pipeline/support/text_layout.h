#pragma once

#include "fem/pipeline/support/text.h"

#include <cstdio>
#include <optional>
#include <string>

namespace stemware::pipeline
{

/// printf into a string. Only for the callers that have not changed to fmt::format(FMT_STRING(...)).
template <typename... Values>
std::string formatted(const char *format, Values... values)
{
  std::string text(static_cast<std::size_t>(std::snprintf(nullptr, 0, format, values...)) + 1, ' ');
  std::snprintf(text.data(), text.size(), format, values...);
  text.pop_back();
  return text;
}

/// A number in printf's @p format, or @p none where there is none.
inline std::string formatted_or(const std::string &none, const char *format,
                                const std::optional<double> &value)
{
  return value ? formatted(format, *value) : none;
}

} // namespace stemware::pipeline
