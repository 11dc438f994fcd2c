#include "fem/pipeline/report/plot.h"

#include "fem/pipeline/report/filled_text.h"
#include "fem/pipeline/report/gnuplot.h"
#include "fem/pipeline/report/render/marked_text.h"
#include "fem/pipeline/report/render/table_renderers.h"
#include "fem/pipeline/support/numbers.h"

#include <boost/algorithm/string/replace.hpp>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <regex>
#include <sstream>
#include <stdexcept>

namespace stemware::pipeline
{

namespace
{

using Json = nlohmann::ordered_json;

std::string in_gnuplot(const Json &value)
{
  if (value.is_string())
    return gnuplot_text(value.get<std::string>());
  if (value.is_boolean())
    return value.get<bool>() ? "1" : "0";
  if (!value.is_number() || std::isnan(value.get<double>()))
    return "NaN";
  const std::string text = to_text(value.get<double>());
  // gnuplot divides whole numbers as C does.
  return text.find_first_of(".e") == std::string::npos ? text + "." : text;
}

std::string assignment(const std::string &name, const Json &value)
{
  if (!value.is_array())
    return name + " = " + in_gnuplot(value) + '\n';
  std::string list;
  for (const Json &entry : value)
    list += (list.empty() ? "" : ", ") + in_gnuplot(entry);
  // gnuplot has no empty arrays, and looks at the first entry even where none is drawn.
  return "n_" + name + " = " + std::to_string(value.size()) + "; array " + name + "[" +
         std::to_string(std::max<std::size_t>(value.size(), 1)) + "] = [" + (list.empty() ? "0." : list) +
         "]\n";
}

bool has_words(const Column &column)
{
  return std::any_of(column.cells.begin(), column.cells.end(),
                     [](const Json &cell) { return cell.is_string(); });
}

/// Adds a block of data to a plot, words to its script.
void add_data(const Content &content, Plot &plot)
{
  std::string block;
  if (const auto *text = std::get_if<std::string>(&content))
    block = *text;
  else
  {
    Table numbers = std::get<Table>(content);
    for (const Column &column : numbers.columns)
      if (Json words = Json::array(); has_words(column))
      {
        for (const Json &cell : column.cells)
          words.push_back(cell.is_string() ? cell : "");
        plot.script += assignment(column.quantity.key, words);
      }
    numbers.columns.erase(std::remove_if(numbers.columns.begin(), numbers.columns.end(), has_words),
                          numbers.columns.end());
    block = data_table(numbers);
  }
  plot.data += (plot.data.empty() ? "" : "\n\n") + block;
}

/// Fills the template @p text into a plot that has its name.
void fill(const std::string &text, const std::string &file, const Json &facts, const Json &values,
          const std::function<Content(const std::string &)> &content, Plot &plot)
{
  std::istringstream lines(text);
  std::string script;
  bool is_caption = true, is_one_way = false;
  for (std::string line; std::getline(lines, line);)
    if (is_caption = is_caption && line.rfind("# ", 0) == 0; is_caption)
      plot.caption += (plot.caption.empty() ? "" : " ") + line.substr(2);
    else if (line.rfind("#@data ", 0) == 0)
      add_data(content(filled(line.substr(7), facts, nullptr, file)), plot);
    else if (line != "#@one_way")
      script += line + '\n';
    else
      is_one_way = facts.value("one_way", false);
  plot.caption = filled(plot.caption, facts, nullptr, file);
  if (is_one_way)
  {
    plot.script = "note = \"one-way: load of rest kept\"\n" + plot.script;
    plot.caption += std::string(plot.caption.empty() || plot.caption.back() == '.' ? "" : ".") +
                    " One-way: the load of rest is kept at every spin.";
  }
  for (const auto &[variable, value] : values.items())
    plot.script += assignment(variable, value);
  plot.script += filled(script, facts, in_gnuplot, file);
  static const std::regex data_file("\"([a-z_/]+[.](?:dat|csv))\"");
  if (std::smatch found; plot.data.empty() && std::regex_search(plot.script, found, data_file))
    plot.data_file = found[1];
}

} // namespace

Plot plot_from(const std::string &name, const std::string &source, Json facts, const Json &values,
               const std::function<Content(const std::string &)> &content)
{
  Plot plot = { name, "", "" };
  facts.update(values);
  facts["plot"] = name;
  const std::string file = source + ".gp", text = plot_file_text(file);
  try
  {
    fill(text, file, facts, values, content, plot);
  }
  catch (const std::logic_error &trouble) // of a template that somebody has changed
  {
    plot.script = "exit error '" + boost::replace_all_copy(std::string(trouble.what()), "'", "''") + "'\n";
  }
  return plot;
}

Plot drawing_from(const std::string &name, const Json &facts)
{
  Plot plot = { name, "", "" };
  plot.drawing = filled_text(name + ".svg", facts);
  const auto content = [&](const std::string &tag)
  {
    const auto begin = plot.drawing.find("<" + tag + ">") + tag.size() + 2;
    return plain_text(plot.drawing.substr(begin, plot.drawing.find("</" + tag + ">") - begin));
  };
  plot.label = content("title");
  plot.caption = content("desc");
  return plot;
}

std::string grouped_data(const std::string &title, const std::vector<std::string> &columns,
                         const std::vector<std::vector<std::vector<double>>> &groups)
{
  std::string data = "# " + title + '\n';
  for (std::size_t c = 0; c < columns.size(); ++c)
    data += fmt::format(FMT_STRING("# {}: {}\n"), c + 1, columns[c]);
  for (const auto &group : groups)
  {
    for (const std::vector<double> &row : group)
      for (std::size_t c = 0; c < row.size(); ++c)
        data += (std::isnan(row[c]) ? "nan" : fmt::format(FMT_STRING("{:.9g}"), row[c])) +
                (c + 1 < row.size() ? ' ' : '\n');
    data += '\n';
  }
  return data;
}

} // namespace stemware::pipeline
