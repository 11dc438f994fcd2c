#pragma once

#include "fem/pipeline/study/study.h"
#include "fem/revolution/compliance_cache.h"

#include <optional>

namespace stemware::pipeline
{

/// Bodies of a study as an Explorer takes them.
struct LiveBodies
{
  fem::ContactCompliance foot;
  std::optional<fem::ContactCompliance> disc; ///< nothing on a rigid substrate
};

/// The compliances of the foot of @p study and of the disc under it, where the contact is expected. Throws
/// BadInput for a study that no Explorer follows: one with a solid body, a drawn profile, a wavy rim or
/// table, or files.
LiveBodies live_bodies(const Study &study, fem::ComplianceCache &cache);

} // namespace stemware::pipeline
