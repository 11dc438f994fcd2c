#pragma once

#include <string>

namespace stemware::pipeline
{

/// Memory that this process may still take.
struct MemoryLeft
{
  double bytes = 0;              ///< bytes left; infinite without a limit
  std::string limit;             ///< what limits it, with its size: "ulimit -v (0.5 GB)"
  bool is_address_space = false; ///< the limit includes reserved memory that is hardly used, such as stacks
};

/// Returns the memory left by the tightest limit: of the process (address space, RLIMIT_AS) or of its control
/// groups.
MemoryLeft memory_left();

} // namespace stemware::pipeline
