#pragma once

#include "fem/contact/surface_parts.h"
#include "fem/contact/table_law.h"

#include <vector>

namespace stemware::fem
{

/// The active sets that a Newton iteration has come through, each with the residual of the last visit.
class VisitedSets
{
public:
  /// @p parts: whose sets together are one of the whole surface.
  explicit VisitedSets(const SurfaceParts &parts)
      : parts(parts)
  {
  }

  /// Whether the iteration is new to @p set, this part's, or comes back with less than half of the @p
  /// residual of the visit before. Collective over the parts.
  bool gains_at(const ActiveSet &set, double residual);

private:
  struct Visit
  {
    ActiveSet set;   ///< of this part
    double residual; ///< of the whole
  };

  const SurfaceParts &parts;
  std::vector<Visit> visits;
};

} // namespace stemware::fem
