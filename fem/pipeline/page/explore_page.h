#pragma once

#include "fem/meridian/compliance_cache.h"
#include "fem/pipeline/input/presets.h"
#include "fem/pipeline/study/study.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace stemware::pipeline
{

/// Live solver as WebAssembly with its start script.
struct LiveSolver
{
  std::string script; ///< both gzip, base64
  std::string wasm;
};

/// Returns the installed solver: explore.js and explore.wasm of share/stemware, else the solver of the page
/// explore.html there. Throws BadInput if neither exists.
LiveSolver live_solver();

/// Options of a page of `stemware explore`.
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
  double omega = 0;           ///< terminal spin by the program [rad/s]
  std::optional<double> band; ///< twice |omega - spin on the page's mesh|, if that mesh is coarser [rad/s]
  std::size_t bytes = 0;      ///< of its compliances, before they are packed
};

/// Page with a summary of its content.
struct Page
{
  std::string text;
  std::vector<PagePair> pairs;
};
/// Makes the page; @p done is called for each pair, in order. Throws BadInput as live_bodies(), and for pairs
/// that `stemware run` cannot solve.
Page make_page(const PageOptions &options, const LiveSolver &solver, fem::ComplianceCache &cache,
               const std::function<void(const PagePair &)> &done = {});

} // namespace stemware::pipeline
