#include "fem/pipeline/report/document.h"

#include "fem/pipeline/report/filled_text.h"

#include <boost/algorithm/string/replace.hpp>
#include <boost/algorithm/string/split.hpp>
#include <boost/algorithm/string/trim.hpp>

#include <algorithm>
#include <stdexcept>

namespace stemware::pipeline
{

namespace
{

using Json = nlohmann::ordered_json;

/// The words before and after the first @p mark, without blanks round them; the second may be empty.
std::pair<std::string, std::string> parted(const std::string &text, char mark)
{
  const auto place = std::min(text.find(mark), text.size());
  return { boost::trim_copy(text.substr(0, place)),
           boost::trim_copy(text.substr(std::min(place + 1, text.size()))) };
}

/// The part of the @p facts at a path of keys.
const Json &part_of(const Json &facts, const std::string &path)
{
  const Json::json_pointer place("/" + boost::replace_all_copy(path, ".", "/"));
  if (!facts.contains(place))
    throw std::logic_error("A template shows " + path + ", which the document does not have.");
  return facts[place];
}

/// "NAME: KEY KEY | TITLE": the table NAME of the @p document, or rows of its @p facts.
Table table_from(const Document &document, const Json &facts, const std::string &what)
{
  const auto [columns, title] = parted(what, '|');
  const auto [path, keys] = parted(columns, ':');
  if (const auto table = document.tables.find(path); table != document.tables.end())
    return table->second;
  return table_of(part_of(facts, path), keys, path.substr(0, path.find('.')), title, document.quantities);
}

/// A text of the @p document, or what table_from() makes of it.
Content content_of(const Document &document, const Json &facts, const std::string &what)
{
  if (const auto text = document.texts.find(what); text != document.texts.end())
    return text->second;
  return table_from(document, facts, what);
}

/// The results as they grow, line by line of a filled template.
class Reading
{
public:
  Reading(const Document &document, Json &facts)
      : document(document)
      , facts(facts)
  {
    results.findings = document.findings;
  }

  void add(const std::string &line)
  {
    if (line.rfind("= ", 0) == 0)
      results.report.title = line.substr(2);
    else if (line.rfind("# ", 0) == 0 || line.rfind("#> ", 0) == 0)
    {
      const auto [mark, heading] = parted(line, ' ');
      results.report.sections.push_back({ heading });
      section().folded = mark == "#>";
    }
    else if (line[0] == '@')
      obey(parted(line.substr(1), ' '));
    else
      add_text(line);
  }

  /// Notes where the columns of a file of the results stand, before pictures ask for them.
  void note_columns(const std::string &command)
  {
    const auto [file, name] = parted(parted(command, '|').first, '=');
    const auto end = file.find(".csv");
    if (end == std::string::npos || name.empty())
      return;
    const Table table = table_from(document, facts, name);
    Json &columns = facts["columns"][file.substr(0, end)];
    for (std::size_t c = 0; c < table.columns.size(); ++c)
      columns.emplace(table.columns[c].quantity.key, c + 1); // of a list the first one
  }

  Results results;

private:
  ReportSection &section()
  {
    if (results.report.sections.empty())
      throw std::logic_error("A template shows a table, a picture or a file before its first heading.");
    return results.report.sections.back();
  }

  std::string &present_text()
  {
    if (on_console)
      return results.console.back().text;
    if (!results.report.sections.empty())
      return section().text;
    return in_inputs ? results.report.inputs : results.report.answer;
  }

  void add_text(const std::string &line)
  {
    std::string &text = present_text();
    const bool is_close = text.empty() || text.back() == '\n' || std::string(",;.)").find(line[0]) < 4;
    text += (is_close ? "" : " ") + line;
  }

  void obey(const std::pair<std::string, std::string> &command)
  {
    const auto &[word, rest] = command;
    if (word == "plot")
      add_plot(rest);
    else if (word == "drawing")
      (results.report.sections.empty() ? results.report.pictures : section().plots)
        .push_back(drawing_from(rest, facts));
    else if (word == "inputs" || word == "answer")
      in_inputs = word == "inputs";
    else if (word == "table")
      add_table(table_from(document, facts, rest));
    else if (word == "list")
      add_list(rest);
    else if (word == "words")
      add_table(table_of(Json::array(), parted(rest, '|').first, "", parted(rest, '|').second));
    else if (word == "row")
      add_row(rest);
    else if (word == "file")
      add_file(rest);
    else if (word == "p")
      add_paragraph();
    else if (word == "console" || word == "block")
    {
      on_console = true;
      results.console.emplace_back();
    }
    else
      throw std::logic_error("A template has @" + word + ", which means nothing.");
  }

  void add_paragraph()
  {
    std::string &text = present_text();
    if (!text.empty())
      text += on_console ? "\n" : "\n\n";
  }

  void add_plot(const std::string &what)
  {
    const auto [names, label] = parted(what, '|');
    const auto [name, source] = parted(names, '=');
    Plot plot = picture_of(document, facts, name, source.empty() ? name : source);
    plot.label = label;
    section().plots.push_back(plot);
  }

  void add_table(const Table &table)
  {
    if (!on_console)
      section().tables.push_back(table);
    else
    {
      results.console.back().table = table;
      results.console.emplace_back();
    }
  }

  /// A list of the listed numbers of a part of the findings, unless there are none; or of the keys that are
  /// named.
  void add_list(const std::string &what)
  {
    const auto [path, title] = parted(what, '|');
    const Table numbers = path.find(':') == std::string::npos
                            ? table_of(listed(part_of(facts, path), path), "", path)
                            : table_from(document, facts, what);
    if (numbers.n_rows() > 0)
      add_table(table_of(as_list(numbers), "", "", title));
  }

  /// A row of the table before; the last column has all that is left.
  void add_row(std::string words)
  {
    const std::string bar = " | ";
    std::vector<Column> &columns = section().tables.back().columns;
    for (Column &column : columns)
    {
      const auto end = &column == &columns.back() ? words.size() : std::min(words.find(bar), words.size());
      column.cells.push_back(words.substr(0, end));
      words.erase(0, end + bar.size());
    }
  }

  void add_file(const std::string &what)
  {
    const auto [names, words] = parted(what, '|');
    const auto [file, content] = parted(names, '=');
    results.files.push_back({ file, words });
    if (!content.empty())
      results.files.back().content = content_of(document, facts, content);
    if (!words.empty())
      section().files.push_back({ file, words });
  }

  const Document &document;
  Json &facts;
  bool in_inputs = false;
  bool on_console = false;
};

} // namespace

Plot picture_of(const Document &document, const Json &facts, const std::string &name,
                const std::string &source)
{
  const auto values = document.plots.find(name);
  return plot_from(name, source, facts, values == document.plots.end() ? Json::object() : values->second,
                   [&](const std::string &what) { return content_of(document, facts, what); });
}

Results shown(const Document &document, const std::string &name)
{
  Json facts = document.findings.summary;
  facts.update(document.facts);
  std::vector<std::string> lines;
  boost::split(lines, filled_text(name + ".txt", facts), [](char c) { return c == '\n'; });
  Reading reading(document, facts);
  const std::string file = "@file ";
  for (std::string &line : lines)
    if (boost::trim(line); line.rfind(file, 0) == 0)
      reading.note_columns(line.substr(file.size()));
  for (const std::string &line : lines)
    if (!line.empty())
      reading.add(line);
  Results results = reading.results;
  results.console.erase(std::remove_if(results.console.begin(), results.console.end(),
                                       [](const ConsoleBlock &block)
                                       { return block.text.empty() && !block.table; }),
                        results.console.end());
  return results;
}

} // namespace stemware::pipeline
