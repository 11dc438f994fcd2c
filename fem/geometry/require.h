#pragma once

#include <sstream>
#include <stdexcept>
#include <string>

namespace stemware::fem
{

/// One sentence made of its @p parts, numbers with six digits.
template <typename... Parts>
std::string sentence(const Parts &...parts)
{
  std::ostringstream text;
  (text << ... << parts);
  return text.str();
}

/// Throws std::invalid_argument with the sentence made of @p parts unless @p condition holds.
template <typename... Parts>
void require(bool condition, const Parts &...parts)
{
  if (!condition)
    throw std::invalid_argument(sentence(parts...));
}

} // namespace stemware::fem
