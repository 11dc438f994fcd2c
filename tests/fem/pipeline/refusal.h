#pragma once

#include "fem/pipeline/base/failures.h"

#include <string>

namespace stemware::test
{

/// Returns the message with which @p action refuses its input; empty if @p action accepts its input.
template <typename Action>
std::string sentence_of(const Action &action)
{
  try
  {
    action();
  }
  catch (const pipeline::BadInput &refused)
  {
    return refused.what();
  }
  return "";
}

} // namespace stemware::test
