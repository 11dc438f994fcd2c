#include "fem/revolution/single_thread.h"

#include <dlfcn.h>
#include <mutex>
#include <omp.h>

namespace stemware::fem
{

namespace
{

/// Returns the function @p name of the BLAS library; nullptr if the library is not OpenBLAS.
template <typename Function>
Function *of_openblas(const char *name)
{
  return reinterpret_cast<Function *>(dlsym(RTLD_DEFAULT, name));
}

std::mutex mutex;
unsigned int n_holders = 0;
int blas_threads = 1; ///< number of BLAS threads while no SingleThread exists

} // namespace

SingleThread::SingleThread()
    : omp_threads(omp_get_max_threads())
    , omp_levels(omp_get_max_active_levels())
{
  omp_set_num_threads(1);       // also limits an OpenBLAS that is built with OpenMP
  omp_set_max_active_levels(0); // CHOLMOD would start four more threads per calling thread
  const std::lock_guard<std::mutex> lock(mutex);
  const auto get = of_openblas<int()>("openblas_get_num_threads");
  const auto set = of_openblas<void(int)>("openblas_set_num_threads");
  if (n_holders++ == 0 && get != nullptr && set != nullptr)
  {
    blas_threads = get();
    set(1);
  }
}

SingleThread::~SingleThread()
{
  omp_set_num_threads(omp_threads);
  omp_set_max_active_levels(omp_levels);
  const std::lock_guard<std::mutex> lock(mutex);
  if (const auto set = of_openblas<void(int)>("openblas_set_num_threads"); --n_holders == 0 && set != nullptr)
    set(blas_threads);
}

bool blas_takes_threads()
{
  const auto built_for_threads = of_openblas<int()>("openblas_get_parallel");
  return built_for_threads == nullptr || built_for_threads() != 0;
}

} // namespace stemware::fem
