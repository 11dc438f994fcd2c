#pragma once

#include "fem/geometry/boundary_ids.h"
#include "fem/geometry/mesh_io.h"
#include "fem/geometry/mesh_quality.h"
#include "fem/pipeline/document/json.h"

#include <optional>
#include <string>

namespace stemware::pipeline
{

/// A mesh that has been looked at.
struct MeshFindings
{
  std::string origin; ///< its file, or "generated"
  fem::MeshCheck check;
  std::optional<fem::MeshReport> report; ///< of a file
};

/// Description of a mesh and of what may make results worse, in lines for the console.
std::string mesh_text(const MeshFindings &findings);

/// The same for programs, in SI units.
nlohmann::ordered_json mesh_summary(const MeshFindings &findings);

} // namespace stemware::pipeline
