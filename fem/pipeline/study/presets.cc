#include "fem/pipeline/study/presets.h"

#include "fem/pipeline/support/failures.h"
#include "fem/pipeline/support/text.h"

#include <boost/algorithm/string/case_conv.hpp>
#include <boost/algorithm/string/predicate.hpp>

#include <algorithm>
#include <fmt/format.h>
#include <optional>
#include <set>

namespace stemware::pipeline
{

namespace
{

using Entries = std::vector<std::pair<std::string, std::string>>;

/// The entries that a new study comments, in the order of its file: twelve, since a table has either a
/// foundation or a disc modulus. Each preset of a glass has those of Motion and Glass but the friction, each
/// of a table the friction and those of Table that it knows.
const Entries explained = {
  { "Motion/Mass", "Mass of the glass with what is in it" },
  { "Motion/Centre of mass height", "Height of its centre of mass above the table" },
  { "Motion/Force offset",
    "Height of the hand minus that of the centre of mass; negative: the hand is lower" },
  { "Motion/Orbit radius", "Radius of the circle on which the hand leads the glass" },
  { "Motion/Orbit speed", "Speed along that circle" },
  { "Motion/Friction coefficient", "Coulomb friction between foot and table" },
  { "Glass/Contact radius", "Radius of the rim of the foot, where it stands on the table" },
  { "Glass/Foot radius", "Outer radius of the foot" },
  { "Glass/Foot thickness", "Thickness of the foot where it meets the stem" },
  { "Glass/Crown radius", "Radius of the rim's rounding, seen in a cut through the axis" },
  { "Table/Interface",
    "hard: smooth; rough: with asperities; Winkler: a mat of springs that do not know each other" },
  { "Table/Foundation modulus", "Pressure of the mat per depth of penetration" },
  { "Table/Disc Young modulus", "Young's modulus of the table or layer" },
};

Entries joined(Entries entries, const Entries &more)
{
  entries.insert(entries.end(), more.begin(), more.end());
  return entries;
}

std::string section_of(const std::string &path)
{
  return path.substr(0, path.find('/'));
}

/// The entries as subsections; those of @p comments have their comment above.
std::string sections_text(const Entries &entries, const Entries &comments)
{
  std::size_t width = 0;
  for (const auto &[path, value] : entries)
    width = std::max(width, path.size() - section_of(path).size() - 1);
  std::string text, section;
  for (const auto &[path, value] : entries)
  {
    if (section_of(path) != section)
    {
      text += (section.empty() ? "" : "end\n\n") + ("subsection " + section_of(path)) + '\n';
      section = section_of(path);
    }
    for (const auto &[commented, comment] : comments)
      if (commented == path)
        text += "  # " + comment + '\n';
    text += fmt::format(FMT_STRING("  set {:<{}} = {}\n"), path.substr(section.size() + 1), width, value);
  }
  return text + "end\n";
}

/// What people call a glass or a table, and the preset that comes nearest.
const Entries other_names = {
  { "goblet", "wine glass" },    { "red wine", "Bordeaux" },
  { "flute", "champagne" },      { "sparkling", "champagne" },
  { "whisky", "tumbler" },       { "water glass", "tumbler" },
  { "lead crystal", "crystal" }, { "wood", "oak" },
  { "hardwood", "oak" },         { "table", "oak" },
  { "stone", "marble" },         { "granite", "marble" },
  { "metal", "steel" },          { "pane", "window glass" },
  { "felt", "tablecloth" },      { "cloth", "tablecloth" },
  { "cotton", "tablecloth" },    { "fabric", "tablecloth" },
};

/// A name as it is compared.
std::string plain(const std::string &name)
{
  std::string text = boost::to_lower_copy(name);
  std::replace_if(
    text.begin(), text.end(), [](char letter) { return letter == '-' || letter == '_'; }, ' ');
  return text;
}

/// The one of @p names that somebody may mean by @p word: by another name, by a part of its name, or
/// misspelt.
std::optional<std::string> meant_by(const std::string &word, const std::vector<std::string> &names)
{
  const std::string wanted = plain(word);
  for (const auto &[other, name] : other_names)
    if (plain(other) == wanted && std::find(names.begin(), names.end(), name) != names.end())
      return name;
  for (const std::string &name : names)
    if (wanted.size() > 2 && plain(name).find(wanted) != std::string::npos)
      return name;
  return likeliest(wanted, names);
}

} // namespace

const std::vector<Preset> &glass_presets()
{
  static const std::vector<Preset> presets = {
    { "wine glass",
      "the wine glass of the default study",
      { { "Motion/Mass", "300 g" },
        { "Motion/Centre of mass height", "80 mm" },
        { "Motion/Force offset", "-50 mm" },
        { "Motion/Orbit radius", "15 cm" },
        { "Motion/Orbit speed", "35 cm/s" },
        { "Glass/Contact radius", "30 mm" },
        { "Glass/Foot radius", "34 mm" },
        { "Glass/Foot thickness", "4 mm" },
        { "Glass/Crown radius", "3 mm" } } },
    { "Bordeaux",
      "a large red wine glass with 150 ml of wine",
      { { "Motion/Mass", "330 g" },
        { "Motion/Centre of mass height", "120 mm" },
        { "Motion/Force offset", "-80 mm" },
        { "Motion/Orbit radius", "15 cm" },
        { "Motion/Orbit speed", "35 cm/s" },
        { "Glass/Contact radius", "36 mm" },
        { "Glass/Foot radius", "40 mm" },
        { "Glass/Foot thickness", "4 mm" },
        { "Glass/Crown radius", "3 mm" },
        { "Motion/Yaw inertia", "2500 g cm^2" },
        { "Glass/Stem radius", "4 mm" } } },
    { "champagne",
      "a champagne flute with 120 ml",
      { { "Motion/Mass", "250 g" },
        { "Motion/Centre of mass height", "130 mm" },
        { "Motion/Force offset", "-90 mm" },
        { "Motion/Orbit radius", "15 cm" },
        { "Motion/Orbit speed", "35 cm/s" },
        { "Glass/Contact radius", "29 mm" },
        { "Glass/Foot radius", "33 mm" },
        { "Glass/Foot thickness", "3.5 mm" },
        { "Glass/Crown radius", "3 mm" },
        { "Motion/Yaw inertia", "650 g cm^2" },
        { "Glass/Stem radius", "4 mm" } } },
    { "tumbler",
      "a tumbler without a stem, with 150 ml",
      { { "Motion/Mass", "400 g" },
        { "Motion/Centre of mass height", "45 mm" },
        { "Motion/Force offset", "-20 mm" },
        { "Motion/Orbit radius", "15 cm" },
        { "Motion/Orbit speed", "35 cm/s" },
        { "Glass/Contact radius", "32 mm" },
        { "Glass/Foot radius", "36 mm" },
        { "Glass/Foot thickness", "8 mm" },
        { "Glass/Crown radius", "3 mm" },
        { "Motion/Yaw inertia", "4000 g cm^2" },
        { "Glass/Shape", "step" },
        { "Glass/Land width", "3 mm" },
        { "Glass/Stem radius", "25 mm" } } },
    { "crystal",
      "a heavy goblet of lead crystal with 130 ml of wine",
      { { "Motion/Mass", "450 g" },
        { "Motion/Centre of mass height", "95 mm" },
        { "Motion/Force offset", "-55 mm" },
        { "Motion/Orbit radius", "15 cm" },
        { "Motion/Orbit speed", "35 cm/s" },
        { "Glass/Contact radius", "33 mm" },
        { "Glass/Foot radius", "37 mm" },
        { "Glass/Foot thickness", "5 mm" },
        { "Glass/Crown radius", "3 mm" },
        { "Motion/Yaw inertia", "4500 g cm^2" },
        { "Glass/Edge thickness", "2 mm" },
        { "Glass/Stem radius", "6 mm" },
        { "Glass/Young modulus", "60 GPa" } } },
  };
  return presets;
}

const std::vector<Preset> &table_presets()
{
  const auto bare = [](const std::string &name, const std::string &words, const std::string &friction,
                       const std::string &interface, const std::string &modulus, const std::string &poisson,
                       const std::string &thickness, const Entries &more = {})
  {
    return Preset{ name, words,
                   joined({ { "Motion/Friction coefficient", friction },
                            { "Table/Interface", interface },
                            { "Table/Disc Young modulus", modulus },
                            { "Table/Substrate", "elastic" },
                            { "Table/Disc Poisson ratio", poisson },
                            { "Table/Disc thickness", thickness } },
                          more) };
  };
  const auto asperities = [](const std::string &pressure, const std::string &length) {
    return Entries{ { "Table/Reference pressure", pressure }, { "Table/Decay length", length } };
  };
  static const std::vector<Preset> presets = {
    { "mat",
      "the stiff mat of the default study",
      { { "Motion/Friction coefficient", "0.3" },
        { "Table/Interface", "Winkler" },
        { "Table/Foundation modulus", "10 GPa/m" } } },
    bare("oak", "a table top of planed oak, 30 mm thick", "0.3", "rough", "2 GPa", "0.3", "30 mm",
         asperities("0.2 GPa", "1 um")),
    bare("marble", "a polished marble top, 20 mm thick", "0.25", "rough", "55 GPa", "0.25", "20 mm",
         asperities("5 GPa", "0.3 um")),
    bare("steel", "a steel plate, 5 mm thick", "0.25", "rough", "210 GPa", "0.3", "5 mm",
         asperities("7 GPa", "0.5 um")),
    bare("window glass", "a pane of float glass, 6 mm thick", "0.3", "hard", "70 GPa", "0.2", "6 mm"),
    bare("cork mat", "a mat of agglomerated cork, 5 mm thick", "0.4", "hard", "17 MPa", "0", "5 mm"),
    bare("tablecloth", "a cotton tablecloth, 0.5 mm thick", "0.35", "hard", "1 MPa", "0", "0.5 mm"),
  };
  return presets;
}

const Preset &preset_of(const std::vector<Preset> &presets, const std::string &option,
                        const std::string &name)
{
  std::vector<std::string> names;
  for (const Preset &preset : presets)
  {
    if (plain(preset.name) == plain(name))
      return preset;
    names.push_back(preset.name);
  }
  std::string all;
  for (const std::string &known : names)
    all += (known == names.front() ? "" : known == names.back() ? " or " : ", ") + known;
  const std::optional<std::string> meant = meant_by(name, names);
  throw BadInput(fmt::format(FMT_STRING("{} \"{}\" is not known; {}give one of {}."), option, shortened(name),
                             meant ? "did you mean \"" + *meant + "\"? Else " : "", all));
}

std::string new_study_text(const Preset &glass, const Preset &table, const std::string &file)
{
  const Entries all = joined(glass.entries, table.entries);
  Entries first, rest;
  for (const auto &[path, comment] : explained)
    for (const auto &entry : all)
      if (entry.first == path)
        first.push_back(entry);
  for (const char *section : { "Motion", "Glass", "Table" })
    for (const auto &entry : all)
      if (section_of(entry.first) == section && std::find(first.begin(), first.end(), entry) == first.end())
        rest.push_back(entry);
  std::string text = fmt::format(
    FMT_STRING(
      "# {}: {},\n# on {}: {}.\n#\n#   stemware run {}\n#\n"
      "# Change what differs. Units as you like: 300 g, 30 mm, 70 GPa, 20 cm/s, 5 deg; a number alone is\n"
      "# in SI units. `stemware defaults` lists all other entries.\n\n"),
    glass.name, glass.words, table.name, table.words, file);
  text += sections_text(first, explained);
  if (!rest.empty())
    text += "\n# What else belongs to this glass and this table.\n\n" + sections_text(rest, {});
  return text;
}

} // namespace stemware::pipeline
