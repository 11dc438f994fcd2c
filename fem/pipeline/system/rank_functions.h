#pragma once

#include <string>
#include <utility>
#include <vector>

namespace stemware::pipeline
{

/// Exit code and message of some work on one rank.
using RankOutcome = std::pair<int, std::string>;

/// Function table stemware_ranks of the module fem: the MPI functions of ranks.h.
struct RankFunctions
{
  bool has_mpi; ///< whether deal.II was built with it
  void (*start)();
  void (*stop)();
  unsigned int (*this_rank)();
  unsigned int (*n_ranks)();
  std::vector<RankOutcome> (*all_gather)(const RankOutcome &);
  std::string (*broadcast)(const std::string &); ///< of the first rank
  void (*abort)(int exit_status);
};

} // namespace stemware::pipeline
