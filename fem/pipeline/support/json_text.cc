#include "fem/pipeline/support/json_text.h"

#include "fem/pipeline/support/failures.h"

#include <algorithm>
#include <fmt/format.h>

namespace stemware::pipeline
{

using Json = nlohmann::ordered_json;

namespace
{

/// Values are printed, compared and copied by functions that call themselves for every level.
constexpr unsigned int most_levels = 100;

/// Where the brackets of @p text first stand deeper than that.
std::optional<std::size_t> too_deep(const std::string &text)
{
  unsigned int level = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i)
    if (in_string && text[i] == '\\')
      ++i; // whatever follows belongs to the string
    else if (in_string)
      in_string = text[i] != '"';
    else if (text[i] == '"')
      in_string = true;
    else if (text[i] == '{' || text[i] == '[')
    {
      if (++level > most_levels)
        return i;
    }
    else if ((text[i] == '}' || text[i] == ']') && level > 0)
      --level;
  return std::nullopt;
}

/// "line 3, column 7" of the byte at @p place, counted from 0.
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
  if (const auto place = too_deep(text))
    throw BadInput(fmt::format(FMT_STRING("{}, {}: the JSON is nested more than {} levels deep; a study has "
                                          "sections and entries, two levels."),
                               origin, place_in(text, *place), most_levels));
  try
  {
    return Json::parse(text);
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
    throw BadInput(origin + " has a number that no computer holds; write numbers of usual size.");
  }
}

std::optional<Json> json_in(const std::string &text)
try
{
  return parse_json("", text);
}
catch (const BadInput &)
{
  return std::nullopt;
}

} // namespace stemware::pipeline
