#pragma once

#include "fem/geometry/mesh_io.h"
#include "fem/geometry/mesh_quality.h"
#include "fem/pipeline/study/contact_section.h"

#include <string>

namespace stemware::pipeline
{

/// Reads a mesh file by fem::read_foot_mesh() unless it would exceed @p memory_limit [byte]. Throws BadInput.
fem::MeshReport read_mesh_file(const std::string &file, const fem::MeshFileOptions &marks,
                               dealii::Triangulation<3, 3> &mesh,
                               double memory_limit = ContactSection().memory_limit);

/// Throws BadInput about the first defect of a mesh: parts not connected to the stem cut, inverted cells,
/// swapped ids, or a contact zone that has several parts, that faces up or sideways, or whose centre is not
/// on the z axis.
void require_usable(const std::string &origin, const fem::MeshCheck &check,
                    const fem::MeshFileOptions &marks = {});

/// Throws BadInput if the rim of a mesh whose coordinates have the @p unit [m] is not at @p contact_radius
/// [m] (wrong unit or glass).
void require_same_glass(const fem::MeshReport &report, const std::string &file, double unit,
                        double contact_radius);

/// Reads Contact/Mesh file and makes all checks of this header, on every rank. Throws BadInput.
void require_usable_mesh(const ContactSection &contact, double contact_radius);

} // namespace stemware::pipeline
