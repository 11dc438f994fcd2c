#pragma once

namespace stemware::pipeline
{

/// Throws std::runtime_error if this process may take less memory than the @p needed bytes, under the
/// tightest limit: address space (RLIMIT_AS) or control groups. An address space needs @p reserved bytes,
/// with reserved memory that is hardly used, such as stacks.
void require_memory_left(double needed, double reserved);

} // namespace stemware::pipeline
