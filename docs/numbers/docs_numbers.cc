// The numbers in README.md and docs/: computes the studies that they come from, and rewrites or checks the
// pages.
//
//   docs_numbers STEMWARE SOURCE_FOLDER WORK_FOLDER          rewrites the pages and draws the pictures
//   docs_numbers STEMWARE SOURCE_FOLDER WORK_FOLDER --check  exit code 1 if a number has drifted
//   docs_numbers --keys SOURCE_FOLDER                        rewrites what is declared elsewhere:
//   docs/summary.md and the plausible ranges of docs/values.md; computes nothing
//
// docs/numbers/studies.txt says which studies there are and how a page shows a number.

#include "fem/pipeline/study/study_entries.h"
#include "fem/pipeline/support/numbers.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <regex>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace
{

namespace fs = std::filesystem;

struct Picture
{
  std::string study, name, page_file;
};

/// What docs/numbers/studies.txt says.
struct StudyList
{
  std::map<std::string, std::string> commands; ///< by name
  std::vector<Picture> pictures;
};

std::string read_file(const fs::path &file)
{
  std::ifstream stream(file, std::ios::binary);
  if (!stream)
    throw std::runtime_error(file.string() + " cannot be read.");
  return { std::istreambuf_iterator<char>(stream), {} };
}

StudyList read_list(const fs::path &file)
{
  StudyList list;
  std::istringstream lines(read_file(file));
  for (std::string line; std::getline(lines, line);)
  {
    static const std::regex study(R"((\w+):\s*stemware (.+))"), picture(R"(draw (\w+) (\w+) (\S+))");
    std::smatch part;
    if (line.empty() || line[0] == '#')
      continue;
    if (std::regex_match(line, part, study))
      list.commands[part[1]] = part[2];
    else if (std::regex_match(line, part, picture))
      list.pictures.push_back({ part[1], part[2], part[3] });
    else
      throw std::runtime_error(file.string() + " has a line that is neither a study nor a picture: " + line);
  }
  return list;
}

std::string quoted(const std::string &text)
{
  return "'" + std::regex_replace(text, std::regex("'"), R"('\'')") + "'";
}

/// Studies by name; each is computed when a page first asks for it, unless their numbers are only checked:
/// then the results are there.
class Results
{
public:
  Results(const std::string &program, const fs::path &source, const fs::path &work, const StudyList &list,
          bool only_check)
      : program(only_check ? "" : program)
      , source(source)
      , work(work)
      , list(list)
  {
  }

  fs::path folder(const std::string &study)
  {
    summary(study);
    return work / study;
  }

  /// The number at @p place: "/KEY/KEY..." in summary.json, or "TABLE.csv/ENTRY=VALUE/COLUMN" (cell()). An
  /// element of an array has its index as its key, or its "name" or "step", "_" for a blank.
  double value(const std::string &study, const std::string &place)
  {
    if (place.find('/') != 0)
      return cell(study, place);
    const nlohmann::json *part = &summary(study);
    std::istringstream keys(place.substr(1));
    for (std::string key; part && std::getline(keys, key, '/');)
      part = part_of(*part, key);
    if (!part || !part->is_number())
      throw std::runtime_error(study + " has no number " + place + " in its summary.json.");
    return part->get<double>();
  }

private:
  static const nlohmann::json *part_of(const nlohmann::json &whole, const std::string &key)
  {
    if (!whole.is_array())
      return whole.contains(key) ? &whole[key] : nullptr;
    for (const nlohmann::json &element : whole)
      for (const char *label : { "name", "step" })
        if (element.is_object() && element.contains(label) && spaced(key) == element[label])
          return &element;
    const bool is_index = key.find_first_not_of("0123456789") == std::string::npos;
    return is_index && std::stoul(key) < whole.size() ? &whole[std::stoul(key)] : nullptr;
  }

  static std::string spaced(const std::string &key) { return std::regex_replace(key, std::regex("_"), " "); }

  using Row = std::vector<std::string>;

  /// The place of a heading @p name, without unit, "_" for a blank; the section of an entry may be left out.
  static std::size_t column_of(const Row &headings, const std::string &name)
  {
    for (std::size_t i = 0; i < headings.size(); ++i)
    {
      const std::string heading = headings[i].substr(0, headings[i].find(" ("));
      if (heading == name || heading == spaced(name) || heading.substr(heading.find('/') + 1) == spaced(name))
        return i;
    }
    throw std::runtime_error("no table column is called " + name + ".");
  }

  /// Whether a cell holds @p wanted: the same text, or the same number up to its rounding.
  static bool holds(const std::string &cell, const std::string &wanted)
  {
    static const std::regex number(R"([-+]?[0-9][-+.0-9eE]*)");
    return cell == wanted ||
           (std::regex_match(cell, number) && std::regex_match(wanted, number) &&
            std::abs(std::stod(cell) - std::stod(wanted)) <= 1e-9 * std::abs(std::stod(wanted)));
  }

  /// A cell of a table of numbers: TABLE/ENTRY=VALUE/COLUMN, or ENTRY=VALUE,ENTRY=VALUE of two. Exactly one
  /// row has to have the values.
  double cell(const std::string &study, const std::string &place)
  {
    std::smatch part;
    if (!std::regex_match(place, part, std::regex("([^/]+)/([^/]+=[^/]+)/(.+)")))
      throw std::invalid_argument(place);
    std::istringstream lines(read_file(folder(study) / part[1].str()));
    std::vector<Row> rows;
    for (std::string line; std::getline(lines, line);)
      rows.push_back(cells_of(line));
    const Row headings = rows.at(0);
    rows.erase(rows.begin());
    for (const std::string &condition : cells_of(part[2]))
    {
      const std::size_t equals = condition.find('='),
                        column = column_of(headings, condition.substr(0, equals));
      rows.erase(std::remove_if(rows.begin(), rows.end(),
                                [&](const Row &row)
                                { return !holds(row.at(column), condition.substr(equals + 1)); }),
                 rows.end());
    }
    const std::size_t column = column_of(headings, part[3]);
    if (rows.size() != 1 || column >= rows[0].size() || rows[0][column].empty())
      throw std::runtime_error(study + " has no number " + place + ": " + std::to_string(rows.size()) +
                               " of its rows have these values.");
    return std::stod(rows[0][column]);
  }

  static Row cells_of(const std::string &line)
  {
    Row cells;
    std::istringstream text(line);
    for (std::string cell; std::getline(text, cell, ',');)
      cells.push_back(cell);
    return cells;
  }

  const nlohmann::json &summary(const std::string &study)
  {
    const auto known = summaries.find(study);
    if (known != summaries.end())
      return known->second;
    const auto command = list.commands.find(study);
    if (command == list.commands.end())
      throw std::runtime_error("a page shows a number of " + study + ", which studies.txt does not have.");
    if (!program.empty())
      compute(study, command->second);
    return summaries[study] = nlohmann::json::parse(read_file(work / study / "summary.json"));
  }

  void compute(const std::string &study, const std::string &command) const
  {
    std::cout << study << ": stemware " << command << std::endl;
    const std::string call = "cd " + quoted(source.string()) + " && " + quoted(program) + " " + command +
                             " --quiet --output " + quoted((work / study).string());
    if (std::system(call.c_str()) != 0)
      throw std::runtime_error(study + " has failed.");
  }

  const std::string program; ///< empty: the results are there
  const fs::path source, work;
  const StudyList &list;
  std::map<std::string, nlohmann::json> summaries;
};

double operand(const std::string &word, Results &results)
{
  const auto colon = word.find(':');
  if (colon != std::string::npos)
    return results.value(word.substr(0, colon), word.substr(colon + 1));
  std::size_t n_read = 0;
  const double number = std::stod(word, &n_read);
  if (n_read != word.size())
    throw std::invalid_argument(word);
  return number;
}

/// Evaluates "VALUE (OPERATOR VALUE)*" from left to right.
double evaluate(const std::string &expression, Results &results)
{
  std::istringstream words(expression);
  std::string word;
  words >> word;
  double value = operand(word, results);
  for (std::string sign; words >> sign >> word;)
  {
    const double other = operand(word, results);
    if (sign == "+")
      value += other;
    else if (sign == "-")
      value -= other;
    else if (sign == "*")
      value *= other;
    else if (sign == "/")
      value /= other;
    else
      throw std::invalid_argument(sign);
  }
  return value;
}

std::string formatted(const std::string &format, double value)
{
  char text[64];
  std::snprintf(text, sizeof(text), format.c_str(), value);
  return std::regex_replace(std::string(text), std::regex("-"), "\u2212");
}

/// Whether @p shown is @p value to its last digit, or so close to the border that another processor may round
/// it so.
bool shows(const std::string &shown, const std::string &expected, double value)
{
  if (shown == expected)
    return true;
  if (shown.size() != expected.size())
    return false;
  const std::string plain = std::regex_replace(shown, std::regex("\u2212"), "-");
  const auto exponent = plain.find('e');
  const auto point = plain.find('.');
  double digit = exponent == std::string::npos ? 1 : std::pow(10, std::stod(plain.substr(exponent + 1)));
  if (point != std::string::npos)
    digit *= std::pow(10, -static_cast<double>(std::min(exponent, plain.size()) - point - 1));
  return std::abs(std::stod(plain) - value) <= 0.55 * digit;
}

/// The page with its numbers brought up to date; says on the console which ones have drifted.
std::string updated(const std::string &page, const fs::path &name, Results &results, unsigned int &n_numbers,
                    unsigned int &n_drifted)
{
  static const std::regex marker(R"(<!--= (.*?) (%\S+) -->([^<]*)<!--=-->)");
  std::string text;
  auto rest = page.cbegin();
  for (std::sregex_iterator found(page.begin(), page.end(), marker), end; found != end; ++found)
  {
    const std::string expression = (*found)[1], format = (*found)[2], shown = (*found)[3];
    double value = 0;
    try
    {
      value = evaluate(expression, results);
    }
    catch (const std::invalid_argument &error)
    {
      throw std::runtime_error(name.string() + " has a marker that cannot be read: " + expression);
    }
    std::string number = formatted(format, value);
    ++n_numbers;
    if (shows(shown, number, value))
      number = shown;
    else
    {
      ++n_drifted;
      std::cout << name.string() << ": " << shown << " is " << number << " (" << expression << ")"
                << std::endl;
    }
    text.append(rest, page.cbegin() + found->position(3)).append(number);
    rest = page.cbegin() + found->position(3) + found->length(3);
  }
  return text.append(rest, page.cend());
}

std::vector<fs::path> pages_of(const fs::path &source)
{
  std::vector<fs::path> pages = { source / "README.md" };
  for (const auto &entry : fs::recursive_directory_iterator(source / "docs"))
    if (entry.path().extension() == ".md")
      pages.push_back(entry.path());
  std::sort(pages.begin(), pages.end());
  return pages;
}

/// The rows "| `key` | unit | meaning |" of the properties of a schema, those of objects and lists in it
/// below them;
/// @p path stands before their keys.
std::string key_rows(const nlohmann::ordered_json &schema, const std::string &path)
{
  std::string rows;
  if (!schema.contains("properties"))
    return rows;
  for (const auto &[key, value] : schema["properties"].items())
  {
    const std::string name = path + key;
    const nlohmann::ordered_json nothing = nlohmann::ordered_json::object();
    rows += "| `" + name + "` | " + value.value("unit", "") + " | " +
            std::regex_replace(value.value("description", ""), std::regex("[|]"), "\\|") + " |\n";
    rows += key_rows(value, name + ".") + key_rows(value.value("items", nothing), name + "[].");
    if (value.contains("additionalProperties") && value["additionalProperties"].is_object())
      rows += key_rows(value["additionalProperties"], name + ".*.");
  }
  return rows;
}

/// The page docs/summary.md: the keys of summary.json as its schema declares them.
std::string page_of_keys(const fs::path &source)
{
  const auto schema =
    nlohmann::ordered_json::parse(read_file(source / "fem/pipeline/document/summary.schema.json"));
  return "# The keys of summary.json\n\n" + schema["description"].get<std::string>() +
         " The schema is `fem/pipeline/document/summary.schema.json`, installed as "
         "`share/stemware/summary.schema.json`; "
         "this page is made from it by `cmake --build build/release --target docs_keys`. Each verb "
         "writes a subset of the keys; `[]` represents each entry of a list, `*` any name.\n\n"
         "| key | unit | meaning |\n|---|---|---|\n" +
         key_rows(schema, "") + "\n`load`, `load_at_terminal` and `load_at_fall` have these keys:\n\n" +
         "| key | unit | meaning |\n|---|---|---|\n" + key_rows(schema["definitions"]["load"], "load.");
}

/// The page docs/values.md with the plausible ranges of the entries of a study in its table.
std::string page_of_values(const std::string &page)
{
  using stemware::pipeline::to_short_text;
  std::string rows;
  for (const stemware::pipeline::StudyEntry &entry : entries_of(stemware::pipeline::Study()))
    if (entry.plausible)
      rows += "| `" + entry.path() + "` | " + to_short_text(entry.plausible->min) + " to " +
              to_short_text(entry.plausible->max) + (entry.unit == "1" ? "" : ' ' + entry.unit) + " | " +
              entry.plausible_reason + " |\n";
  const std::string head = "| entry | range | from what to what |\n|---|---|---|\n";
  const auto begin = page.find(head);
  if (begin == std::string::npos)
    throw std::runtime_error("docs/values.md has no table of plausible ranges.");
  return page.substr(0, begin) + head + rows + page.substr(page.find("\n\n", begin) + 1);
}

void work_on_keys(const fs::path &source, bool only_check)
{
  const fs::path keys = source / "docs/summary.md", values = source / "docs/values.md";
  for (const auto &[page, text] :
       { std::pair(keys, page_of_keys(source)), std::pair(values, page_of_values(read_file(values))) })
    if (!only_check)
      std::ofstream(page, std::ios::binary) << text;
    else if (read_file(page) != text)
      throw std::runtime_error(page.string() +
                               " is not what the program declares; the target docs_keys makes it again.");
}

/// The SVG file of a picture of a report, as Chromium draws it.
std::string drawn(const fs::path &report, const std::string &name, const fs::path &work)
{
  const fs::path page = work / "picture.html";
  const std::string address = "file://" + fs::absolute(report).string() + "#svg=" + name,
                    command = "chromium --headless --no-sandbox --disable-gpu --dump-dom --user-data-dir=" +
                              quoted((work / "chromium").string()) + " " + quoted(address) + " > " +
                              quoted(page.string()) + " 2>/dev/null";
  const int status = std::system(command.c_str());
  const std::string text = read_file(page), begin = "<svg ", end = "</svg>";
  const auto first = text.find(begin), last = text.find(end);
  if (status != 0 || first == std::string::npos || last == std::string::npos)
    throw std::runtime_error("Chromium did not draw the picture " + name + " of " + report.string() +
                             "; install it (packages.txt), and see that the report has the picture.");
  return text.substr(first, last + end.size() - first) + "\n";
}

/// Heights of the marks of a picture, in the order of its text [px]: end points of lines, circles, bars.
/// Widths depend on the fonts of the machine, heights do not.
std::vector<double> heights_of(const std::string &svg)
{
  static const std::regex mark("[ML]-?[0-9.]+[ ,](-?[0-9.]+)|V(-?[0-9.]+)|(?:cy|height)=\"([0-9.]+)\"");
  std::vector<double> heights;
  for (std::sregex_iterator found(svg.begin(), svg.end(), mark), end; found != end; ++found)
    for (std::size_t group = 1; group < found->size(); ++group)
      if ((*found)[group].matched)
        heights.push_back(std::stod((*found)[group]));
  return heights;
}

/// Whether the picture @p now, drawn from today's results, has the data of the one beside the page.
bool shows_its_data(const fs::path &page_file, const std::string &now)
{
  constexpr double tolerance = 0.5; // of some 220 px between the frame's lower and upper side
  const std::vector<double> before = heights_of(read_file(page_file)), after = heights_of(now);
  return !before.empty() &&
         std::equal(before.begin(), before.end(), after.begin(), after.end(),
                    [](double one, double other) { return std::abs(one - other) <= tolerance; });
}

int work_on(const std::vector<std::string> &arguments, bool only_check)
{
  const fs::path source = arguments[1], work = arguments[2];
  const StudyList list = read_list(source / "docs/numbers/studies.txt");
  fs::create_directories(work);
  Results results(arguments[0], source, work, list, only_check);

  unsigned int n_numbers = 0, n_drifted = 0;
  for (const fs::path &page : pages_of(source))
  {
    const std::string before = read_file(page);
    const std::string after = updated(before, page.lexically_relative(source), results, n_numbers, n_drifted);
    if (!only_check && after != before)
      std::ofstream(page, std::ios::binary) << after;
  }
  for (const Picture &picture : list.pictures)
  {
    const fs::path page_file = source / picture.page_file;
    const std::string now = drawn(results.folder(picture.study) / "report.html", picture.name, work);
    if (!only_check)
    {
      fs::create_directories(page_file.parent_path());
      std::ofstream(page_file, std::ios::binary) << now;
    }
    else if (!shows_its_data(page_file, now))
    {
      std::cout << picture.page_file << " shows other data than the report of " << picture.study << std::endl;
      ++n_drifted;
    }
  }
  std::cout << n_numbers << " numbers, " << list.pictures.size() << " pictures, " << n_drifted
            << (only_check ? " drifted" : " rewritten") << std::endl;
  if (n_numbers == 0)
    throw std::runtime_error("no page shows a number: the markers are gone.");
  return only_check && n_drifted > 0 ? 1 : 0;
}

} // namespace

int main(int argc, char *argv[])
{
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  const bool only_check = argc > 1 && arguments.back() == "--check";
  const bool only_keys = argc > 1 && arguments.front() == "--keys";
  if (arguments.size() != (only_keys ? 2u : 3u) + (only_check ? 1u : 0u))
  {
    std::cerr << "usage: docs_numbers STEMWARE SOURCE_FOLDER WORK_FOLDER [--check], or docs_numbers --keys "
                 "SOURCE_FOLDER [--check]"
              << std::endl;
    return 2;
  }
  try
  {
    if (!only_keys)
      return work_on(arguments, only_check);
    work_on_keys(arguments[1], only_check);
    return 0;
  }
  catch (const std::exception &error)
  {
    std::cerr << "docs_numbers: " << error.what() << std::endl;
    return 1;
  }
}
