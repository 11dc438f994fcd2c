#pragma once

#include "fem/contact/surface_parts.h"
#include "fem/contact/table_law.h"

#include <vector>

namespace stemware::fem
{

/// Active sets of a Newton iteration, each with the residual of the last visit.
class VisitedSets
{
public:
  /// @p parts: communication of the surface whose active set is distributed.
  explicit VisitedSets(const SurfaceParts &parts)
      : parts(parts)
  {
  }

  /// Returns whether @p set (this rank's part) is new or recurs with less than half the @p residual.
  /// Collective.
  bool makes_progress(const ActiveSet &set, double residual);

private:
  struct Visit
  {
    ActiveSet set;   ///< active set of this part
    double residual; ///< residual of the whole surface
  };

  const SurfaceParts &parts;
  std::vector<Visit> visits;
};

} // namespace stemware::fem
