#pragma once

#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>

namespace stemware::ring
{
/// Returns a sentence, the concatenation of @p parts; numbers have 12 significant digits.
template <typename... Parts>
std::string sentence(const Parts &...parts)
{
  std::ostringstream text;
  text.precision(12);
  (text << ... << parts);
  return text.str();
}

/// Returns @p value as text with @p n_digits significant digits.
inline std::string rounded_text(double value, int n_digits)
{
  std::ostringstream text;
  text.precision(n_digits);
  text << value + 0.; // no -0
  return text.str();
}

/// Throws std::invalid_argument with the concatenation of @p parts unless @p condition holds.
template <typename... Parts>
void require(bool condition, const Parts &...parts)
{
  if (!condition)
    throw std::invalid_argument(sentence(parts...));
}

/// Throws std::invalid_argument unless @p value is finite. @p what is the name in the message.
inline void require_finite(double value, const char *what)
{
  require(std::isfinite(value), what, " is ", value, ", but must be a finite number");
}

/// Throws std::invalid_argument unless @p value is finite and positive. The message has @p what and @p unit.
inline void require_positive(double value, const char *what, const char *unit)
{
  require(std::isfinite(value) && value > 0., what, " is ", value, " ", unit,
          ", but must be a finite positive number");
}
} // namespace stemware::ring
