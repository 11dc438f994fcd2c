#pragma once

namespace stemware::pipeline
{

/// Throws std::runtime_error unless the control groups of this process leave @p needed [byte], and its
/// address space (RLIMIT_AS), which includes hardly used memory such as stacks, leaves @p reserved [byte].
void require_memory_left(double needed, double reserved);

} // namespace stemware::pipeline
