#pragma once

#include "ring_model/no_balance.h"

#include <optional>
#include <string>

namespace stemware::ring
{
/// Returns the result of @p find, or std::nullopt if it throws NoBalance; then writes the reason to @p
/// reason, if given. All other exceptions pass.
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
