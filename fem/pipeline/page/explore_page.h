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

/// Returns the installed solver as WebAssembly, gzip in base64: explore.wasm of share/stemware, else the
/// solver of the page explore.html there. Throws BadInput if neither exists.
std::string live_solver();

/// Options of the live part of a page.
struct PageOptions
{
  Study study;                 ///< initial study of the page
  std::vector<Preset> glasses; ///< selectable glasses; empty: the study's
  std::vector<Preset> tables;  ///< likewise
  unsigned int n_threads = 1;  ///< threads that share the pairs
  unsigned int max_nodes = 0;  ///< nodes across the land of focused meshes; 0: as in `stemware run`
};

/// One glass on one table of a page.
struct PagePair
{
  std::string glass, table;
  unsigned int n_nodes = 0;
  std::optional<double> omega; ///< terminal spin by the program [rad/s]; std::nullopt if the glass tips
  std::optional<double> band;  ///< twice |spin - spin on the page's mesh|, if that mesh is coarser [rad/s]
};

/// Makes the live part of a page; @p done is called for each pair, in order. Throws BadInput as
/// live_bodies(), and for pairs that `stemware run` cannot solve.
LivePart live_part(const PageOptions &options, const std::string &solver, fem::ComplianceCache &cache,
                   const std::function<void(const PagePair &)> &done);

/// Returns the terminal spin of a pair with its unit, or a text that the glass tips.
std::string spin_text(const PagePair &pair);

/// Returns the page of @p live, whose pairs are @p pairs.
std::string explore_page(const LivePart &live, const std::vector<PagePair> &pairs);

} // namespace stemware::pipeline
