#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace stemware::pipeline
{

/// Named glass or table: a study file with its entries, presets/*.prm (docs/presets.md has the sources).
struct Preset
{
  std::string name;                     ///< "cork mat"
  std::string words;                    ///< description, as part of a sentence
  std::vector<std::string> other_names; ///< synonyms
  std::string text;                     ///< its entries with their comments, as in a study file
};

/// Returns the presets; the first is the default study's.
const std::vector<Preset> &glass_presets();
const std::vector<Preset> &table_presets();

/// Returns the preset @p name, ignoring case and treating blanks and hyphens as equal. Throws BadInput with
/// the available names and the most similar one; @p option is named as the origin.
const Preset &preset_of(const std::vector<Preset> &presets, const std::string &option,
                        const std::string &name);

/// Returns a study file for @p glass on @p table: twelve entries with a comment each, and further entries of
/// the presets. @p file: file name in the command shown at the top.
std::string new_study_text(const Preset &glass, const Preset &table, const std::string &file);

/// Returns the names of the installed example studies, sorted; empty if they are not installed.
std::vector<std::string> cookbook_names();

/// A file that belongs to a study.
struct StudyPart
{
  std::filesystem::path file; ///< destination
  std::string text;
};

/// Returns the study of a cookbook as @p file, followed by the files that it reads, next to @p file. Throws
/// BadInput for an unknown name (with the available ones), and if the cookbooks are not installed (with the
/// searched folders).
std::vector<StudyPart> cookbook_parts(const std::string &name, const std::filesystem::path &file);

} // namespace stemware::pipeline
