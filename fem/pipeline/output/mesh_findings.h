#pragma once

#include "fem/geometry/foot_mesh.h"
#include "fem/geometry/mesh_quality.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <vector>

namespace stemware::pipeline
{

/// A mesh that has been looked at.
struct MeshFindings
{
  std::string origin; ///< its file, or "generated from Glass"
  fem::MeshCheck check;
  std::optional<fem::MeshReport> report; ///< of a file
};

/// What was found, in lines for people.
std::string mesh_text(const MeshFindings &findings);

/// The same for programs, lengths in m.
nlohmann::ordered_json mesh_json(const MeshFindings &findings);

/// What may make results worse, one sentence each.
std::vector<std::string> mesh_remarks(const MeshFindings &findings);

} // namespace stemware::pipeline
