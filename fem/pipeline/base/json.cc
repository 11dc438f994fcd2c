#include "fem/pipeline/base/json.h"

#include "fem/pipeline/base/failures.h"

#include <boost/algorithm/string/replace.hpp>

#include <algorithm>
#include <fmt/format.h>
#include <set>
#include <vector>

namespace stemware::pipeline
{

namespace
{

/// Maximum nesting level. Values are printed, compared and copied recursively, so deep nesting could overflow
/// the stack.
constexpr int max_levels = 100;

/// Returns the location of the byte @p place (counted from 0), e.g. "line 3, column 7".
std::string place_in(const std::string &text, std::size_t place)
{
  const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(place, text.size()));
  const auto line_begin = std::find(std::make_reverse_iterator(end), text.rend(), '\n').base();
  return fmt::format(FMT_STRING("line {}, column {}"), 1 + std::count(text.begin(), end, '\n'),
                     1 + (end - line_begin));
}

} // namespace

Json parse_json(const std::string &origin, const std::string &text)
{
  std::vector<std::set<std::string>> names; // names used in each open object
  const auto look = [&](int level, Json::parse_event_t event, Json &value)
  {
    if (level > max_levels)
      throw BadInput(fmt::format(
        FMT_STRING(
          "{}: the JSON is nested more than {} levels deep; a study has sections and entries, two levels."),
        origin, max_levels));
    if (event == Json::parse_event_t::object_start)
      names.emplace_back();
    else if (event == Json::parse_event_t::object_end)
      names.pop_back();
    // The parser would silently drop one of two values with the same name.
    else if (event == Json::parse_event_t::key && !names.back().insert(value.get<std::string>()).second)
      throw BadInput(origin + ": \"" + shortened(value.get<std::string>()) +
                     "\" stands twice; leave one of them.");
    return true;
  };
  try
  {
    return Json::parse(text, look);
  }
  catch (const Json::parse_error &error)
  {
    const std::size_t place = error.byte > 0 ? error.byte - 1 : 0;
    throw BadInput(
      fmt::format(FMT_STRING("{}, {}: {}; write JSON such as {{\"Glass\": {{\"Contact radius\": 0.03}}}}."),
                  origin, place_in(text, place),
                  place >= text.size() ? "the JSON ends before it is complete" : "the JSON is broken here"));
  }
  catch (const Json::exception &)
  {
    throw BadInput(origin + " has a number outside the range of double precision; write smaller numbers.");
  }
}

std::string json_within_html(const Json &json)
{
  std::string text = json.dump();
  for (const auto &[character, escape] :
       { std::pair("<", "\\u003c"), std::pair(">", "\\u003e"), std::pair("&", "\\u0026"),
         std::pair("\u2028", "\\u2028"), std::pair("\u2029", "\\u2029") })
    boost::replace_all(text, character, escape);
  return text;
}

bool is_utf8(const std::string &text)
try
{
  Json(text).dump();
  return true;
}
catch (const Json::exception &)
{
  return false;
}

} // namespace stemware::pipeline
