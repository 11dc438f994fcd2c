#pragma once

#include <nlohmann/json.hpp>

#include <cmath>
#include <functional>
#include <optional>
#include <string>

namespace nlohmann
{

/// Serialises std::nullopt as null.
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

/// Returns a member or a function value of @p thing; null if @p thing is std::nullopt.
template <typename Thing, typename Value>
nlohmann::ordered_json to_json_or_null(const std::optional<Thing> &thing, Value value)
{
  return thing ? nlohmann::ordered_json(std::invoke(value, *thing)) : nlohmann::ordered_json(nullptr);
}

/// Returns the text of @p json; bytes that are not UTF-8 become replacement characters.
inline std::string dump_utf8(const nlohmann::ordered_json &json, int indent = -1)
{
  return json.dump(indent, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

/// Returns the JSON key of a member: its name without enclosing members and without the n_ of a count.
inline std::string key_of_member(const std::string &path)
{
  const std::string name = path.substr(path.rfind('.') + 1);
  return name.rfind("n_", 0) == 0 ? name.substr(2) : name;
}

} // namespace stemware::pipeline

#define STEMWARE_JSON_MEMBER(member) json[stemware::pipeline::key_of_member(#member)] = object.member;

/// JSON object of the listed members of a struct, by name: STEMWARE_JSON(point, state.time, slip_ratio).
#define STEMWARE_JSON(plain_struct, ...)                                                                     \
  [](const auto &object)                                                                                     \
  {                                                                                                          \
    nlohmann::ordered_json json;                                                                             \
    NLOHMANN_JSON_EXPAND(NLOHMANN_JSON_PASTE(STEMWARE_JSON_MEMBER, __VA_ARGS__))                             \
    return json;                                                                                             \
  }(plain_struct)
