#pragma once

#include "fem/pipeline/study/presets.h"
#include "fem/pipeline/study/study.h"
#include "fem/revolution/compliance_cache.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace stemware::pipeline
{

/// The live cut as WebAssembly, and the script that starts it.
struct LiveSolver
{
  std::string script; ///< both gzip, base64
  std::string wasm;
};

/// The solver that comes with the program: explore.js and explore.wasm of share/stemware, else those of the
/// page explore.html there. Throws BadInput where there is neither.
LiveSolver live_solver();

/// Content of a page of `stemware explore`.
struct PageOptions
{
  Study study;                 ///< that the page begins with
  std::vector<Preset> glasses; ///< that can be chosen; empty: that of the study
  std::vector<Preset> tables;  ///< likewise
  unsigned int n_threads = 1;  ///< that share the pairs
  unsigned int max_nodes = 0;  ///< across the land, of focused meshes; 0: as many as `stemware run` has
};

/// One glass on one table of a page.
struct PagePair
{
  std::string glass, table;
  unsigned int n_nodes = 0;
  double omega = 0; ///< terminal spin by the program [rad/s]
  std::optional<double>
    band;                ///< |omega - that on the page's mesh|, doubled, where that is a coarser one [rad/s]
  std::size_t bytes = 0; ///< of its compliances, before they are packed
};

/// The page, and what is in it. @p done is called for each pair, in their order. Throws BadInput as
/// live_bodies(), and for pairs that the program does not solve.
struct Page
{
  std::string text;
  std::vector<PagePair> pairs;
};
Page make_page(const PageOptions &options, const LiveSolver &solver, fem::ComplianceCache &cache,
               const std::function<void(const PagePair &)> &done = {});

} // namespace stemware::pipeline
