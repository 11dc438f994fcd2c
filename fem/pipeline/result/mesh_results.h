#pragma once

#include "fem/geometry/boundary_ids.h"
#include "fem/geometry/mesh_io.h"
#include "fem/geometry/mesh_quality.h"
#include "fem/pipeline/analysis/quantity.h"

#include <optional>
#include <string>

namespace stemware::pipeline
{

/// Checked mesh.
struct MeshFindings
{
  std::string origin; ///< its file, or "generated"
  fem::MeshCheck check;
  std::optional<fem::MeshReport> report; ///< report on a mesh file
};

/// Returns the description of a mesh and of its weaknesses, in lines for the console.
std::string mesh_text(const MeshFindings &findings);

/// Returns the machine-readable description, in SI units.
Json mesh_summary(const MeshFindings &findings);

} // namespace stemware::pipeline
