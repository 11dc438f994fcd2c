#pragma once

#include <boost/math/constants/constants.hpp>

namespace stemware::ring
{
inline constexpr double pi = boost::math::constants::pi<double>();
} // namespace stemware::ring
