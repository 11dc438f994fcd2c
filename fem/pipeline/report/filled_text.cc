#include "fem/pipeline/report/filled_text.h"

#include "fem/pipeline/document/number_format.h"
#include "fem/pipeline/report/render/marked_text.h"
#include "fem/pipeline/support/shared_files.h"

#include <boost/algorithm/string/split.hpp>

#include <algorithm>
#include <deque>
#include <kainjow/mustache.hpp>
#include <map>
#include <stdexcept>
#include <vector>

namespace stemware::pipeline
{

/// The files of templates/.
const CompiledTexts &compiled_pages();

namespace
{

using Json = nlohmann::ordered_json;
using kainjow::mustache::data;

/// The facts as mustache asks for them, by name and inside of sections.
class Facts : public kainjow::mustache::basic_context<std::string>
{
public:
  Facts(const Json &facts, ShownFact shown)
      : shown(shown)
      , inside({ &facts })
  {
  }

  void push(const data *section) override { inside.push_back(values.at(section)); }
  void pop() override { inside.pop_back(); }

  const data *get(const std::string &name) const override
  {
    static const Json yes = true, no = false;
    if (name.back() == '?')
      return as_data(find(name.substr(0, name.size() - 1)).empty() ? no : yes, "");
    const auto colon = std::min(name.find(':'), name.size());
    const std::string format = colon < name.size() ? name.substr(colon + 1) : ".6g";
    return as_data(find(name.substr(0, colon)), format);
  }

  const data *get_partial(const std::string &name) const override
  {
    made.emplace_back(text_of(compiled_pages(), name.find('.') < name.size() ? name : name + ".txt"));
    return &made.back();
  }

private:
  /// The value of a path of keys in the innermost section that has its first one.
  const Json &find(const std::string &path) const
  {
    static const Json nothing;
    if (path == ".")
      return *inside.back();
    std::vector<std::string> keys;
    boost::split(keys, path, [](char c) { return c == '.'; });
    for (auto section = inside.rbegin(); section != inside.rend(); ++section)
    {
      if (!(*section)->is_object() || !(*section)->contains(keys.front()))
        continue;
      const Json *value = *section;
      for (const std::string &key : keys)
      {
        if (value->is_null())
          return nothing;
        if (!value->is_object() || !value->contains(key))
          throw std::logic_error("A text of the report asks for " + path + ", of which there is no " + key +
                                 ".");
        value = &(*value)[key];
      }
      return *value;
    }
    throw std::logic_error("A text of the report asks for " + path + ", which there is not.");
  }

  const data *as_data(const Json &value, const std::string &format) const
  {
    if (value.is_array())
    {
      data list(data::type::list);
      for (std::size_t i = 0; i < value.size(); ++i)
        list << data(data::type::object);
      made.push_back(std::move(list));
      std::size_t i = 0;
      for (const data &element : made.back().list_value())
        values[&element] = &value[i++];
    }
    else if (shown != nullptr && !value.is_object())
      made.emplace_back(shown(value));
    else if (value.is_null() || value == Json(false) || value == Json(""))
      made.emplace_back(data::type::bool_false);
    else if (value.is_boolean())
      made.emplace_back(data::type::bool_true);
    else if (value.is_object())
      made.emplace_back(data::type::object);
    else if (value.is_number_integer())
      made.emplace_back(std::to_string(value.get<long>()));
    else
      made.emplace_back(value.is_string() ? in_form(value, format) : format::number(value, format));
    values[&made.back()] = &value;
    return &made.back();
  }

  ShownFact shown;
  std::vector<const Json *> inside; ///< the facts, and the sections that the text is in at the moment
  mutable std::deque<data> made;    ///< whose addresses mustache keeps
  mutable std::map<const data *, const Json *> values; ///< what they stand for
};

} // namespace

std::string filled_text(const std::string &name, const Json &facts)
{
  return filled(text_of(compiled_pages(), name), facts, nullptr, name);
}

std::string filled(const std::string &text, const Json &facts, ShownFact shown, const std::string &name)
{
  kainjow::mustache::mustache page(text);
  const bool is_marked = name.find(".svg") != std::string::npos || name.find(".html") != std::string::npos;
  page.set_custom_escape([=](const std::string &text) { return is_marked ? html_text(text) : text; });
  if (!page.is_valid())
    throw std::logic_error("The template " + name + " is not valid: " + page.error_message());
  Facts context(facts, shown);
  const std::string result = page.render(context);
  if (!page.is_valid())
    throw std::logic_error("The template " + name + " cannot be filled: " + page.error_message());
  return result;
}

} // namespace stemware::pipeline
