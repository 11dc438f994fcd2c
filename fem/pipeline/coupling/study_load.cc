#include "fem/pipeline/coupling/study_load.h"

#include "fem/contact/contact_solution.h"
#include "fem/pipeline/base/failures.h"
#include "fem/pipeline/base/numbers.h"
#include "ring_model/failures.h"
#include "ring_model/self_consistent_ring.h"

#include <stdexcept>

namespace stemware::pipeline
{

namespace
{

BalancedLoad given_first_harmonic(const Study &study)
{
  const fem::Resultants demand = study.required_resultants();
  return given_load(ring::RingStack::first_harmonic(demand.normal_force, { demand.moment_x, demand.moment_y },
                                                    study.glass.profile.contact_radius));
}

BalancedLoad load_from_file(const LoadSection &section, unsigned int n_harmonics)
{
  const ring::RingStack &load = *section.from_file;
  const double ratio = load.moment_ratio(load.radius());
  const auto [given, limit] = distinct_texts(ratio, 2);
  const std::string sentence = "The load of " + shortened_path(section.file) +
                               " has a moment ratio sqrt(a_1^2 + b_1^2) / a_0 of " + given +
                               ", but a ring tips at " + limit + "; give smaller a_1, b_1.";
  ensure(ratio < 2, sentence);
  return given_load(load, n_harmonics);
}

} // namespace

std::shared_ptr<ElasticFoot> study_foot(const Study &study, const FootMaker &make_foot, Progress &progress,
                                        const ElasticFoot *similar, const Discretisation &discretisation,
                                        const Model &model)
{
  if (!study.load.is_from_contact())
    return nullptr;
  auto foot = std::make_shared<ElasticFoot>(
    make_foot(study, discretisation, model, similar ? &similar->body() : nullptr),
    study.glass.profile.contact_radius, discretisation, model);
  if (similar)
    foot->predict_from_similar(*similar);
  progress.stage_done("mesh_and_stiffness");
  return foot;
}

void require_no_tipping(const Study &study)
{
  if (study.load.is_from_contact())
    study.required_resultants();
}

BalancedLoad find_load(const Study &study, const std::shared_ptr<ElasticFoot> &foot, Progress &progress,
                       unsigned int n_harmonics, PhaseSampling phases)
{
  switch (study.load.source)
  {
  case LoadSource::contact:
    return contact_load(study, foot, n_harmonics, progress, phases);
  case LoadSource::first_harmonic:
    return study.load.is_static() ? given_first_harmonic(study)
                                  : first_harmonic_load(study, study.motion.closure);
  case LoadSource::file:
    return load_from_file(study.load, n_harmonics);
  }
  throw std::logic_error("a load source without a load");
}

bool is_balance_failure(const std::exception &failure)
{
  return dynamic_cast<const fem::ContactFailure *>(&failure) ||
         dynamic_cast<const ring::NoBalance *>(&failure);
}

BalancedLoad first_harmonic_load(const Study &study, ring::Closure closure)
{
  const ring::SelfConsistentRing ring(closure, study.motion.orbit, study.glass.profile.contact_radius);
  return { ring::Load([ring](double omega) { return ring.at(omega).load; }), report_of(ring.at(0).load) };
}

std::string frozen_note(const Study &study)
{
  const bool could_follow = !study.load.is_static() && depends_on_spin(study);
  return study.load.coupling == LoadCoupling::one_way && could_follow
           ? "the load at rest is used at every spin; Load/Coupling = two-way computes it at each spin"
           : "";
}

} // namespace stemware::pipeline
