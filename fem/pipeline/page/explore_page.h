#pragma once

#include "fem/pipeline/base/progress.h"
#include "fem/pipeline/coupling/foot_specification.h"
#include "fem/pipeline/study/presets.h"
#include "fem/revolution/compliance_cache.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace stemware::pipeline
{

/// Returns the compliances of foot and disc (std::nullopt on a rigid substrate) in the expected contact zone
/// of a study, for an Explorer. For a foot that is @p ratio times as large, the disc is made smaller by this
/// ratio, because Explorer scales both. Throws BadInput for studies that an Explorer does not support: solid
/// body, drawn profile, waviness, files.
std::pair<fem::ContactCompliance, std::optional<fem::ContactCompliance>>
live_bodies(const FootSpecification &specification, fem::ComplianceCache &cache, double ratio = 1);

/// Options of a page that solves a study at every move of a slider.
struct PageOptions
{
  Study study;                 ///< initial study of the page
  std::vector<Preset> glasses; ///< selectable; empty: the study's glass
  std::vector<Preset> tables;  ///< selectable; empty: the study's table
  unsigned int n_threads = 1;  ///< threads that share the pairs
  unsigned int max_nodes = 0;  ///< nodes across the land, if focused; 0: as in `stemware run`
};

/// Returns the page of @p options. Notes each pair of glass and table in @p progress, in order, with its
/// name, nodes and terminal spin. Throws BadInput without an installed solver (explore.wasm or explore.html
/// in share/stemware), as live_bodies(), and for pairs that cannot be solved.
std::string explore_page(const PageOptions &options, fem::ComplianceCache &cache, Progress &progress);

} // namespace stemware::pipeline
