#pragma once

#include "fem/pipeline/app/options.h"

namespace stemware::pipeline
{

/// What `mesh` is told.
struct MeshOptions
{
  StudyOptions study;              ///< study_file and output may be empty
  std::string check;               ///< a mesh file to look at; empty: the study's own mesh
  std::vector<std::string> writes; ///< files to write, .msh or .vtu
};

/// Looks at a foot mesh, of a study or of a file, says what it finds, and writes it; with --output also a
/// folder with a report. Throws BadInput for a mesh that cannot be used, OutputFailure.
void mesh(const MeshOptions &options);

} // namespace stemware::pipeline
