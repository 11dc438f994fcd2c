#include "fem/factorisation/blas_threads.h"

#include <dlfcn.h>

namespace stemware::fem
{

namespace
{

/// The function @p name of the BLAS that the system has; nothing where that is not OpenBLAS.
template <typename Function>
Function *of_openblas(const char *name)
{
  return reinterpret_cast<Function *>(dlsym(RTLD_DEFAULT, name));
}

} // namespace

void hold_blas_to_one_thread()
{
  static const bool is_held = []
  {
    if (auto *const set_num_threads = of_openblas<void(int)>("openblas_set_num_threads"))
      set_num_threads(1);
    return true;
  }();
  (void)is_held;
}

bool blas_takes_threads()
{
  static const bool takes_threads = []
  {
    auto *const built_for_threads = of_openblas<int()>("openblas_get_parallel");
    return built_for_threads == nullptr || built_for_threads() != 0;
  }();
  return takes_threads;
}

} // namespace stemware::fem
