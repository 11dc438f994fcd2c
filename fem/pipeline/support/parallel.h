#pragma once

#include <cstddef>
#include <functional>

namespace stemware::pipeline
{

/// Calls @p work(i) for every i < @p n, at most @p n_threads at a time, each as soon as a thread is free;
/// returns when all are done. After one has thrown, no further ones are begun, and its exception (that of
/// the least i, if several threw) is thrown here. Parallel loops within @p work do not mix with each other.
/// For one caller at a time.
void parallel_for_each(std::size_t n, unsigned int n_threads, const std::function<void(std::size_t)> &work);

} // namespace stemware::pipeline
