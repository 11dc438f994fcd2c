#pragma once

#include <nlohmann/json.hpp>

#include <cmath>
#include <functional>
#include <optional>
#include <string>

namespace nlohmann
{

/// A value that may not exist: null where it does not.
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

/// A number, or nothing where it is not finite: null in JSON, which has no word for it.
inline std::optional<double> finite_or_null(double value)
{
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

/// A text, or nothing where it is empty.
inline std::optional<std::string> text_or_null(const std::string &text)
{
  return text.empty() ? std::nullopt : std::optional(text);
}

/// A @p value of what may not exist, a member or a function of it; null where it does not.
template <typename Thing, typename Value>
nlohmann::ordered_json to_json_or_null(const std::optional<Thing> &thing, Value value)
{
  return thing ? nlohmann::ordered_json(std::invoke(value, *thing)) : nlohmann::ordered_json(nullptr);
}

/// Bytes of other programs' files that are no UTF-8, such as names in a mesh, become replacement characters.
inline std::string dump_utf8(const nlohmann::ordered_json &json, int indent = -1)
{
  return json.dump(indent, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

/// The name of a member as a key: without the members that it belongs to, and the n_ of a count.
inline std::string key_of_member(const std::string &path)
{
  const std::string name = path.substr(path.rfind('.') + 1);
  return name.rfind("n_", 0) == 0 ? name.substr(2) : name;
}

/// The object @p json, or each of a list of objects, with these keys alone (parted by blanks), in this order.
/// Throws nlohmann::json::out_of_range for a key that there is not.
nlohmann::ordered_json selected_keys(const nlohmann::ordered_json &json, const std::string &keys);

} // namespace stemware::pipeline

#define STEMWARE_JSON_MEMBER(member) json[stemware::pipeline::key_of_member(#member)] = object.member;

/// The JSON object of members of a plain struct, by their names: STEMWARE_JSON(point, state.time,
/// slip_ratio).
#define STEMWARE_JSON(plain_struct, ...)                                                                     \
  [](const auto &object)                                                                                     \
  {                                                                                                          \
    nlohmann::ordered_json json;                                                                             \
    NLOHMANN_JSON_EXPAND(NLOHMANN_JSON_PASTE(STEMWARE_JSON_MEMBER, __VA_ARGS__))                             \
    return json;                                                                                             \
  }(plain_struct)
