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

/// Returns JSON for a script element of a page: <, >, &, U+2028 and U+2029 in strings are escaped (\u003c
/// ...), so that no string ends the element or opens a comment.
std::string json_within_html(const Json &json);

} // namespace stemware::pipeline
