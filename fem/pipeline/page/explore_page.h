#pragma once

#include "fem/pipeline/page/page.h"
#include "fem/pipeline/study/presets.h"
#include "fem/pipeline/study/study.h"
#include "fem/revolution/compliance_cache.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace stemware::pipeline
{

/// Returns the installed solver as WebAssembly, gzip in base64: of explore.wasm in share/stemware, else of
/// explore.html there. Throws BadInput if neither exists.
std::string live_solver();

/// Options of the live part of a page.
struct PageOptions
{
  Study study;                 ///< initial study of the page
  std::vector<Preset> glasses; ///< selectable; empty: the study's glass
  std::vector<Preset> tables;  ///< selectable; empty: the study's table
  unsigned int n_threads = 1;  ///< threads that share the pairs
  unsigned int max_nodes = 0;  ///< nodes across the land, if focused; 0: as in `stemware run`
};

/// Glass on a table of a page.
struct PagePair
{
  std::string glass, table;
  unsigned int n_nodes = 0;
  std::optional<double> omega; ///< terminal spin by `run` [rad/s]; std::nullopt if the glass tips
  /// Twice the difference from the spin on the page's mesh, if that mesh is coarser [rad/s].
  std::optional<double> band;
};

/// Makes the live part of a page; calls @p done for each pair, in order. Throws BadInput as live_bodies(),
/// and for pairs that cannot be solved.
LivePart live_part(const PageOptions &options, const std::string &solver, fem::ComplianceCache &cache,
                   const std::function<void(const PagePair &)> &done);

/// Returns the terminal spin with its unit, or a text that the glass tips.
std::string spin_text(const PagePair &pair);

/// Returns the page of @p live with its @p pairs.
std::string explore_page(const LivePart &live, const std::vector<PagePair> &pairs);

} // namespace stemware::pipeline
