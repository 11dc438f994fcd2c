#pragma once

#include "fem/revolution/compliance_cache.h"
#include "fem/revolution/revolution_foot.h"

#include <memory>
#include <mutex>
#include <vector>

namespace stemware::fem
{

class MeridianField;

/// Foot of revolution with meridional meshes: computes its compliance and fields.
class MeshedRevolutionFoot : public RevolutionFoot
{
public:
  using RevolutionFoot::RevolutionFoot;
  /// Computes the compliances. Throws std::invalid_argument for an inadmissible setup.
  explicit MeshedRevolutionFoot(const RevolutionSetup &setup);
  /// Takes the compliances from @p cache, which other feet share.
  MeshedRevolutionFoot(const RevolutionSetup &setup, ComplianceCache &cache);

  std::shared_ptr<const Foot> clone() const override;
  std::vector<FieldFile> fields(const ContactState &state) const override;
  std::vector<StressedPatch> section(const ContactState &state, double theta) const override;

private:
  /// Compliance of the whole land, computed once for a foot and its clones.
  struct WholeLand
  {
    std::once_flag once;
    std::shared_ptr<const ContactCompliance> compliance;
  };

  std::shared_ptr<const ContactCompliance> whole_land_compliance() const override;

  std::shared_ptr<WholeLand> whole_land = std::make_shared<WholeLand>();

  /// Meshes, and the meridional problems on the foot's mesh.
  struct Meridian;
  const Meridian &meridian() const;
  /// Returns the displacement of the foot in @p state.
  MeridianField field(const ContactState &state) const;

  mutable std::shared_ptr<const Meridian> made_meridian; ///< cache of meridian()
};

} // namespace stemware::fem
