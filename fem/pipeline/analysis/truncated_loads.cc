#include "fem/pipeline/analysis/truncated_loads.h"

#include "fem/pipeline/coupling/balanced_states.h"
#include "fem/pipeline/coupling/elastic_foot.h"
#include "ring_model/truncated_model.h"

#include <memory>

namespace stemware::pipeline
{

TruncatedLoads cut_off_loads(const RingLoad &load, const LoadAtSpin &on_the_way)
{
  return [at_spin = load.at_spin, on_the_way, is_costly = load.is_costly](unsigned int n_max) -> TruncatedLoad
  {
    const auto cut_off = [n_max](const LoadAtSpin &whole) -> LoadAtSpin
    { return [whole, n_max](double omega) { return whole(omega).truncated(n_max); }; };
    return { cut_off(at_spin), at_spin, is_costly, cut_off(on_the_way) };
  };
}

TruncatedLoads balanced_truncated_loads(const Study &study, const StudyLoad &load)
{
  const ring::Motion orbit = study.motion.orbit;
  const double radius = study.glass.profile.contact_radius;
  const auto elastic = std::make_shared<ElasticFoot>(load.foot, radius);
  return [=, closure = study.motion.closure, at_rest = load.load.at_rest](unsigned int n_max) -> TruncatedLoad
  {
    const auto before = [=](double omega) { elastic->spin_per_speed = omega / orbit.orbit_speed; };
    const auto states = std::make_shared<BalancedStates>(
      ring::SelfConsistentRing(closure, orbit, std::make_shared<ring::TruncatedModel>(elastic, n_max)),
      orbit.orbit_speed / radius, before);
    // At rest the friction does not depend on the load: the balance is that of all harmonics.
    const LoadAtSpin kept = [=](double omega)
    { return omega == 0 ? at_rest.truncated(n_max) : states->at(omega).load; };
    const LoadAtSpin whole = [=](double omega)
    {
      before(omega);
      return omega == 0 ? at_rest : elastic->load(orbit.normal_force(), kept(omega).moment());
    };
    return { kept, whole, true };
  };
}

std::string why_no_balance(const Study &study)
{
  switch (study.load.source)
  {
  case LoadSource::first_harmonic:
    return "A first-harmonic load has no harmonics to leave out.";
  case LoadSource::file:
    return "A load from a file does not answer to friction, so there is no balance without its harmonics.";
  case LoadSource::contact:
    break;
  }
  if (study.load.is_static())
    return "The moment is given (Load/Moment ratio), so there is no balance of moments for friction to "
           "enter.";
  if (study.contact.body == BodyKind::solid && study.load.coupling == LoadCoupling::frozen)
    return "The balance without some harmonics takes a thousand contact solutions; for a solid body it is "
           "computed with Load/Coupling = exact only.";
  return "";
}

} // namespace stemware::pipeline
