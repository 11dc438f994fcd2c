#pragma once

#include <optional>
#include <string>
#include <vector>

namespace stemware::pipeline
{

/// Number of letters to insert, delete or change to get from one word to the other, upper and lower case
/// being equal.
std::size_t edit_distance(const std::string &from, const std::string &to);

/// The one of @p words that somebody who wrote @p word most likely meant; nothing where none is like it.
std::optional<std::string> likeliest(const std::string &word, const std::vector<std::string> &words);

} // namespace stemware::pipeline
