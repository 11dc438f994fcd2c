#pragma once

#include "fem/pipeline/study.h"

#include <filesystem>
#include <string>
#include <vector>

namespace stemware::pipeline
{

/// Reads a study file (.prm or .json; entries that it does not state keep their defaults), applies @p
/// overrides, each "Section/Entry=value", and checks the whole. Relative paths in the file start at its
/// folder, those of overrides where the program was started. Throws BadInput with one sentence about the
/// first thing that is wrong.
Study read_study(const std::string &file, const std::vector<std::string> &overrides = {});

/// The same study with its paths as a study file in @p folder has to write them.
Study with_paths_from(const std::filesystem::path &folder, Study study);

/// The study as a .prm file that gives the same study again.
std::string study_as_prm(const Study &study);

/// A .prm file of all defaults, every entry with its help, unit and allowed values as comments.
std::string commented_defaults();

} // namespace stemware::pipeline
