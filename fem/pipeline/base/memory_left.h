#pragma once

namespace stemware::pipeline
{

/// Throws std::runtime_error unless the tightest memory limit of this process leaves @p needed [byte], or
/// @p reserved [byte] if this limit is the address space (RLIMIT_AS), which includes hardly used memory such
/// as stacks. Other limits are control groups.
void require_memory_left(double needed, double reserved);

} // namespace stemware::pipeline
