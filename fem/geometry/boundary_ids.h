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

} // namespace stemware::fem
