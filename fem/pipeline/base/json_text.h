#pragma once

#include "fem/pipeline/base/json.h"

#include <optional>
#include <string>

namespace stemware::pipeline
{

/// Parses JSON from an untrusted @p text. Throws BadInput, beginning with @p origin, for a syntax error (with
/// line and column), excessive nesting, or a repeated name.
nlohmann::ordered_json parse_json(const std::string &origin, const std::string &text);

/// Parses JSON written by the program; std::nullopt if it is invalid.
std::optional<nlohmann::ordered_json> json_in(const std::string &text);

/// Returns whether @p text is valid UTF-8.
bool is_utf8(const std::string &text);

/// Returns JSON for a script element of a page: <, >, &, U+2028 and U+2029, which occur in strings only, are
/// escaped as \u003c and so on. The text cannot end the element or open a comment.
std::string json_within_html(const nlohmann::ordered_json &json);

} // namespace stemware::pipeline
