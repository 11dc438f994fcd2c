#include "fem/pipeline/coupling/coupled_load.h"

#include "fem/pipeline/coupling/balanced_states.h"
#include "fem/pipeline/coupling/elastic_foot.h"
#include "fem/pipeline/coupling/foot_response_curve.h"
#include "fem/pipeline/coupling/load_curve.h"
#include "fem/pipeline/study/study.h"
#include "fem/pipeline/support/failures.h"

#include <stdexcept>

namespace stemware::pipeline
{

namespace
{

/// The load in balance at every spin, with @p model between moment and load. @p before is called with every
/// spin before it is solved, @p solutions says how many contact solutions there have been.
RingLoad balanced_load(const Study &study, const fem::LoadHarmonics &at_rest,
                       const std::shared_ptr<const ring::LoadModel> &model,
                       const std::function<void(double omega)> &before,
                       const std::function<void(const BalancedStates &, CouplingFigures &)> &after)
{
  const ring::Motion &orbit = study.motion.orbit;
  const double radius = study.glass.profile.contact_radius;
  RingLoad load = frozen_contact_load(at_rest, radius);
  const auto figures = std::make_shared<CouplingFigures>();
  const auto states = std::make_shared<BalancedStates>(
    ring::SelfConsistentRing(study.motion.closure, orbit, model), orbit.orbit_speed / radius, before);
  load.at_spin = [states, figures, after, at_rest = load.at_rest](double omega) -> ring::AngularLoad
  {
    if (omega == 0)
      return at_rest;
    const ring::AngularLoad &balanced = states->at(omega).load;
    if (states->size() > figures->n_balances)
      after(*states, *figures);
    return balanced;
  };
  load.coupling = figures;
  return load;
}

RingLoad exact_load(const Study &study, const std::shared_ptr<FootContact> &foot,
                    const fem::LoadHarmonics &at_rest, const std::function<void(std::size_t)> &progress)
{
  const auto model = std::make_shared<ElasticFoot>(foot, study.glass.profile.contact_radius);
  RingLoad load = balanced_load(
    study, at_rest, model,
    [model, speed = study.motion.orbit.orbit_speed](double omega) { model->spin_per_speed = omega / speed; },
    [model, progress](const BalancedStates &states, CouplingFigures &figures)
    {
      figures.n_balances = states.size();
      figures.n_contact_solutions = model->n_solutions();
      if (progress)
        progress(states.size());
    });
  load.is_costly = true;
  return load;
}

RingLoad response_load(const Study &study, const std::shared_ptr<FootContact> &foot,
                       const fem::LoadHarmonics &at_rest)
{
  const FootResponseCurve response = measure_response(study, foot);
  RingLoad load = balanced_load(study, at_rest, response.curve, {},
                                [response](const BalancedStates &states, CouplingFigures &figures)
                                {
                                  figures.n_balances = states.size();
                                  figures.n_contact_solutions = response.n_solutions;
                                  figures.response_error = response.error;
                                });
  load.at_spin = [inside = load.at_spin](double omega)
  {
    try
    {
      return inside(omega);
    }
    catch (const std::out_of_range &failure)
    {
      throw std::runtime_error(std::string(failure.what()) + ", or set Load/Coupling = exact.");
    }
  };
  return load;
}

} // namespace

LoadAtSpin for_many_spins(const RingLoad &load, double lower, double upper)
{
  if (!load.is_costly || !(lower < upper))
    return load.at_spin;
  // With lift-off the load has a small kink wherever a line of contact is lost. The spins solved for one
  // tolerance serve the next.
  for (const double tolerance : { 1e-9, 1e-7, 1e-5 })
    try
    {
      const LoadCurve curve = sample_load_curve(load.at_spin, lower, upper, tolerance, 200);
      load.coupling->interpolation_error = curve.error;
      return [curve = curve.interpolate(), exact = load.at_spin, lower, upper](double omega)
      { return lower <= omega && omega <= upper ? curve(omega) : exact(omega); };
    }
    catch (const ToleranceMissed &)
    {
    }
  return load.at_spin;
}

bool follows_spin(const Study &study)
{
  return ring::friction_arm(study.motion.closure, study.motion.orbit) != 0 || study.friction_deforms_foot();
}

std::string frozen_note(const Study &study)
{
  const bool could_follow = !study.load.is_static() && follows_spin(study);
  return study.load.coupling == LoadCoupling::frozen && could_follow
           ? "the load is that of rest; Load/Coupling = exact follows it through the spin-up"
           : "";
}

RingLoad contact_load(const Study &study, const std::shared_ptr<FootContact> &foot,
                      const fem::LoadHarmonics &at_rest, const std::function<void(std::size_t)> &progress)
{
  if (study.load.coupling == LoadCoupling::response && !foot->is_isotropic())
    throw BadInput("Load/Coupling = response needs a load that depends on the moment ratio alone, but this "
                   "foot is not the "
                   "same in all directions; use Load/Coupling = exact.");
  if (study.load.coupling == LoadCoupling::frozen || !follows_spin(study))
    return frozen_contact_load(at_rest, study.glass.profile.contact_radius);
  return study.load.coupling == LoadCoupling::exact ? exact_load(study, foot, at_rest, progress)
                                                    : response_load(study, foot, at_rest);
}

} // namespace stemware::pipeline
