#include "fem/pipeline/coupling/phase_contact.h"

#include "fem/pipeline/coupling/coupled_load.h"
#include "fem/pipeline/study/study.h"
#include "ring_model/closures.h"

#include <algorithm>
#include <map>
#include <utility>

namespace stemware::pipeline
{

namespace
{

bool spin_matters(const Study &study)
{
  return study.load.coupling == LoadCoupling::exact &&
         (ring::friction_arm(study.motion.closure, study.motion.orbit) != 0 || study.friction_deforms_foot());
}

/// Contact loads phase by phase, each phase with its own balances of friction and moment.
class LoadsByPhase
{
public:
  LoadsByPhase(const Study &study, const std::shared_ptr<FootContact> &foot,
               const std::function<void(std::size_t)> &progress)
      : study(study)
      , foot(foot)
      , progress(progress)
  {
  }

  ring::AngularLoad at(double omega, const fem::FootPhase &phase)
  {
    foot->turn_to(phase);
    return of_phase(phase).at_spin(omega);
  }

  /// Of the phases asked for so far.
  void summarise(PhasedLoad &phased) const
  {
    phased.least_load = phased.load.minimum;
    phased.least_contact_fraction = phased.load.contact_fraction;
    for (const auto &[phase, load] : loads)
    {
      phased.least_load = std::min(phased.least_load, load.minimum);
      phased.least_contact_fraction = std::min(phased.least_contact_fraction, load.contact_fraction);
    }
  }

private:
  const RingLoad &of_phase(const fem::FootPhase &phase)
  {
    const std::pair<double, double> place(phase.glass, phase.table);
    const auto known = loads.find(place);
    if (known != loads.end())
      return known->second;
    const FootContactResult pressed = foot->solve(study.required_resultants(), 0, {});
    const auto count = [this](std::size_t)
    {
      if (progress)
        progress(++n_states);
    };
    return loads.emplace(place, contact_load(study, foot, pressed.load, count)).first->second;
  }

  const Study study;
  const std::shared_ptr<FootContact> foot;
  const std::function<void(std::size_t)> progress;
  std::map<std::pair<double, double>, RingLoad> loads;
  std::size_t n_states = 0;
};

} // namespace

PhasedLoad find_phased_load(const Study &study, const std::shared_ptr<FootContact> &foot,
                            const fem::LoadHarmonics &at_rest,
                            const std::function<void(std::size_t)> &progress)
{
  PhasedLoad phased = { nullptr, contact_load(study, foot, at_rest, progress), 0, 0 };
  const auto loads = std::make_shared<LoadsByPhase>(study, foot, progress);
  const LoadAtPhase exact = [loads](double omega, const fem::FootPhase &phase)
  { return loads->at(omega, phase); };
  const PhaseGrids grids = find_phases(exact, phase_periods(imperfection_of(study)));
  loads->summarise(phased);

  // Friction is not smooth where the rim is as fast as the glass: there intervals meet.
  const double spin_unit =
    spin_matters(study) ? study.motion.orbit.orbit_speed / phased.load.at_rest.radius() / 4 : 0;
  phased.at_phase = std::make_shared<PhaseLoads>(exact, grids, spin_unit);
  const auto for_mean =
    spin_unit > 0 ? std::make_shared<const PhaseLoads>(exact, grids.halved(), spin_unit) : phased.at_phase;
  phased.load.at_spin = [for_mean](double omega) { return for_mean->mean(omega); };
  return phased;
}

} // namespace stemware::pipeline
