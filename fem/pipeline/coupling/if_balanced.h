#pragma once

#include "fem/contact/contact_solution.h"
#include "ring_model/no_balance.h"

#include <optional>
#include <string>

namespace stemware::pipeline
{

/// The result of @p find; nothing where a contact or a balance does not exist or was not found, and @p
/// reason, if given, says why. These are the only failures that mean "no value": all others are thrown on.
template <typename Find>
auto if_balanced(const Find &find, std::string *reason = nullptr) -> std::optional<decltype(find())>
{
  std::string sentence;
  try
  {
    return find();
  }
  catch (const ring::NoBalance &failure)
  {
    sentence = failure.what();
  }
  catch (const fem::ContactFailure &failure)
  {
    sentence = failure.what();
  }
  if (reason)
    *reason = sentence;
  return std::nullopt;
}

} // namespace stemware::pipeline
