#pragma once

#include <nlohmann/json.hpp>

#include <string>

namespace stemware::pipeline
{

/// The template fem/pipeline/report/templates/@p name with the values of @p facts in its place-holders.
///
/// The language is mustache's: {{value}}; {{#fact}}...{{/fact}} where a fact is true, is there, or once for
/// each of a list; {{^fact}}...{{/fact}} where it is not; {{> name}} for another template. A value is a path
/// of keys, {{ring.standing}}. A number has its digits behind a colon, {{omega:.6g}}, as format::number()
/// takes them: {{share:.1f%}}, {{length:1e3*.4g}} mm. A number that does not exist is a dash.
///
/// Throws std::logic_error for a template, a key or a format that does not exist: no sentence loses its
/// number silently. A key below null is as null.
std::string filled_text(const std::string &name, const nlohmann::ordered_json &facts);

} // namespace stemware::pipeline
