#pragma once

#include "fem/geometry/mesh_io.h"
#include "fem/geometry/mesh_quality.h"
#include "fem/pipeline/study/study.h"

#include <string>

namespace stemware::pipeline
{

/// Reads a mesh file as fem::read_foot_mesh() does. Throws BadInput.
fem::MeshReport read_mesh_file(const std::string &file, const fem::MeshMarks &marks,
                               dealii::Triangulation<3, 3> &mesh);

/// Throws BadInput with one sentence about the first thing that makes a mesh useless: cells inside out, a
/// contact zone of several parts, that looks up or does not lie round the z axis. @p origin is where the mesh
/// comes from.
void require_usable(const std::string &origin, const fem::MeshCheck &check);

/// A mesh in other units than the study, or of another glass, would pass unnoticed: its rim is compared with
/// the contact radius. Throws BadInput.
void require_same_glass(const fem::MeshReport &report, const std::string &file, const Study &study);

/// All of that for the mesh file of a study: refuses it unless a solid foot can be made of it. Reads the
/// whole mesh on every rank. Throws BadInput.
void require_usable_mesh(const Study &study);

} // namespace stemware::pipeline
