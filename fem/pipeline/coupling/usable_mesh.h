#pragma once

#include "fem/geometry/mesh_io.h"
#include "fem/geometry/mesh_quality.h"
#include "fem/pipeline/study/study.h"

#include <optional>
#include <string>

namespace stemware::pipeline
{

/// Reads a mesh file as fem::read_foot_mesh() does, and compares the radius of its rim with the glass of @p
/// study, if there is one: a mesh in other units, or of another glass, would pass unnoticed. Throws BadInput.
fem::MeshReport read_mesh_file(const std::string &file, const std::optional<Study> &study,
                               dealii::Triangulation<3, 3> &mesh);

/// Throws BadInput with one sentence about the first thing that makes a mesh useless: cells inside out, a
/// contact zone that looks up or does not lie round the z axis. @p origin is where the mesh comes from.
void require_usable(const std::string &origin, const fem::MeshCheck &check);

/// Refuses the mesh file of a study unless a solid foot can be made of it. Reads the whole mesh on every rank. Throws
/// BadInput.
void require_usable_mesh(const Study &study);

} // namespace stemware::pipeline
