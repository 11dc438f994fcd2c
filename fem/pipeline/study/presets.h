#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace stemware::pipeline
{

/// A glass or a table with a name: a study file of the entries that describe it, presets/*.prm
/// (docs/presets.md has their sources).
struct Preset
{
  std::string name;                     ///< "cork mat"
  std::string words;                    ///< what it is, as part of a sentence
  std::vector<std::string> other_names; ///< by which people may look for it
  std::string text;                     ///< its entries with their comments, as in a study file
};

/// The first one is that of the default study.
const std::vector<Preset> &glass_presets();
const std::vector<Preset> &table_presets();

std::vector<std::string> names_of(const std::vector<Preset> &presets);

/// The preset of that name; upper and lower case are equal, and so are blanks and hyphens. Throws BadInput
/// with the names that there are, and the one that may be meant; @p option is named as where it comes from.
const Preset &preset_of(const std::vector<Preset> &presets, const std::string &option,
                        const std::string &name);

/// A study file for that glass on that table: twelve entries with a comment each, and what else the presets
/// set. @p file is the name that the comment at its top tells to run.
std::string new_study_text(const Preset &glass, const Preset &table, const std::string &file);

/// Names of the studies that come with the program, sorted; none where they are not installed.
std::vector<std::string> cookbook_names();

/// A file that belongs to a study.
struct StudyPart
{
  std::filesystem::path file; ///< where it is to be written
  std::string text;
};

/// The study of that cookbook as the file @p file, first, and the files that it reads, which belong beside
/// it: the study names them so. Throws BadInput for a name that there is not, with those that there are, and
/// where the cookbooks are not installed, with the folders in which they would be.
std::vector<StudyPart> cookbook_parts(const std::string &name, const std::filesystem::path &file);

} // namespace stemware::pipeline
