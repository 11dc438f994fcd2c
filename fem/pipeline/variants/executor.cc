#include "fem/pipeline/variants/executor.h"

#include "fem/contact/contact_solution.h"
#include "fem/pipeline/support/failures.h"
#include "ring_model/no_balance.h"

#include <utility>

namespace stemware::pipeline
{

Executor::Executor(FootMaker make_foot, Loop side_by_side)
    : make_foot(std::move(make_foot))
    , side_by_side(std::move(side_by_side))
{
}

void Executor::for_each(std::size_t n, const Work &work, bool one_by_one) const
{
  if (side_by_side && !one_by_one)
    return side_by_side(n, work);
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

} // namespace stemware::pipeline
