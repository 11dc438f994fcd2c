#include "fem/pipeline/analysis/solve.h"

#include "fem/contact/contact_solution.h"
#include "fem/pipeline/base/failures.h"
#include "ring_model/failures.h"

#include <stdexcept>

namespace stemware::pipeline
{

bool is_variant_failure(const std::exception &failure)
{
  return dynamic_cast<const BadInput *>(&failure) || dynamic_cast<const fem::ContactFailure *>(&failure) ||
         dynamic_cast<const ring::NoBalance *>(&failure);
}

bool is_tipping(const std::exception &failure)
{
  const auto *contact = dynamic_cast<const fem::ContactFailure *>(&failure);
  return contact ? contact->outcome == fem::ContactOutcome::tipping
                 : dynamic_cast<const ring::Tipping *>(&failure) != nullptr;
}

std::shared_ptr<ElasticFoot> foot_of(const Variant &variant, const std::shared_ptr<ElasticFoot> &foot,
                                     const Executor &executor)
{
  ensure(variant.reason.empty(), variant.reason);
  if (variant.study.load.is_from_contact())
    variant.study.required_resultants(); // throws if the glass tips at rest
  if (variant.shared > Shared::rings)
  {
    if (!foot)
      return nullptr;
    std::shared_ptr<ElasticFoot> twin = foot->clone(variant.study);
    if (variant.shared == Shared::contact)
      twin->reset_rings();
    return twin;
  }
  try
  {
    std::shared_ptr<ElasticFoot> own = study_foot(variant, executor.make_foot, silent_progress(), foot.get());
    if (variant.shared == Shared::rings)
      own->set_rings(foot->ring_radii(), foot->n_harmonics());
    return own;
  }
  catch (const std::runtime_error &failure)
  {
    throw BadInput(failure.what());
  }
}

} // namespace stemware::pipeline
