#include "fem/pipeline/study/prm_file.h"

#include "fem/pipeline/support/failures.h"
#include "fem/pipeline/support/text.h"

#include <boost/algorithm/string/predicate.hpp>
#include <boost/algorithm/string/replace.hpp>
#include <boost/algorithm/string/trim.hpp>

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <sstream>

namespace stemware::pipeline
{

namespace
{

/// The lines of @p text that hold anything, by the number of the first that they begin on: without comments
/// and blanks at their ends, and with those that a backslash continues.
std::map<unsigned int, std::string> whole_lines(const std::string &text)
{
  std::map<unsigned int, std::string> lines;
  std::istringstream stream(text);
  unsigned int number = 0, first = 1;
  for (std::string line; std::getline(stream, line);)
  {
    ++number;
    boost::trim(line);
    const bool goes_on = !line.empty() && line.back() == '\\';
    lines[first] += goes_on ? line.substr(0, line.size() - 1) : line;
    if (!goes_on)
      first = number + 1;
  }
  for (auto &[begin, line] : lines)
    line = boost::trim_copy(line.substr(0, line.find('#')));
  return lines;
}

} // namespace

void read_prm(const std::string &file, const std::string &text, const std::vector<StudyEntry> &entries)
{
  const std::string one_end = "write one \"end\" for each \"subsection\".";
  const std::vector<std::string> known = sections_of(entries);
  const auto place = [&](unsigned int line)
  { return fmt::format(FMT_STRING("{}, line {}: "), shortened_path(file), line); };
  std::string section;                         // empty outside of all
  unsigned int section_line = 0;               // where it begins
  std::map<std::string, unsigned int> line_of; // by path of the entry
  for (const auto &[number, line] : whole_lines(text))
  {
    const std::string where = place(number), word = line.substr(0, line.find_first_of(" \t")),
                      rest = boost::trim_copy(line.substr(word.size()));
    if (line.empty())
      continue;
    if (boost::iequals(word, "subsection") && !rest.empty())
    {
      require(section.empty(), fmt::format(FMT_STRING("{}the subsection {} of line {} is not closed; {}"),
                                           where, section, section_line, one_end));
      require(std::find(known.begin(), known.end(), rest) != known.end(),
              fmt::format(FMT_STRING("{}there is no subsection \"{}\"; use {}."), where, shortened(rest),
                          listed(known)));
      section = rest;
      section_line = number;
    }
    else if (boost::iequals(word, "set"))
    {
      const auto equal_sign = rest.find('=');
      require(equal_sign != std::string::npos,
              where + "a line that begins with set has no = ; write set ENTRY = VALUE.");
      const std::string path =
        (section.empty() ? "" : section + '/') + boost::trim_copy(rest.substr(0, equal_sign));
      const auto [before, is_first] = line_of.emplace(path, number);
      require(is_first,
              fmt::format(FMT_STRING("{}{} is set a second time, after line {}; leave one of them."), where,
                          path, before->second));
      assign(entries, where, path, boost::trim_copy(rest.substr(equal_sign + 1)));
    }
    else if (boost::iequals(line, "end"))
    {
      require(!section.empty(), where + "an \"end\" has no \"subsection\" above it; " + one_end);
      section.clear();
    }
    else
      throw BadInput(fmt::format(
        FMT_STRING(
          "{}\"{}\" is not a line of a study file; write subsection NAME, set ENTRY = VALUE, or end."),
        where, shortened(line)));
  }
  require(section.empty(), fmt::format(FMT_STRING("{}the subsection {} is not closed; {}"),
                                       place(section_line), section, one_end));
}

std::string prm_text(const std::vector<StudyEntry> &entries, bool comments)
{
  std::map<std::string, std::size_t> width; // of the names of a section
  for (const StudyEntry &entry : entries)
    width[entry.section] = std::max(width[entry.section], entry.name.size());
  const std::string end = comments ? "end\n\n" : "end\n";
  std::string text, section;
  for (const StudyEntry &entry : entries)
  {
    const bool begins = entry.section != section;
    if (begins)
      text += (section.empty() ? "" : end) + "subsection " + entry.section + '\n';
    section = entry.section;
    if (comments)
      text += (begins ? "" : "\n") +
              boost::replace_all_copy(
                "\n" + wrapped(entry.help + ". Allowed: " + entry.allowed + ".", "", 74), "\n", "\n  # ")
                .substr(1) +
              '\n';
    text += fmt::format(FMT_STRING("  set {:<{}} = {}\n"), entry.name, width[section], entry.text());
  }
  return text + end;
}

} // namespace stemware::pipeline
