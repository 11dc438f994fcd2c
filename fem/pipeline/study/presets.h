#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace stemware::pipeline
{

/// Named glass or table: presets/*.prm, a study file of its entries (sources: docs/presets.md).
struct Preset
{
  std::string name;                     ///< "cork mat"
  std::string words;                    ///< description, as part of a sentence
  std::vector<std::string> other_names; ///< synonyms
  std::string text;                     ///< entries with comments, as in a study file
};

/// Returns the presets; the first is the default study's.
const std::vector<Preset> &glass_presets();
const std::vector<Preset> &table_presets();

/// Returns the preset @p name, ignoring case and treating blanks and hyphens as equal. Throws BadInput, with
/// @p option as the origin, the available names and the most similar one.
const Preset &preset_of(const std::vector<Preset> &presets, const std::string &option,
                        const std::string &name);

/// Returns a study file for @p glass on @p table: twelve entries with comments, and further entries of the
/// presets. @p file: name of the study file in the command at its top.
std::string new_study_text(const Preset &glass, const Preset &table, const std::string &file);

/// Returns the names of the installed example studies, sorted; empty if they are not installed.
std::vector<std::string> cookbook_names();

/// Returns destination and text of the study of a cookbook, written as @p file, then of the files it reads,
/// in the folder of @p file. Throws BadInput for an unknown name, with all names, or without installed
/// cookbooks, with the searched folders.
std::vector<std::pair<std::filesystem::path, std::string>> cookbook_parts(const std::string &name,
                                                                          const std::filesystem::path &file);

} // namespace stemware::pipeline
