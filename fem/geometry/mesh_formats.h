#pragma once

#include <string>

namespace dealii
{
template <int dim, int spacedim>
class Triangulation;
}

namespace stemware::fem
{

/// Reads the hexahedra of a file, and of their faces the ids that it gives: Gmsh's .msh (format 2 or 4,
/// ASCII; physical ids), Abaqus's .inp (C3D8, C3D20, C3D27; element surfaces whose names end in their ids, or
/// where there are none, sets of surface elements such as S4 or CPS4 whose names do), VTK's .vtu in ASCII and
/// one piece (types 12, 25, 29 and 9, 23, 28; integer cell data with the name boundary_id). Of hexahedra of
/// second order the corners are kept; returns whether there are such. Time and memory grow with the size of
/// the file. Throws std::invalid_argument with one sentence for any other file and for what cannot be read.
bool read_hexahedra(const std::string &file_name, dealii::Triangulation<3, 3> &triangulation);

} // namespace stemware::fem
