#pragma once

namespace stemware::fem
{

/// Limits OpenMP in this thread and OpenBLAS in the process to one thread during its lifetime, so that
/// results do not depend on numbers of threads. Objects may overlap: the first sets OpenBLAS's count, the
/// last restores it.
class SingleThread
{
public:
  SingleThread();
  ~SingleThread();
  SingleThread(const SingleThread &) = delete;
  SingleThread &operator=(const SingleThread &) = delete;

private:
  const int omp_threads, omp_levels; ///< to be restored
};

/// Returns whether several threads may use BLAS together; serial OpenBLAS would give wrong numbers.
bool blas_takes_threads();

} // namespace stemware::fem
