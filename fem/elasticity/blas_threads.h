#pragma once

namespace stemware::fem
{

/// Holds the system's BLAS to the thread that calls it, in the whole program: threads of the program share
/// out the work, and a sum does not depend on how many there are. May be called as often as one likes.
void hold_blas_to_one_thread();

/// Whether several threads may be in the system's BLAS together: not in OpenBLAS built for one thread, which
/// gives wrong numbers then.
bool blas_takes_threads();

} // namespace stemware::fem
