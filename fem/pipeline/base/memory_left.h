#pragma once

#include <string>

namespace stemware::pipeline
{

/// Memory that this process may still take.
struct MemoryLeft
{
  double bytes = 0;              ///< bytes left; infinite without a limit
  std::string limit;             ///< tightest limit with its size: "ulimit -v (0.5 GB)"
  bool is_address_space = false; ///< the limit includes reserved memory that is hardly used, such as stacks
};

/// Returns the memory left under the tightest limit: address space (RLIMIT_AS) or control groups.
MemoryLeft memory_left();

} // namespace stemware::pipeline
