#pragma once

#include "fem/revolution/compliance_cache.h"
#include "fem/revolution/revolution_setup.h"

#include <deal.II/grid/tria.h>

#include <memory>
#include <utility>

namespace stemware::fem
{

/// Meridional meshes of a foot and of the disc under it, which has no cells where there is none. Both have
/// the same contact cells. Includes deal.II; not for headers of the library's users.
struct MeridianMeshes
{
  /// Makes the meshes that @p setup asks for.
  explicit MeridianMeshes(const RevolutionSetup &setup);

  /// Refines the cells that carry refine flags, and in either body the contact cells that are cut in the
  /// other.
  void refine();

  /// Halves the cells farther from the contact circle than RevolutionSetup::zone_reach(), but those contact
  /// cells that lie in the focus of @p setup or are as small.
  void refine_beyond_zone(const RevolutionSetup &setup);

  dealii::Triangulation<2> foot;
  dealii::Triangulation<2> disc;
};

/// Compliance of the foot and substrate of @p setup together on @p meshes, with elements and harmonics of @p
/// options, without what the setup switches off. Throws as ComplianceCache::get().
std::shared_ptr<const ContactCompliance> compliance_of(const RevolutionSetup &setup,
                                                       const MeridianMeshes &meshes,
                                                       const MeridianOptions &options,
                                                       ComplianceCache &cache);

} // namespace stemware::fem
