#pragma once

namespace stemware::ring
{
/// Ratio of a circle's circumference to its diameter, rounded to double precision.
inline constexpr double pi = 3.141592653589793;
} // namespace stemware::ring
