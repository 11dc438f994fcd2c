#pragma once

#include "fem/revolution/compliance_cache.h"
#include "fem/revolution/revolution_setup.h"

#include <deal.II/grid/tria.h>

#include <memory>

namespace stemware::fem
{

/// Meridional meshes of a foot and of the disc under it (empty without a disc), with the same contact cells.
/// Includes deal.II: not for headers of the library's users.
struct MeridianMeshes
{
  /// Makes the meshes for @p setup.
  explicit MeridianMeshes(const RevolutionSetup &setup);

  /// Refines the flagged cells, and keeps the contact cells of both bodies equal.
  void refine();

  /// Halves the cells farther than RevolutionSetup::zone_half_width() from the contact circle, except contact
  /// cells in the focus of @p setup or as small as the cells in the focus.
  void refine_beyond_zone(const RevolutionSetup &setup);

  dealii::Triangulation<2> foot;
  dealii::Triangulation<2> disc;
};

/// Returns RevolutionSetup::total_compliance() of @p setup on @p meshes, with degree and harmonics of @p
/// options. Throws as ComplianceCache::get().
std::shared_ptr<const ContactCompliance> compliance_of(const RevolutionSetup &setup,
                                                       const MeridianMeshes &meshes,
                                                       const MeridianOptions &options,
                                                       ComplianceCache &cache);

} // namespace stemware::fem
