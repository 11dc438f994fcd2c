#pragma once

namespace stemware::fem
{

/// Boundary ids of every foot mesh, generated or read.
enum class FootBoundary : unsigned int
{
  free = 0,
  stem_cut = 1,
  contact_zone = 2
};

/// Returns whether @p face is on @p boundary.
template <typename Face>
bool is_on(const Face &face, FootBoundary boundary)
{
  return face->at_boundary() && face->boundary_id() == static_cast<unsigned int>(boundary);
}

} // namespace stemware::fem
