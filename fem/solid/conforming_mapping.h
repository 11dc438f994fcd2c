#pragma once

#include <deal.II/fe/mapping_q.h>

#include <memory>

namespace stemware::fem
{

/// Geometry of @p mesh in polynomials of @p degree, which has no gaps where cells meet halved ones: there
/// the finer faces lie on the polynomials of the coarser one, not on the surface that both approximate.
///
/// deal.II's own mapping leaves gaps of a few 1e-8 m on a foot of 48 sectors. Displacements are continuous in
/// the cells' coordinates, so that across a gap they are not quite what they say: a_2 on meshes that are
/// finer at some azimuths only was wrong by 2e-5 of a_0. @p mesh must outlive the mapping. Collective. Throws
/// std::runtime_error where cells are turned inside out: those halved next to a coarse chord of the rim.
std::unique_ptr<const dealii::MappingQ<3>> conforming_mapping(const dealii::Triangulation<3> &mesh,
                                                              unsigned int degree);

} // namespace stemware::fem
