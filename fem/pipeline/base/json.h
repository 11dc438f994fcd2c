#pragma once

#include <nlohmann/json.hpp>

#include <cmath>
#include <optional>
#include <string>

namespace nlohmann
{

/// Serialises std::optional; std::nullopt as null.
template <typename Value>
struct adl_serializer<std::optional<Value>, void>
{
  template <typename AnyJson>
  static void to_json(AnyJson &json, const std::optional<Value> &value)
  {
    if (value)
      json = *value;
    else
      json = nullptr;
  }
};

} // namespace nlohmann

namespace stemware::pipeline
{

using Json = nlohmann::ordered_json;

/// Returns @p value; std::nullopt (null in JSON) if it is not finite.
inline std::optional<double> finite_or_null(double value)
{
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

/// Returns @p text; std::nullopt if it is empty.
inline std::optional<std::string> text_or_null(const std::string &text)
{
  return text.empty() ? std::nullopt : std::optional(text);
}

/// Returns the text of @p json; bytes that are not UTF-8 become replacement characters.
inline std::string dump_utf8(const nlohmann::ordered_json &json, int indent = -1)
{
  return json.dump(indent, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

/// Parses JSON from an untrusted @p text. Throws BadInput, beginning with @p origin, for a syntax error (with
/// line and column), excessive nesting, or a repeated name.
Json parse_json(const std::string &origin, const std::string &text);

/// Returns whether @p text is valid UTF-8.
bool is_utf8(const std::string &text);

/// Returns JSON for a script element of a page: <, >, &, U+2028 and U+2029 in strings are escaped (\u003c
/// ...), so that no string ends the element or opens a comment.
std::string json_within_html(const Json &json);

} // namespace stemware::pipeline
