#pragma once

#include "fem/geometry/mesh_quality.h"
#include "fem/pipeline/output/mesh_findings.h"
#include "fem/pipeline/output/render/report.h"

namespace stemware::pipeline
{

/// What pictures show of a mesh.
struct MeshPictures
{
  std::vector<fem::Quadrilateral> contact_faces;
  std::vector<double> scaled_jacobians; ///< one per cell
};

/// report.html of a mesh that can be used: what it is like, its contact zone from above, the quality of its
/// cells.
Report mesh_report(const MeshFindings &findings, const MeshPictures &pictures);

} // namespace stemware::pipeline
