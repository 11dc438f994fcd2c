#pragma once

namespace stemware::ring
{
inline constexpr double pi = 3.141592653589793;
} // namespace stemware::ring
