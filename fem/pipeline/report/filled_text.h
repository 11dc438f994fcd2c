#pragma once

#include <nlohmann/json.hpp>

#include <string>

namespace stemware::pipeline
{

/// The template fem/pipeline/report/templates/@p name with the values of @p facts in its place-holders.
///
/// The language is mustache's: {{value}}; {{#fact}}...{{/fact}} where a fact is true, is there, or once for
/// each of a list; {{^fact}}...{{/fact}} where it is not; {{#list?}}...{{/list?}} once where it has
/// something;
/// {{> name}} for another template. A value is a path of keys, {{ring.standing}}. A number has its digits
/// behind a colon, {{omega:.6g}}, as format::number() takes them: {{share:.1f%}}, {{length:1e3*.4g}} mm; a
/// text has its form there, as in_form() takes it. A number that does not exist is a dash. Values in .svg and
/// .html are escaped but between three braces.
///
/// Throws std::logic_error for a template, a key or a format that does not exist: no sentence loses its
/// number silently. A key below null is as null.
std::string filled_text(const std::string &name, const nlohmann::ordered_json &facts);

/// How a text shows a number, a word, a flag or what does not exist.
using ShownFact = std::string (*)(const nlohmann::ordered_json &);

/// A @p text as filled_text() fills a template; with @p shown, all its values are shown as that says. @p name
/// of the text for messages.
std::string filled(const std::string &text, const nlohmann::ordered_json &facts, ShownFact shown,
                   const std::string &name);

} // namespace stemware::pipeline
