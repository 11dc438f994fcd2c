#include "fem/pipeline/feet/finite_elements.h"

#include "fem/pipeline/system/module.h"

#include <atomic>

namespace stemware::pipeline
{

namespace
{

// deal.II's own threads would compete with those of the study and make sums depend on the machine.
std::atomic<unsigned int> thread_limit = 1;

constexpr const char *table = "stemware_finite_elements";

} // namespace

const FiniteElementFunctions &finite_elements()
{
  static const FiniteElementFunctions &loaded = []() -> const FiniteElementFunctions &
  {
    const auto &functions =
      *static_cast<const FiniteElementFunctions *>(load_table("fem", table, "An elastic foot"));
    functions.set_thread_limit(thread_limit);
    return functions;
  }();
  return loaded;
}

const FiniteElementFunctions *loaded_finite_elements()
{
  return static_cast<const FiniteElementFunctions *>(loaded_table(table));
}

unsigned int limit_threads(unsigned int n_threads)
{
  if (const FiniteElementFunctions *loaded = loaded_finite_elements())
    loaded->set_thread_limit(n_threads);
  return thread_limit.exchange(n_threads);
}

} // namespace stemware::pipeline
