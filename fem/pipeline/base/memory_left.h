#pragma once

#include <string>

namespace stemware::pipeline
{

/// Memory that this process may still take.
struct MemoryLeft
{
  double bytes = 0;              ///< infinite without a limit
  std::string limit;             ///< what limits it, with its size: "ulimit -v (0.5 GB)"
  bool is_address_space = false; ///< stacks and buffers count that are reserved and hardly used
};

/// Returns the smallest of what the limits of the process (address space, RLIMIT_AS) and of its control
/// groups leave.
MemoryLeft memory_left();

} // namespace stemware::pipeline
