#pragma once

#include "fem/revolution/compliance_cache.h"
#include "fem/revolution/revolution_foot.h"

#include <memory>
#include <mutex>
#include <vector>

namespace stemware::fem
{

class MeridianField;

/// A foot of revolution with the meridional meshes that its compliance comes from: it knows its fields.
class MeshedRevolutionFoot : public RevolutionFoot
{
public:
  using RevolutionFoot::RevolutionFoot;
  /// Computes the compliances. Throws std::invalid_argument for a setup that is not allowed.
  explicit MeshedRevolutionFoot(const RevolutionSetup &setup);
  /// Takes the compliances from @p cache, which other feet share.
  MeshedRevolutionFoot(const RevolutionSetup &setup, ComplianceCache &cache);

  /// The same foot with a state of its own.
  MeshedRevolutionFoot(const MeshedRevolutionFoot &other);

  std::shared_ptr<const Foot> twin() const override;
  std::vector<FieldFile> fields(const ContactState &state) const override;
  std::vector<StressedPatch> section(const ContactState &state, double theta) const override;

private:
  /// The compliance of the whole land, once for a foot and its twins.
  struct WholeLand
  {
    std::once_flag once;
    std::shared_ptr<const ContactCompliance> compliance;
  };

  std::shared_ptr<const ContactCompliance> of_whole_land() const override;

  std::shared_ptr<WholeLand> whole_land = std::make_shared<WholeLand>();

  /// The meshes, and the meridional problems on that of the foot.
  struct Meridian;
  const Meridian &meridian() const;
  /// The displacement of the foot in @p state.
  MeridianField field(const ContactState &state) const;

  mutable std::shared_ptr<const Meridian> made_meridian; ///< of meridian(), when it was asked for
};

} // namespace stemware::fem
