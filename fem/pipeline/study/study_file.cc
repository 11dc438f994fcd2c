#include "fem/pipeline/study/study_file.h"

#include "fem/pipeline/study/study_entries.h"
#include "fem/pipeline/support/failures.h"
#include "fem/pipeline/support/spelling.h"

#include <deal.II/base/parameter_handler.h>

#include <boost/algorithm/string/trim.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>

namespace stemware::pipeline
{

using dealii::ParameterHandler;

namespace
{

/// A deal.II pattern that asks a StudyEntry, and describes itself in words.
class EntryPattern : public dealii::Patterns::PatternBase
{
public:
  explicit EntryPattern(const StudyEntry &entry)
      : entry(entry)
  {
  }

  bool match(const std::string &text) const override { return entry.is_allowed(text); }
  std::string description(const OutputStyle) const override { return entry.allowed; }
  std::unique_ptr<PatternBase> clone() const override { return std::make_unique<EntryPattern>(entry); }

private:
  const StudyEntry entry;
};

/// Declares the entries with their present values as defaults. Defaults are passed as text of full length:
/// add_parameter() would round the variables behind them to six digits (deal.II 9.4.1).
void declare(const std::vector<StudyEntry> &entries, ParameterHandler &handler)
{
  for (const StudyEntry &entry : entries)
  {
    handler.enter_subsection(entry.section);
    handler.declare_entry(entry.name, entry.text(), EntryPattern(entry),
                          entry.help + ". Allowed: " + entry.allowed + ".");
    handler.add_action(entry.name, entry.assign);
    handler.leave_subsection();
  }
}

/// Section/name of the entry of that name; names are unique.
std::string path_of(const std::vector<StudyEntry> &entries, const std::string &name)
{
  for (const StudyEntry &entry : entries)
    if (entry.name == name)
      return entry.path();
  return name;
}

/// "; did you mean Glass/Contact radius?" for the likeliest entry; the word may be an entry's name or path,
/// or a section's name.
std::string suggestion(const std::vector<StudyEntry> &entries, const std::string &word)
{
  std::vector<std::string> names, paths;
  for (const StudyEntry &entry : entries)
  {
    names.push_back(entry.name);
    paths.push_back(entry.path());
  }
  std::optional<std::string> meant = likeliest(word, paths);
  if (const auto name = likeliest(word, names); name && !meant)
    meant = path_of(entries, *name);
  return meant ? "; did you mean " + *meant + "? (`stemware defaults` lists what there is.)"
               : "; `stemware defaults` lists what there is.";
}

/// What stands between the pieces of @p text, which begins with the first piece and holds the others in this
/// order; an empty last piece is the end of the text. Nothing for other texts.
std::optional<std::vector<std::string>> between(const std::string &text,
                                                const std::vector<std::string> &pieces)
{
  if (text.compare(0, pieces.front().size(), pieces.front()) != 0)
    return std::nullopt;
  std::vector<std::string> parts;
  std::size_t begin = pieces.front().size();
  for (std::size_t i = 1; i < pieces.size(); ++i)
  {
    const std::size_t end = pieces[i].empty() ? text.size() : text.find(pieces[i], begin);
    if (end == std::string::npos)
      return std::nullopt;
    parts.push_back(boost::trim_copy(text.substr(begin, end - begin)));
    begin = end + pieces[i].size();
  }
  return parts;
}

std::string not_allowed(const std::string &path, const std::string &value, const std::string &allowed)
{
  return path + " = " + (value.empty() ? "(nothing)" : value) + " is not allowed; give " + allowed + ".";
}

/// deal.II's messages of several lines as one sentence in the words of study files.
std::string condensed(const dealii::ExceptionBase &exception, const std::string &file,
                      const std::vector<StudyEntry> &entries)
{
  std::ostringstream information;
  exception.print_info(information);
  std::string text = on_one_line(information.str());
  std::string where = file + ": ";
  // Between the file and the colon there is a >, or nothing where a subsection is unknown (deal.II 9.4.1).
  if (const auto parts = between(text, { "Line <", "> of file <" + on_one_line(file), ": ", "" }))
  {
    where = file + ", line " + parts->at(0) + ": ";
    text = parts->at(2);
  }
  if (const auto parts =
        between(text, { "The entry value", "for the entry named", "does not match the given pattern:", "" }))
    return where + not_allowed(path_of(entries, parts->at(1)), parts->at(0), parts->at(2));
  if (const auto parts =
        between(text, { "No entry with name <", "> was declared in the current subsection." }))
    return where + "there is no entry \"" + parts->at(0) + "\" in this subsection" +
           suggestion(entries, parts->at(0));
  if (const auto parts = between(text, { "There is no such subsection to be entered: ", "" }))
    return where + "there is no subsection \"" + parts->at(0) +
           "\"; use Motion, Glass, Table, Contact or Load.";
  if (const auto parts = between(text, { "The line <", "> could not be parsed" }))
    return where + "\"" + parts->at(0) +
           "\" is not a line of a study file; write subsection NAME, set ENTRY = VALUE, or end.";
  if (between(text, { "Invalid format of 'set'" }))
    return where + "a line that begins with set has no = ; write set ENTRY = VALUE.";
  if (between(text, { "There is no subsection to leave here." }))
    return where + "an \"end\" has no \"subsection\" above it; write one \"end\" for each \"subsection\".";
  if (between(text, { "There are unequal numbers of 'subsection' and 'end' statements" }))
    return where + "a subsection is not closed; write one \"end\" for each \"subsection\".";
  return where + text;
}

/// The whole file, once it is known to be one that can be read.
std::string contents(const std::string &file)
{
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  require(
    std::filesystem::exists(status),
    "The study file " + file +
      " does not exist; give the path of a .prm file, or write one with `stemware defaults > study.prm`.");
  require(std::filesystem::is_regular_file(status),
          "The study file " + file + " is not a file; give the path of a .prm file.");
  const std::string extension = std::filesystem::path(file).extension();
  require(extension == ".prm" || extension == ".json",
          "The study file " + file +
            " ends in neither .prm nor .json; rename it so that its format is clear.");
  std::ifstream stream(file);
  std::ostringstream text;
  text << stream.rdbuf();
  require(stream.good() || stream.eof(),
          "The study file " + file + " cannot be read; check its permissions.");
  std::string all = text.str();
  const auto is_control = [](unsigned char letter) { return letter < ' ' && !std::isspace(letter); };
  require(std::none_of(all.begin(), all.end(), is_control),
          "The study file " + file + " is not a text file; give the path of a .prm or .json file.");
  require(
    all.find_first_not_of(" \t\r\n") != std::string::npos,
    "The study file " + file +
      " is empty; write at least a comment into it to get the defaults, or start from `stemware defaults`.");
  return all;
}

const StudyEntry &entry_at(const std::vector<StudyEntry> &entries, const std::string &origin,
                           const std::string &path)
{
  const auto entry = std::find_if(entries.begin(), entries.end(),
                                  [&](const StudyEntry &candidate) { return candidate.path() == path; });
  require(entry != entries.end(),
          origin + ": there is no entry \"" + path + "\"" + suggestion(entries, path));
  return *entry;
}

/// Sets one entry from the command line or from a JSON file.
void assign(const std::vector<StudyEntry> &entries, const std::string &origin, const std::string &path,
            const std::string &value)
{
  const StudyEntry &entry = entry_at(entries, origin, path);
  require(entry.is_allowed(value), origin + ": " + not_allowed(entry.path(), value, entry.allowed));
  entry.assign(value);
}

/// Sets the entries of one section of a JSON file.
void read_section(const std::string &file, const std::string &section, const nlohmann::ordered_json &values,
                  const std::vector<StudyEntry> &entries)
{
  require(values.is_object(), file + ": \"" + section + "\" is not an object of entries; write {\"" +
                                section + "\": {\"Entry\": value}}.");
  const std::string prefix = section + '/';
  for (const auto &[name, value] : values.items())
    assign(entries, file, prefix + name, value.is_string() ? value.get<std::string>() : value.dump());
}

void read_json(const std::string &file, const std::string &text, const std::vector<StudyEntry> &entries)
{
  const auto sections = nlohmann::ordered_json::parse(text, nullptr, false);
  require(sections.is_object(),
          file + " is not a JSON object; write {\"Glass\": {\"Contact radius\": 0.03}, ...}.");
  for (const auto &[section, values] : sections.items())
    read_section(file, section, values, entries);
}

void read_prm(const std::string &file, const std::vector<StudyEntry> &entries)
{
  ParameterHandler handler;
  declare(entries, handler);
  try
  {
    handler.parse_input(file);
  }
  catch (const dealii::ExceptionBase &exception)
  {
    throw BadInput(condensed(exception, file, entries));
  }
}

void apply(const std::string &override_text, const std::vector<StudyEntry> &entries)
{
  const auto equal_sign = override_text.find('=');
  require(equal_sign != std::string::npos && override_text.find('/') < equal_sign,
          "--set \"" + override_text + "\" is not an assignment; write --set \"Section/Entry=value\".");
  const std::string path = boost::trim_copy(override_text.substr(0, equal_sign));
  assign(entries, "--set", path, boost::trim_copy(override_text.substr(equal_sign + 1)));
}

/// The entries that name files.
std::vector<std::string *> paths_of(Study &study)
{
  return { &study.contact.mesh_file, &study.load.file };
}

} // namespace

Study read_study(const std::string &file, const std::vector<std::string> &overrides)
{
  const std::string text = contents(file);
  Study study;
  const std::vector<StudyEntry> entries = study_entries(study);
  if (std::filesystem::path(file).extension() == ".json")
    read_json(file, text, entries);
  else
    read_prm(file, entries);
  for (std::string *path : paths_of(study))
    if (!path->empty())
      *path = (std::filesystem::path(file).parent_path() / *path).lexically_normal().string();
  for (const std::string &override_text : overrides)
    apply(override_text, entries);
  check_study(study);
  return study;
}

Study with_values(Study study, const std::string &option,
                  const std::vector<std::pair<std::string, std::string>> &values)
{
  const std::vector<StudyEntry> entries = study_entries(study);
  for (const auto &[path, value] : values)
    assign(entries, option, path, value);
  check_study(study);
  return study;
}

StudyEntry find_entry(const std::string &option, const std::string &path)
{
  Study study;
  return entry_at(study_entries(study), option, path);
}

std::vector<std::string> files_of(const Study &study)
{
  Study copy = study;
  std::vector<std::string> files;
  for (const std::string *path : paths_of(copy))
    if (!path->empty())
      files.push_back(*path);
  return files;
}

Study with_paths_from(const std::filesystem::path &folder, Study study)
{
  for (std::string *path : paths_of(study))
    if (!path->empty())
      *path = std::filesystem::relative(*path, folder).string();
  return study;
}

std::string study_as_prm(const Study &study)
{
  Study copy = study;
  ParameterHandler handler;
  declare(study_entries(copy), handler);
  std::ostringstream text;
  handler.print_parameters(text, ParameterHandler::ShortPRM | ParameterHandler::KeepDeclarationOrder);
  return text.str();
}

std::string commented_defaults()
{
  Study study;
  ParameterHandler handler;
  declare(study_entries(study), handler);
  std::ostringstream text;
  text << "# A study of Stemware with every entry at its default. A study file needs to state only what "
          "differs.\n";
  handler.print_parameters(text, ParameterHandler::PRM | ParameterHandler::KeepDeclarationOrder);
  return text.str();
}

} // namespace stemware::pipeline
