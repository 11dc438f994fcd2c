#include "fem/pipeline/report/plot.h"

#include "fem/pipeline/report/filled_text.h"
#include "fem/pipeline/report/gnuplot.h"
#include "fem/pipeline/report/render/html_page.h"
#include "fem/pipeline/support/numbers.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <regex>
#include <sstream>

namespace stemware::pipeline
{

namespace
{

std::string in_gnuplot(bool value)
{
  return value ? "1" : "0";
}

std::string in_gnuplot(double value)
{
  if (std::isnan(value))
    return "NaN";
  const std::string text = to_text(value);
  // gnuplot divides whole numbers as C does.
  return text.find_first_of(".e") == std::string::npos ? text + "." : text;
}

std::string in_gnuplot(const std::string &text)
{
  return gnuplot_text(text);
}

template <typename Value>
std::string assignment(const std::string &name, const Value &value)
{
  return name + " = " + in_gnuplot(value) + '\n';
}

template <typename Value>
std::string assignment(const std::string &name, const std::vector<Value> &values)
{
  std::string list;
  for (const Value &value : values)
    list += (list.empty() ? "" : ", ") + in_gnuplot(value);
  // gnuplot has no empty arrays, and looks at the first entry even where none is drawn.
  return "n_" + name + " = " + std::to_string(values.size()) + "; array " + name + "[" +
         std::to_string(std::max<std::size_t>(values.size(), 1)) + "] = [" +
         (values.empty() ? in_gnuplot(Value()) : list) + "]\n";
}

} // namespace

Plot Plot::as(const std::string &new_name, const std::string &new_caption) const
{
  Plot plot = *this;
  plot.name = new_name;
  plot.caption = new_caption;
  return plot;
}

Plot plot_from(const std::string &name, const PlotValues &values, const std::string &data)
{
  Plot plot = { name, "", "", data };
  for (const auto &[variable, value] : values)
    std::visit([&, key = variable](const auto &content) { plot.script += assignment(key, content); }, value);
  std::istringstream lines(plot_file_text(name + ".gp"));
  bool is_caption = true;
  for (std::string line; std::getline(lines, line);)
    if (is_caption = is_caption && line.rfind("# ", 0) == 0; is_caption)
      plot.caption += (plot.caption.empty() ? "" : " ") + line.substr(2);
    else
      plot.script += line + '\n';
  static const std::regex data_file("\"([a-z_/]+[.](?:dat|csv))\"");
  if (std::smatch found; data.empty() && std::regex_search(plot.script, found, data_file))
    plot.data_file = found[1];
  return plot;
}

Plot drawing_from(const std::string &name, const nlohmann::ordered_json &facts)
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
