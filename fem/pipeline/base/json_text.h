#pragma once

#include "fem/pipeline/base/json.h"

#include <string>

namespace stemware::pipeline
{

/// Parses JSON from an untrusted @p text. Throws BadInput, beginning with @p origin, for a syntax error (with
/// line and column), excessive nesting, or a repeated name.
Json parse_json(const std::string &origin, const std::string &text);

/// Returns whether @p text is valid UTF-8.
bool is_utf8(const std::string &text);

/// Returns JSON for a script element of a page: <, >, &, U+2028 and U+2029, which occur in strings only, are
/// escaped as \u003c and so on. The text cannot end the element or open a comment.
std::string json_within_html(const Json &json);

} // namespace stemware::pipeline
