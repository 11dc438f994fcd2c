#pragma once

#include <nlohmann/json.hpp>

#include <optional>
#include <string>

namespace stemware::pipeline
{

/// The JSON of @p text, which may come from anywhere. Throws BadInput with one sentence, which begins with
/// @p origin, where it is broken (with line and column), nested deeper than any file of a study, or has two
/// values of one name.
nlohmann::ordered_json parse_json(const std::string &origin, const std::string &text);

/// The JSON of a text that the program itself has written: nothing where it is broken.
std::optional<nlohmann::ordered_json> json_in(const std::string &text);

/// True if @p text is valid UTF-8, as JSON has to be.
bool is_utf8(const std::string &text);

/// Writes JSON for a script element of a page: <, >, &, U+2028 and U+2029, which stand in strings alone, as
/// escapes such as \u003c. The text neither ends the element nor opens a comment in it.
std::string json_within_html(const nlohmann::ordered_json &json);

} // namespace stemware::pipeline
