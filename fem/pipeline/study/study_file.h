#pragma once

#include "fem/pipeline/study/study.h"
#include "fem/pipeline/study/study_entries.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace stemware::pipeline
{

/// Throws BadInput as check_values(), and for a study whose files are not there, or that would take more than
/// its limits allow.
void check_study(const Study &study);

/// Reads a study file (.prm or .json; entries that it does not state keep their defaults; an empty name: the
/// default study; "-": standard input of the first rank, as .json where it begins with a brace), applies @p
/// overrides, each "Section/Entry=value" of another entry, and checks the whole. Relative paths in the file
/// start at its folder, those of overrides where the program was started. Throws BadInput with one sentence
/// about the first thing that is wrong.
Study read_study(const std::string &file, const std::vector<std::string> &overrides = {});

/// Reads a study from @p text in the format of a .prm file, of a .json file where it begins with a brace;
/// @p origin names it in refusals. Relative paths start where the program was started. Throws as above.
Study read_study_text(const std::string &origin, const std::string &text);

/// Sets @p entries from @p text, the content of the study file @p file in the format of deal.II's parameter
/// files:
///
///   subsection Glass          # a comment
///     set Contact radius = 0.03
///   end
///
/// Sections may come in any order and more than once, an entry once; a line that ends in a backslash goes on
/// in the next one. Throws BadInput, with the line, about the first thing that is wrong.
void read_prm(const std::string &file, const std::string &text, const std::vector<StudyEntry> &entries);

/// Gives entries of @p study other values, each "Section/Entry" with its text, and checks the whole. Throws
/// BadInput that names @p option as where they come from.
Study with_values(Study study, const std::string &option,
                  const std::vector<std::pair<std::string, std::string>> &values);

/// The unit of the entry of that path, "1" for pure numbers; empty for words, paths, and where there is none.
std::string unit_of(const std::string &path);

/// The files that the study reads.
std::vector<std::string> files_of(const Study &study);

/// @p study with its paths as a study file in @p folder has to write them.
Study with_paths_from(const std::filesystem::path &folder, Study study);

/// Effective values as nested JSON objects: section, entry, value.
nlohmann::ordered_json study_as_json(const Study &study);

/// The study as a .prm file that gives the same study again.
std::string study_as_prm(const Study &study);

/// Text that two studies share if they are the same, wherever the program was started and keeps the state of
/// its solves.
std::string study_identity(Study study);

/// A .prm file of all defaults, every entry with its help, unit and allowed values as comments; that of one
/// section where @p section names one (upper and lower case are equal). Throws BadInput for other names.
std::string commented_defaults(const std::string &section = "");

} // namespace stemware::pipeline
