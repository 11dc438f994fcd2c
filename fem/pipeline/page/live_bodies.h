#pragma once

#include "fem/pipeline/coupling/foot_specification.h"
#include "fem/revolution/compliance_cache.h"

#include <optional>

namespace stemware::pipeline
{

/// Compliances of a study for an Explorer.
struct LiveBodies
{
  fem::ContactCompliance foot;
  std::optional<fem::ContactCompliance> disc; ///< std::nullopt on a rigid substrate
};

/// Returns the compliances of foot and disc of a study in the expected contact zone. For a similar foot,
/// @p ratio times as large, the disc is made smaller by this ratio, because Explorer scales both. Throws
/// BadInput for studies that an Explorer does not support: solid body, drawn profile, waviness, files.
LiveBodies live_bodies(const FootSpecification &specification, fem::ComplianceCache &cache, double ratio = 1);

} // namespace stemware::pipeline
