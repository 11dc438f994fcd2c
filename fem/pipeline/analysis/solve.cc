#include "fem/pipeline/analysis/solve.h"

#include "fem/pipeline/base/failures.h"
#include "fem/pipeline/coupling/study_load.h"

#include <stdexcept>

namespace stemware::pipeline
{

bool is_variant_failure(const std::exception &failure)
{
  return dynamic_cast<const BadInput *>(&failure) || is_balance_failure(failure);
}

bool is_collective(const Study &study)
{
  return study.load.is_from_contact() && abilities(study.contact.body).is_collective;
}

std::shared_ptr<ElasticFoot> foot_of(const Variant &variant, const std::shared_ptr<ElasticFoot> &foot,
                                     const Executor &executor)
{
  ensure(variant.reason.empty(), variant.reason);
  require_no_tipping(variant.study);
  if (variant.shared != Shared::nothing)
    return foot ? foot->clone() : nullptr;
  try
  {
    return study_foot(variant.study, executor.make_foot, silent_progress(), foot.get(),
                      variant.discretisation, variant.model);
  }
  catch (const std::runtime_error &failure)
  {
    throw BadInput(failure.what());
  }
}

} // namespace stemware::pipeline
