#pragma once

namespace stemware::fem
{

/// Holds OpenMP in this thread, and OpenBLAS in the whole process, to one thread while the object lives: the
/// callers have threads of their own, and results do not depend on their number. Objects in several threads
/// may overlap: the first one sets OpenBLAS's count, the last one restores it.
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

/// Returns whether several threads may use the system's BLAS together. False for OpenBLAS built for one
/// thread, which then gives wrong numbers.
bool blas_takes_threads();

} // namespace stemware::fem
