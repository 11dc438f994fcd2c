#pragma once

namespace stemware::fem
{

/// Restricts the system's BLAS to one thread, in the whole program: the program has its own threads, and
/// results do not depend on their number. May be called repeatedly.
void hold_blas_to_one_thread();

/// Returns whether several threads may use the system's BLAS together. False for OpenBLAS built for one
/// thread, which then gives wrong numbers.
bool blas_takes_threads();

} // namespace stemware::fem
