#pragma once

#include <string>

namespace dealii
{
template <int dim, int spacedim>
class Triangulation;
}

namespace stemware::fem
{

/// Reads the hexahedra of a file, and of their faces the ids that it gives: Gmsh's .msh (2 or 4; physical
/// ids), Abaqus's .inp (C3D8, C3D20, C3D27; element surfaces with a number in their names), VTK's .vtu in
/// ASCII (types 12, 25, 29 and 9, 23, 28; integer cell data with the name boundary_id). Of hexahedra of
/// second order the corners are kept; returns whether there are such. Throws std::invalid_argument with one
/// sentence for any other file and for what cannot be read.
bool read_hexahedra(const std::string &file_name, dealii::Triangulation<3, 3> &triangulation);

} // namespace stemware::fem
