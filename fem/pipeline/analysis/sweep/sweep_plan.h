#pragma once

#include "fem/pipeline/analysis/sweep/swept_entry.h"
#include "fem/pipeline/study/study.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace stemware::pipeline
{

/// Request of `stemware sweep`: entries to vary, as they stand on the command line.
struct SweepRequest
{
  std::vector<std::string> varied; ///< --vary, see parse_varied_entry()
  std::vector<std::string> random; ///< --random, see parse_spread()
  unsigned int n_samples = 200;    ///< --samples
  std::uint64_t seed = 1;          ///< --seed
  std::size_t most_cases = 10000;  ///< --most-cases
};

/// The cases of a sweep: one study, and for each case the values of some of its entries.
struct SweepPlan
{
  Study base;                      ///< whose other entries hold for all cases
  std::vector<SweptEntry> entries; ///< one or two for a grid, any number for samples
  std::vector<std::vector<std::string>>
    cases;                     ///< values [case][entry]; of a grid, the last entry changes fastest
  std::vector<Spread> spreads; ///< of the entries; empty for a grid
  std::uint64_t seed = 0;

  bool is_random() const { return !spreads.empty(); }

  /// The study of one case. Throws BadInput where its values are not allowed.
  Study study_of(std::size_t index) const;
};

/// The plan without its base. Throws BadInput, with one sentence, for requests that cannot be understood,
/// entries that do not exist or cannot be sampled, values that an entry does not take or that stand twice,
/// and more cases than are allowed.
SweepPlan make_plan(const SweepRequest &request);

/// How the cases came about, for sweep.json.
nlohmann::ordered_json plan_as_json(const SweepPlan &plan);

/// All that the results depend on: program, base, cases, contents of the files that the cases read. Plans
/// with equal identities have equal results.
nlohmann::ordered_json identity_of(const SweepPlan &plan);

} // namespace stemware::pipeline
