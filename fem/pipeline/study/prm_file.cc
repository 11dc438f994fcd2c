#include "fem/pipeline/study/prm_file.h"

#include "fem/pipeline/study/renamed_entries.h"
#include "fem/pipeline/support/failures.h"
#include "fem/pipeline/support/text.h"

#include <boost/algorithm/string/predicate.hpp>
#include <boost/algorithm/string/trim.hpp>

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <sstream>

namespace stemware::pipeline
{

namespace
{

/// Names of the sections in their order.
std::vector<std::string> sections_of(const std::vector<StudyEntry> &entries)
{
  std::vector<std::string> sections;
  for (const StudyEntry &entry : entries)
    if (sections.empty() || sections.back() != entry.section)
      sections.push_back(entry.section);
  return sections;
}

/// Takes the lines of a study file one after the other.
class PrmReader
{
public:
  PrmReader(const std::string &file, const std::vector<StudyEntry> &entries)
      : file(file)
      , entries(entries)
  {
  }

  /// A line without its comment and blanks at its ends; @p number counts from 1.
  void take(const std::string &line, unsigned int number)
  {
    where = fmt::format(FMT_STRING("{}, line {}: "), shortened_path(file), number);
    const std::string word = line.substr(0, line.find_first_of(" \t"));
    const std::string rest = boost::trim_copy(line.substr(word.size()));
    if (boost::iequals(word, "subsection") && !rest.empty())
      begin_section(rest, number);
    else if (boost::iequals(word, "set"))
      set(rest, number);
    else if (boost::iequals(line, "end"))
      end_section();
    else
      throw BadInput(fmt::format(
        FMT_STRING(
          "{}\"{}\" is not a line of a study file; write subsection NAME, set ENTRY = VALUE, or end."),
        where, shortened(line)));
  }

  /// To be called after the last line.
  void finish() const
  {
    require(section.empty(),
            fmt::format(
              FMT_STRING(
                "{}, line {}: the subsection {} is not closed; write one \"end\" for each \"subsection\"."),
              shortened_path(file), section_line, section));
  }

private:
  void begin_section(const std::string &name, unsigned int number)
  {
    require(section.empty(),
            fmt::format(
              FMT_STRING(
                "{}the subsection {} of line {} is not closed; write one \"end\" for each \"subsection\"."),
              where, section, section_line));
    const std::vector<std::string> known = sections_of(entries);
    require(
      std::find(known.begin(), known.end(), name) != known.end(),
      fmt::format(FMT_STRING("{}there is no subsection \"{}\"; use Motion, Glass, Table, Contact or Load."),
                  where, shortened(name)));
    section = name;
    section_line = number;
  }

  void end_section()
  {
    require(!section.empty(),
            where + "an \"end\" has no \"subsection\" above it; write one \"end\" for each \"subsection\".");
    section.clear();
  }

  void set(const std::string &assignment, unsigned int number)
  {
    const auto equal_sign = assignment.find('=');
    require(equal_sign != std::string::npos,
            where + "a line that begins with set has no = ; write set ENTRY = VALUE.");
    const std::string name = boost::trim_copy(assignment.substr(0, equal_sign));
    const std::string value = boost::trim_copy(assignment.substr(equal_sign + 1));
    refuse_renamed(where, section + '/' + name, value);
    const auto entry = std::find_if(entries.begin(), entries.end(),
                                    [&](const StudyEntry &candidate)
                                    { return candidate.section == section && candidate.name == name; });
    require(entry != entries.end(), fmt::format(FMT_STRING("{}there is no entry \"{}\" in this subsection{}"),
                                                where, shortened(name), suggestion(entries, name)));
    const auto [before, is_first] = line_of.emplace(entry->path(), number);
    require(is_first, fmt::format(FMT_STRING("{}{} is set a second time, after line {}; leave one of them."),
                                  where, entry->path(), before->second));
    assign(*entry, where, value);
  }

  const std::string file;
  const std::vector<StudyEntry> &entries;
  std::string where;                           ///< begins a sentence about the present line
  std::string section;                         ///< empty outside of all
  unsigned int section_line = 0;               ///< where it begins
  std::map<std::string, unsigned int> line_of; ///< by path of the entry
};

} // namespace

void read_prm(const std::string &file, const std::string &text, const std::vector<StudyEntry> &entries)
{
  PrmReader reader(file, entries);
  std::istringstream stream(text);
  unsigned int number = 0, first = 1;
  std::string whole;
  for (std::string line; std::getline(stream, line);)
  {
    ++number;
    boost::trim(line);
    const bool goes_on = !line.empty() && line.back() == '\\';
    if (goes_on)
      line.pop_back();
    whole += line;
    if (goes_on)
      continue;
    whole = boost::trim_copy(whole.substr(0, whole.find('#')));
    if (!whole.empty())
      reader.take(whole, first);
    whole.clear();
    first = number + 1;
  }
  reader.finish();
}

std::string prm_text(const std::vector<StudyEntry> &entries, bool comments)
{
  std::string text;
  for (const std::string &section : sections_of(entries))
  {
    std::size_t width = 0;
    for (const StudyEntry &entry : entries)
      if (entry.section == section)
        width = std::max(width, entry.name.size());
    text += "subsection " + section + '\n';
    bool is_first = true;
    for (const StudyEntry &entry : entries)
    {
      if (entry.section != section)
        continue;
      if (comments)
      {
        std::istringstream lines(wrapped(entry.help + ". Allowed: " + entry.allowed + ".", "", 74));
        text += is_first ? "" : "\n";
        for (std::string line; std::getline(lines, line);)
          text += "  # " + line + '\n';
      }
      is_first = false;
      text += fmt::format(FMT_STRING("  set {:<{}} = {}\n"), entry.name, width, entry.text());
    }
    text += comments ? "end\n\n" : "end\n";
  }
  return text;
}

} // namespace stemware::pipeline
