#pragma once

#include <string>
#include <utility>
#include <vector>

namespace stemware::pipeline
{

/// Sentence and its values.
struct Sentence
{
  std::string key, text; ///< text with its values
  std::vector<std::string> values;
};

/// Returns @p text with @p values in the places of {0}, {1} and so on. Braces within a value stay.
Sentence sentence(const std::string &key, const std::string &text,
                  const std::vector<std::string> &values = {});

} // namespace stemware::pipeline
