#include "fem/pipeline/study/study_file.h"

#include "fem/pipeline/base/failures.h"
#include "fem/pipeline/base/ranks.h"
#include "fem/pipeline/base/text.h"
#include "fem/pipeline/base/text_file.h"
#include "fem/pipeline/study/data_files.h"
#include "fem/pipeline/study/presets.h"
#include "fem/pipeline/study/study_entries.h"
#include "fem/pipeline/study/study_size.h"

#include <boost/algorithm/string/predicate.hpp>
#include <boost/algorithm/string/replace.hpp>
#include <boost/algorithm/string/trim.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <iostream>
#include <map>
#include <sstream>

namespace stemware::pipeline
{

namespace
{

constexpr std::size_t longest_study = 1000000;

/// Returns the text of @p stream, cut one character after the maximum length of a study. A longer text can
/// thus be detected.
std::string beginning_of(std::istream &stream)
{
  std::string text(longest_study + 1, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(stream.gcount()));
  return text;
}

/// Throws BadInput if the name or the type of @p file shows that it is not a study file.
void require_study_file(const std::string &the_file, const std::filesystem::path &file)
{
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (!std::filesystem::exists(status))
  {
    const std::vector<std::string> cookbooks = cookbook_names();
    const std::string name = file.stem();
    const bool is_cookbook = std::find(cookbooks.begin(), cookbooks.end(), name) != cookbooks.end();
    throw BadInput(the_file +
                   " does not exist; give the path of a .prm file, or write one with `stemware new " +
                   (is_cookbook ? "--cookbook " + name : "study.prm") + "`.");
  }
  ensure(std::filesystem::is_regular_file(status),
         the_file + " is not a file; give the path of a .prm file.");
  ensure(file.extension() == ".prm" || file.extension() == ".json",
         the_file + " ends in neither .prm nor .json; rename it so that its format is clear.");
}

std::string checked_text(const std::string &the_file, const std::string &bytes)
{
  const std::string text = without_byte_order_mark(the_file, bytes);
  ensure(text.size() <= longest_study,
         the_file + " is longer than 1 MB; give a study file, which has a line for each entry.");
  const auto is_control = [](unsigned char letter) { return letter < ' ' && !std::isspace(letter); };
  ensure(std::none_of(text.begin(), text.end(), is_control),
         the_file + " is not a text file; give the path of a .prm or .json file.");
  ensure(text.find_first_not_of(" \t\r\n") != std::string::npos,
         the_file +
           " is empty; write at least a comment into it to get the defaults, or start from `stemware new`.");
  return text;
}

std::string text_of_study(const std::string &the_file, const std::string &file)
{
  std::string bytes;
  if (file == "-") // standard input is available on the first rank only
    bytes = from_first_rank([] { return beginning_of(std::cin); });
  else
  {
    require_study_file(the_file, file);
    std::ifstream stream(file);
    bytes = beginning_of(stream);
    ensure(stream.eof() || bytes.size() > longest_study,
           the_file + " cannot be read; check its permissions.");
  }
  return checked_text(the_file, bytes);
}

/// Returns the non-empty lines of @p text by line number. Comments and surrounding blanks are removed, and
/// lines continued by a backslash are joined.
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

void read_json(const std::string &file, const std::string &text, const std::vector<StudyEntry> &entries)
{
  const Json sections = parse_json(file, text);
  ensure(sections.is_object(),
         file + " is not a JSON object; write {\"Glass\": {\"Contact radius\": 0.03}, ...}.");
  for (const auto &[section, values] : sections.items())
  {
    ensure(values.is_object(),
           fmt::format(
             FMT_STRING("{}: \"{}\" is not an object of entries; write {{\"{}\": {{\"Entry\": value}}}}."),
             file, shortened(section), shortened(section)));
    for (const auto &[name, value] : values.items())
      assign(entries, file + ": ", fmt::format(FMT_STRING("{}/{}"), section, name),
             value.is_string() ? value.get<std::string>() : value.dump());
  }
}

/// Returns the entries of @p study. Entries in @p overrides accept any value; --set replaces it later.
std::vector<StudyEntry> without_overridden(Study &study, const std::vector<std::string> &overrides)
{
  std::vector<StudyEntry> entries = study_entries(study);
  for (const std::string &text : overrides)
  {
    const std::string path = full_path(entries, boost::trim_copy(text.substr(0, text.find('='))));
    for (StudyEntry &entry : entries)
      if (entry.path() == path)
        entry.assign = [&study, path](const std::string &value)
        {
          study.given_entries[path] = value;
          return true;
        };
  }
  return entries;
}

/// Assigns the values of the options --set, "Section/Entry=value" or "Entry=value". Throws BadInput if an
/// entry is set twice.
void apply(const std::vector<std::string> &overrides, const std::vector<StudyEntry> &entries)
{
  std::map<std::string, std::string> text_of;
  for (const std::string &text : overrides)
  {
    const auto equal_sign = text.find('=');
    ensure(equal_sign != std::string::npos && equal_sign > 0,
           "--set \"" + shortened(text) + "\" is not an assignment; write --set \"Section/Entry=value\".");
    const std::string path = full_path(entries, boost::trim_copy(text.substr(0, equal_sign)));
    assign(entries, "--set: ", path, boost::trim_copy(text.substr(equal_sign + 1)));
    const auto [before, is_first] = text_of.emplace(path, text);
    ensure(is_first, fmt::format(FMT_STRING("--set sets {} twice, to \"{}\" and \"{}\"; leave one of them."),
                                 path, shortened(before->second), shortened(text)));
  }
}

std::string prm_text(const std::vector<StudyEntry> &entries, bool comments)
{
  std::map<std::string, std::size_t> width; // maximum length of the names in each section
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

/// Removes entries with default values from given_entries if the file states all entries, like the files of
/// `stemware defaults` and of results. The hand height, and entries that a profile file would determine, stay
/// given: otherwise a rerun would derive other values.
void forget_stated_defaults(Study &study)
{
  const std::vector<StudyEntry> &standard = default_entries(), own = entries_of(study);
  if (study.given_entries.size() < own.size())
    return;
  for (std::size_t i = 0; i < own.size(); ++i)
    if (own[i].text() == standard[i].text() && own[i].path() != "Motion/Hand height" &&
        !(study.glass.profile.shape == fem::GlassShape::profile && own[i].follows_from_profile))
      study.given_entries.erase(own[i].path());
}

std::vector<std::string *> paths_of(const std::vector<StudyEntry> &entries)
{
  std::vector<std::string *> paths;
  for (const StudyEntry &entry : entries)
    if (entry.path_value && !entry.path_value->empty())
      paths.push_back(entry.path_value);
  return paths;
}

bool begins_with_brace(const std::string &text)
{
  return text[text.find_first_not_of(" \t\r\n")] == '{';
}

void read_text(const std::string &origin, const std::string &text, bool is_json,
               const std::vector<StudyEntry> &entries)
{
  is_json ? read_json(shortened_path(origin), text, entries) : read_prm(origin, text, entries);
}

void read_files_and_check(Study &study)
{
  attach_profile(study);
  const std::string &speeds = study.motion.orbit_speed_file;
  study.motion.orbit_speeds.reset();
  if (!speeds.empty())
    study.motion.orbit_speeds = std::make_shared<const ring::OrbitSpeedTable>(read_orbit_speed_file(speeds));
  check_study(study);
  study.load.from_file.reset();
  if (study.load.source == LoadSource::file)
    study.load.from_file = std::make_shared<const ring::RingStack>(read_load_file(study.load.file));
}

} // namespace

void read_prm(const std::string &file, const std::string &text, const std::vector<StudyEntry> &entries)
{
  const std::string one_end = "write one \"end\" for each \"subsection\".";
  const std::vector<std::string> known = sections_of(entries);
  const auto place = [&](unsigned int line)
  { return fmt::format(FMT_STRING("{}, line {}: "), shortened_path(file), line); };
  std::string section;                         // empty outside of sections
  unsigned int section_line = 0;               // first line of the section
  std::map<std::string, unsigned int> line_of; // line of each entry, by its path
  for (const auto &[number, line] : whole_lines(text))
  {
    const std::string where = place(number), word = line.substr(0, line.find_first_of(" \t")),
                      rest = boost::trim_copy(line.substr(word.size()));
    if (line.empty())
      continue;
    ensure(is_utf8(line), where + "the line is not in UTF-8; save the study file as UTF-8.");
    if (boost::iequals(word, "subsection") && !rest.empty())
    {
      ensure(section.empty(), fmt::format(FMT_STRING("{}the subsection {} of line {} is not closed; {}"),
                                          where, section, section_line, one_end));
      const auto meant = closest_match(rest, known);
      ensure(std::find(known.begin(), known.end(), rest) != known.end(),
             fmt::format(FMT_STRING("{}there is no subsection \"{}\"; {}use {}."), where, shortened(rest),
                         meant ? "did you mean " + *meant + "? Else " : "", listed(known)));
      section = rest;
      section_line = number;
    }
    else if (boost::iequals(word, "set"))
    {
      const auto equal_sign = rest.find('=');
      ensure(equal_sign != std::string::npos,
             where + "a line that begins with set has no = ; write set ENTRY = VALUE.");
      const std::string name = boost::trim_copy(rest.substr(0, equal_sign)),
                        path = section.empty() ? full_path(entries, name)
                                               : fmt::format(FMT_STRING("{}/{}"), section, name);
      const auto [before, is_first] = line_of.emplace(path, number);
      ensure(is_first, fmt::format(FMT_STRING("{}{} is set a second time, after line {}; leave one of them."),
                                   where, path, before->second));
      assign(entries, where, path, boost::trim_copy(rest.substr(equal_sign + 1)));
    }
    else if (boost::iequals(line, "end"))
    {
      ensure(!section.empty(),
             fmt::format(FMT_STRING("{}an \"end\" has no \"subsection\" above it; {}"), where, one_end));
      section.clear();
    }
    else
      throw BadInput(fmt::format(
        FMT_STRING(
          "{}\"{}\" is not a line of a study file; write subsection NAME, set ENTRY = VALUE, or end."),
        where, shortened(line)));
  }
  ensure(section.empty(), fmt::format(FMT_STRING("{}the subsection {} is not closed; {}"),
                                      place(section_line), section, one_end));
}

void check_study(const Study &study)
{
  study.check_values();
  // Only the existence of files is checked before the computation, not their contents.
  if (study.load.source == LoadSource::file)
    require_regular_file("Load/File = " + shortened_path(study.load.file), study.load.file);
  if (!study.contact.mesh_file.empty())
    require_regular_file("Contact/Mesh file = " + shortened_path(study.contact.mesh_file),
                         study.contact.mesh_file);
  require_affordable(study);
}

Study read_study(const std::string &file, const std::vector<std::string> &overrides)
{
  Study study;
  const std::vector<StudyEntry> entries = study_entries(study);
  if (!file.empty())
  {
    const bool is_stream = file == "-";
    const std::string origin = is_stream ? "standard input" : file;
    const std::string text = text_of_study(
      is_stream ? "The study on standard input" : "The study file " + shortened_path(file), file);
    read_text(origin, text,
              is_stream ? begins_with_brace(text) : std::filesystem::path(file).extension() == ".json",
              without_overridden(study, overrides));
  }
  forget_stated_defaults(study);
  for (std::string *path : paths_of(entries))
    *path = (std::filesystem::path(file).parent_path() / *path).lexically_normal().string();
  apply(overrides, entries);
  read_files_and_check(study);
  return study;
}

Study read_study_text(const std::string &origin, const std::string &text)
{
  Study study;
  const std::string checked = checked_text(origin, text);
  read_text(origin, checked, begins_with_brace(checked), study_entries(study));
  forget_stated_defaults(study);
  read_files_and_check(study);
  return study;
}

Study with_values(Study study, const std::string &option,
                  const std::vector<std::pair<std::string, std::string>> &values)
{
  const std::vector<StudyEntry> entries = study_entries(study);
  for (const auto &[path, value] : values)
    assign(entries, option + ": ", path, value);
  read_files_and_check(study);
  return study;
}

std::string unit_of(const std::string &path)
{
  for (const StudyEntry &entry : default_entries())
    if (entry.path() == path)
      return entry.unit;
  return "";
}

std::vector<std::string> files_of(const std::vector<StudyEntry> &entries)
{
  std::vector<std::string> files;
  for (const std::string *path : paths_of(entries))
    files.push_back(*path);
  return files;
}

Study with_paths_from(const std::filesystem::path &folder, Study study)
{
  for (std::string *path : paths_of(study_entries(study)))
    *path = std::filesystem::relative(*path, folder).string();
  return study;
}

Json study_as_json(const std::vector<StudyEntry> &entries)
{
  Json sections;
  for (const StudyEntry &entry : entries)
    std::visit([&](const auto &value) { sections[entry.section][entry.name] = value; }, entry.value());
  return sections;
}

std::string study_as_prm(const Study &study)
{
  Study copy = study;
  const double hand = copy.motion.orbit.centre_of_mass_height + copy.motion.orbit.force_offset;
  if (std::abs(copy.motion.hand_height - hand) > 1e-12) // a study made in code sets the offset only
    copy.motion.hand_height = hand;
  return prm_text(entries_of(copy), false);
}

std::string commented_defaults(const std::string &section)
{
  std::vector<StudyEntry> entries = default_entries();
  const std::string sections = listed(sections_of(entries));
  const auto is_another = [&](const StudyEntry &entry) { return !boost::iequals(entry.section, section); };
  if (!section.empty())
    entries.erase(std::remove_if(entries.begin(), entries.end(), is_another), entries.end());
  ensure(!entries.empty(),
         "There is no section \"" + shortened(section) + "\"; give " + sections + ", or nothing for all.");
  const std::string head =
    "# A study of Stemware with every entry at its default. A study file needs to state only what differs.\n";
  return (section.empty() ? head : "") + prm_text(entries, true);
}

} // namespace stemware::pipeline
