#pragma once

#include "fem/pipeline/base/json.h"
#include "fem/pipeline/study/study.h"
#include "fem/pipeline/study/study_entries.h"

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace stemware::pipeline
{

/// Throws BadInput as Study::check_values(), and for missing files or a study that exceeds its limits.
void check_study(const Study &study);

/// Reads a study file, applies @p overrides ("Section/Entry=value", each for another entry) and checks the
/// result, but not overridden values of the file. @p file: .prm or .json; empty: default study; "-": standard
/// input of the first rank, JSON if it begins with a brace. Missing entries have their defaults. Paths in the
/// file are relative to its folder, in overrides to the working directory. Throws BadInput.
Study read_study(const std::string &file, const std::vector<std::string> &overrides = {});

/// Reads a study from @p text, .json if it begins with a brace, else .prm; @p origin names it in messages.
/// Paths are relative to the working directory. Throws as read_study().
Study read_study_text(const std::string &origin, const std::string &text);

/// Sets @p entries from @p text, the content of the study file @p file (deal.II's parameter format):
///
///   subsection Glass          # a comment
///     set Contact radius = 0.03
///   end
///
/// Sections may come in any order and repeatedly, an entry once; a backslash at the end of a line continues
/// it. Throws BadInput, with the line, about the first error.
void read_prm(const std::string &file, const std::string &text, const std::vector<StudyEntry> &entries);

/// Returns @p study with other @p values ("Section/Entry", text), checked. Throws BadInput, naming @p option.
Study with_values(Study study, const std::string &option,
                  const std::vector<std::pair<std::string, std::string>> &values);

/// Returns the unit of the entry of @p path: "1" for pure numbers; empty for words, paths, unknown entries.
std::string unit_of(const std::string &path);

/// Returns the files that a study with these @p entries reads.
std::vector<std::string> files_of(const std::vector<StudyEntry> &entries);

/// Returns @p study with its paths relative to a study file in @p folder.
Study with_paths_from(const std::filesystem::path &folder, Study study);

/// Returns the values of @p entries as nested JSON objects: section, entry, value.
Json study_as_json(const std::vector<StudyEntry> &entries);

/// Returns the study as a .prm file.
std::string study_as_prm(const Study &study);

/// Returns the defaults, or those of one @p section (ignoring case), as a .prm file with help, unit and
/// allowed values as comments. Throws BadInput for an unknown section.
std::string commented_defaults(const std::string &section = "");

} // namespace stemware::pipeline
