#pragma once

namespace stemware::ring
{
/// The circle constant, rounded to double precision.
inline constexpr double pi = 3.141592653589793;
} // namespace stemware::ring
