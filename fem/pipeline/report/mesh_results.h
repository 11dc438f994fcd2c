#pragma once

#include "fem/geometry/foot_mesh.h"
#include "fem/geometry/mesh_quality.h"
#include "fem/geometry/section_view.h"
#include "fem/pipeline/report/results.h"

#include <optional>
#include <string>
#include <vector>

namespace stemware::pipeline
{

/// A mesh that has been looked at.
struct MeshFindings
{
  std::string origin; ///< its file, or "generated"
  fem::MeshCheck check;
  std::optional<fem::MeshReport> report; ///< of a file
};

/// Data for the plots of a mesh.
struct MeshPictures
{
  std::vector<fem::Quadrilateral> contact_faces;
  std::vector<double> scaled_jacobians;     ///< one per cell
  std::vector<fem::SectionPolygon> section; ///< through the axis
};

/// The results of `mesh` for a mesh that can be used; @p written are the names of the files it was written
/// to.
Results tabulate(const MeshFindings &findings, const MeshPictures &pictures,
                 const std::vector<std::string> &written);

/// Description of a mesh, in lines for the console.
std::string mesh_text(const MeshFindings &findings);

} // namespace stemware::pipeline
