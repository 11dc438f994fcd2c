#include "fem/pipeline/variants/solve.h"

#include "fem/contact/contact_solution.h"
#include "fem/pipeline/coupling/study_load.h"
#include "fem/pipeline/support/failures.h"
#include "fem/pipeline/support/parallel.h"
#include "ring_model/no_balance.h"

#include <stdexcept>

namespace stemware::pipeline
{

void Executor::for_each(std::size_t n, const std::function<void(std::size_t)> &work, bool one_by_one) const
{
  if (n_threads > 1 && n > 1 && !one_by_one)
    parallel_for_each(n, n_threads, work);
  else
    for (std::size_t i = 0; i < n; ++i)
      work(i);
}

std::exception_ptr Executor::failure_of(const std::function<void()> &work) const
try
{
  work();
  return nullptr;
}
catch (const BadInput &)
{
  return std::current_exception();
}
catch (const fem::ContactFailure &)
{
  return std::current_exception();
}
catch (const ring::NoBalance &)
{
  return std::current_exception();
}
catch (...)
{
  if (!keeps_all_failures)
    throw;
  return std::current_exception();
}

bool is_collective(const Study &study)
{
  return study.load.is_from_contact() && abilities(study.contact.body).is_collective;
}

std::shared_ptr<ElasticFoot> foot_of(const Variant &variant, const std::shared_ptr<ElasticFoot> &foot,
                                     const Executor &executor)
{
  require(variant.reason.empty(), variant.reason);
  require_standing(variant.study);
  if (variant.on_same_foot)
    return foot ? foot->twin() : nullptr;
  try
  {
    return study_foot(variant.study, executor.cache, silent_progress(), foot.get());
  }
  catch (const BadInput &)
  {
    throw;
  }
  catch (const std::runtime_error &failure)
  {
    throw BadInput(failure.what());
  }
}

} // namespace stemware::pipeline
