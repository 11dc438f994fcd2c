#pragma once

namespace stemware::fem
{

/// Restricts the system's BLAS to the calling thread, in the whole program: the program's own threads share
/// the work, and sums do not depend on the number of threads. May be called repeatedly.
void hold_blas_to_one_thread();

/// Returns whether several threads may use the system's BLAS together. False for OpenBLAS built for one
/// thread, which then gives wrong numbers.
bool blas_takes_threads();

} // namespace stemware::fem
