#pragma once

#include "fem/geometry/mesh_io.h"
#include "fem/geometry/mesh_quality.h"
#include "fem/pipeline/study/study.h"

#include <string>

namespace stemware::pipeline
{

/// Reads a mesh file as fem::read_foot_mesh() does. Throws BadInput, also for a file that would take more
/// than @p memory_limit [byte] to read, of which nothing is read.
fem::MeshReport read_mesh_file(const std::string &file, const fem::MeshFileOptions &marks,
                               dealii::Triangulation<3, 3> &mesh,
                               double memory_limit = ContactSection().memory_limit);

/// Throws BadInput with one sentence about the first property that makes a mesh useless: pieces that nothing
/// holds, cells inside out, swapped ids, a contact zone of several parts, that looks up or sideways, or that
/// does not lie round the z axis. @p origin is the mesh's file.
void require_usable(const std::string &origin, const fem::MeshCheck &check,
                    const fem::MeshFileOptions &marks = {});

/// Compares the mesh's rim with the contact radius of the study: a mesh in another unit, or of another glass,
/// would pass unnoticed. Throws BadInput.
void require_same_glass(const fem::MeshReport &report, const std::string &file, const Study &study);

/// All of that for the mesh file of a study: refuses it unless a solid foot can be made of it. Reads the
/// whole mesh on every rank. Throws BadInput.
void require_usable_mesh(const Study &study);

} // namespace stemware::pipeline
