#include "fem/pipeline/study/presets.h"

#include "fem/pipeline/base/failures.h"
#include "fem/pipeline/base/text.h"
#include "fem/pipeline/base/text_file.h"
#include "fem/pipeline/study/study_file.h"

#include <boost/algorithm/string/case_conv.hpp>
#include <boost/algorithm/string/join.hpp>
#include <boost/algorithm/string/replace.hpp>
#include <boost/algorithm/string/split.hpp>
#include <boost/algorithm/string/trim.hpp>

#include <algorithm>
#include <fmt/format.h>
#include <optional>
#include <sstream>

namespace stemware::pipeline
{

/// Returns the files presets/*.prm, which are compiled into the program (listed in CMakeLists.txt).
const CompiledTexts &glass_texts();
const CompiledTexts &table_texts();

namespace fs = std::filesystem;

namespace
{

/// Returns the preset in a file that starts with "# NAME: WORDS", optionally "# Also called: NAME, NAME".
Preset preset_in(const std::string &text)
{
  Preset preset;
  std::istringstream lines(text);
  std::string others;
  lines.ignore(2);
  std::getline(lines, preset.name, ':');
  std::getline(lines >> std::ws, preset.words);
  if (std::getline(lines, others); !others.empty())
    boost::split(preset.other_names, others.substr(others.find(':') + 1), [](char c) { return c == ','; });
  preset.text = text.substr(text.find("\nsubsection ") + 1);
  return preset;
}

std::vector<Preset> presets_in(const CompiledTexts &texts)
{
  std::vector<Preset> presets;
  for (const auto &[file, text] : texts)
    presets.push_back(preset_in(text));
  return presets;
}

std::string plain(std::string name)
{
  std::replace_if(
    name.begin(), name.end(), [](char letter) { return letter == '-' || letter == '_'; }, ' ');
  return boost::trim_copy(boost::to_lower_copy(name));
}

std::vector<std::string> names_of(const std::vector<Preset> &presets)
{
  std::vector<std::string> names;
  for (const Preset &preset : presets)
    names.push_back(preset.name);
  return names;
}

std::optional<std::string> suggestion_for(const std::string &word, const std::vector<Preset> &presets)
{
  const std::string wanted = plain(word);
  for (const Preset &preset : presets)
    for (const std::string &other : preset.other_names)
      if (plain(other) == wanted)
        return preset.name;
  const std::vector<std::string> names = names_of(presets);
  for (const std::string &name : names)
    if (wanted.size() > 2 && plain(name).find(wanted) != std::string::npos)
      return name;
  return closest_match(wanted, names);
}

fs::path cookbook_folder()
{
  std::error_code error;
  for (const fs::path &shared : shared_folders())
    if (fs::is_directory(shared / "cookbooks", error))
      return shared / "cookbooks";
  return {};
}

} // namespace

const std::vector<Preset> &glass_presets()
{
  static const std::vector<Preset> presets = presets_in(glass_texts());
  return presets;
}

const std::vector<Preset> &table_presets()
{
  static const std::vector<Preset> presets = presets_in(table_texts());
  return presets;
}

const Preset &preset_of(const std::vector<Preset> &presets, const std::string &option,
                        const std::string &name)
{
  for (const Preset &preset : presets)
    if (plain(preset.name) == plain(name))
      return preset;
  const std::optional<std::string> meant = suggestion_for(name, presets);
  throw BadInput(fmt::format(FMT_STRING("{} \"{}\" is not known; {}give one of {}."), option, shortened(name),
                             meant ? "did you mean \"" + *meant + "\"? Else " : "",
                             listed(names_of(presets))));
}

std::string new_study_text(const Preset &glass, const Preset &table, const std::string &file)
{
  return fmt::format(
    FMT_STRING(
      "# {}: {},\n# on {}: {}.\n#\n#   stemware run {}\n#\n"
      "# Change what differs. Units as you like: 300 g, 30 mm, 70 GPa, 20 cm/s, 5 deg; a number alone is\n"
      "# in SI units. `stemware defaults` lists all other entries.\n\n{}\n{}"),
    glass.name, glass.words, table.name, table.words, file, glass.text, table.text);
}

std::vector<std::string> cookbook_names()
{
  std::vector<std::string> names;
  if (const fs::path folder = cookbook_folder(); !folder.empty())
    for (const auto &item : fs::directory_iterator(folder))
      if (item.path().extension() == ".prm")
        names.push_back(item.path().stem());
  std::sort(names.begin(), names.end());
  return names;
}

std::vector<std::pair<fs::path, std::string>> cookbook_parts(const std::string &name, const fs::path &file)
{
  const fs::path folder = cookbook_folder();
  std::string places;
  for (const fs::path &shared : shared_folders())
    places += (places.empty() ? "" : " nor ") + (shared / "cookbooks").string();
  ensure(!folder.empty(),
         "The cookbooks are not installed with this program: there is neither " + places + ".");
  const std::vector<std::string> names = cookbook_names();
  const auto meant = closest_match(name, names);
  ensure(std::find(names.begin(), names.end(), name) != names.end(),
         "\"" + shortened(name) + "\" is no cookbook" +
           (meant ? "; did you mean " + *meant + "? There are " : "; there are ") +
           boost::algorithm::join(names, ", ") + ".");

  const fs::path study = folder / (name + ".prm");
  std::vector<std::pair<fs::path, std::string>> parts = { { file, read_text_file(study) } };
  std::string &text = parts.front().second;
  boost::replace_all(text, "docs/cookbooks/" + name + ".prm", file.filename().string());
  for (const std::string &name_of_file : files_of(entries_of(read_study(study))))
  {
    const fs::path read = name_of_file;
    require_regular_file("The file " + read.string() + " of the cookbook " + name, read);
    boost::replace_all(text, read.lexically_relative(folder).string(), read.filename().string());
    parts.emplace_back(file.parent_path() / read.filename(), read_text_file(read));
  }
  return parts;
}

} // namespace stemware::pipeline
