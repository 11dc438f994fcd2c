#pragma once

#include "ring_model/no_balance.h"

#include <optional>
#include <string>

namespace stemware::ring
{
/// Returns the result of @p find; std::nullopt if a balance does not exist or was not found, and writes the
/// reason to @p reason, if given. NoBalance is the only failure that means "no value": all others are thrown
/// on.
template <typename Find>
auto if_balanced(const Find &find, std::string *reason = nullptr) -> std::optional<decltype(find())>
{
  try
  {
    return find();
  }
  catch (const NoBalance &failure)
  {
    if (reason)
      *reason = failure.what();
    return std::nullopt;
  }
}
} // namespace stemware::ring
