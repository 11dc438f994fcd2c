#include "fem/pipeline/report/plot.h"

#include "fem/pipeline/report/filled_text.h"
#include "fem/pipeline/report/render/marked_text.h"
#include "fem/pipeline/report/render/table_renderers.h"
#include "fem/pipeline/support/child_process.h"
#include "fem/pipeline/support/failures.h"
#include "fem/pipeline/support/numbers.h"
#include "fem/pipeline/support/shared_files.h"
#include "fem/pipeline/support/text_file.h"

#include <boost/algorithm/string/replace.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>

namespace stemware::pipeline
{

/// The files of plots/.
const CompiledTexts &compiled_plots();

namespace fs = std::filesystem;

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

/// The first of the results' files that a script names in double quotes; empty if it names none. User texts
/// stand in single quotes.
std::string data_file_in(const std::string &script)
{
  for (std::size_t begin = script.find('"'); begin < script.size(); begin = script.find('"', begin + 1))
  {
    const std::size_t end = script.find_first_not_of("abcdefghijklmnopqrstuvwxyz_/", begin + 1);
    for (const std::string extension : { ".dat\"", ".csv\"" })
      if (end < script.size() && end > begin + 1 && script.compare(end, extension.size(), extension) == 0)
        return script.substr(begin + 1, end + extension.size() - begin - 2);
  }
  return "";
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
  if (plot.data.empty())
    plot.data_file = data_file_in(plot.script);
}

// ---- gnuplot

constexpr std::array formats = { "svg", "pdf" };

fs::path plot_file(const Plot &plot, const std::string &extension)
{
  return fs::path("figures") / (plot.name + "." + extension);
}

std::string script_of(const Plot &plot)
{
  const std::string file = plot_file(plot, "gp").string();
  std::ostringstream script;
  script << "# " << boost::replace_all_copy(plot.caption, "\n", "\n# ")
         << "\n# Drawn again, as SVG or as PDF, in the folder of the results:\n"
         << "#   gnuplot " << file << "\n#   gnuplot -e 'format = \"pdf\"' " << file << "\n"
         << "name = \"" << plot.name << "\"; data = \"" << plot_file(plot, "dat").string()
         << "\"; width = 540; height = 360; note = \"\"\n"
         << plot.script << (plot.script.empty() || plot.script.back() != '\n' ? "\n" : "");
  return script.str();
}

void write_scripts(const std::vector<Plot> &plots, const fs::path &folder)
{
  fs::create_directory(folder / "figures");
  write_text_file(folder / "figures/style.gnuplot", plot_file_text("style.gnuplot"));
  for (const Plot &plot : plots)
  {
    if (!plot.drawing.empty())
    {
      write_text_file(folder / plot_file(plot, "svg"), plot.drawing);
      continue;
    }
    write_text_file(folder / plot_file(plot, "gp"), script_of(plot));
    if (!plot.data.empty())
      write_text_file(folder / plot_file(plot, "dat"), plot.data);
  }
}

/// A gnuplot that draws some plots one after the other; a user's own start-up files have no say.
std::vector<std::string> drawing(const std::string &format, const std::vector<Plot> &plots)
{
  std::vector<std::string> command = { "gnuplot", "-d", "-e", "format = \"" + format + "\"" };
  for (const Plot &plot : plots)
    command.push_back(plot_file(plot, "gp").string());
  return command;
}

/// Draws one plot in one format, alone. Returns what gnuplot says when it fails; what it has drawn by then
/// is not kept.
std::string draw_alone(const std::string &format, const Plot &plot, const fs::path &folder)
{
  const EndedProgram ended = run_programs({ drawing(format, { plot }) }, folder).front();
  if (ended.exit_status == 0)
    return "";
  fs::remove(folder / plot_file(plot, format));
  return "gnuplot could not draw " + plot_file(plot, format).string() + " (" +
         (ended.messages.empty() ? "exit status " + std::to_string(ended.exit_status)
                                 : on_one_line(ended.messages)) +
         "). ";
}

/// The hour at which a PDF was made is the only thing in it that differs between equal runs: blanks instead.
void remove_date(const fs::path &pdf)
{
  std::fstream stream(pdf, std::ios::binary | std::ios::in | std::ios::out);
  std::ostringstream whole;
  whole << stream.rdbuf();
  const std::string text = whole.str();
  const auto begin = text.rfind("/CreationDate");
  const auto end = text.find(')', begin);
  if (begin == std::string::npos || end == std::string::npos)
    return;
  stream.clear();
  stream.seekp(static_cast<std::streamoff>(begin));
  stream << std::string(end + 1 - begin, ' ');
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

std::string missing_plotter()
{
  if (has_program("gnuplot"))
    return "";
  return "gnuplot is not in the PATH: there will be no pictures, only their scripts and data; install it "
         "(Debian: apt-get install gnuplot-nox).";
}

std::string plot_file_text(const std::string &name)
{
  std::error_code error;
  for (const fs::path &shared : shared_folders())
    if (const fs::path file = shared / "plots" / name; fs::is_regular_file(file, error))
      return read_text_file(file);
  return text_of(compiled_plots(), name);
}

std::string draw_plots(const std::vector<Plot> &pictures, const fs::path &folder)
{
  write_scripts(pictures, folder);
  std::vector<Plot> plots;
  std::copy_if(pictures.begin(), pictures.end(), std::back_inserter(plots),
               [](const Plot &picture) { return picture.drawing.empty(); });
  if (const std::string trouble = missing_plotter(); !trouble.empty())
    return trouble;
  if (plots.empty())
    return "";
  std::vector<std::vector<std::string>> commands;
  for (const char *format : formats)
    commands.push_back(drawing(format, plots));
  const std::vector<EndedProgram> ended = run_programs(commands, folder);
  std::string trouble;
  for (std::size_t f = 0; f < formats.size(); ++f)
    if (ended[f].exit_status != 0)
      for (const Plot &plot : plots) // gnuplot stops at the first that fails
        trouble += draw_alone(formats[f], plot, folder);
  for (const Plot &plot : plots)
    if (const fs::path pdf = folder / plot_file(plot, "pdf"); fs::exists(pdf))
      remove_date(pdf);
  return trouble;
}

} // namespace stemware::pipeline
