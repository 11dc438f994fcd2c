#pragma once

#include "fem/pipeline/coupling/foot_contact.h"
#include "fem/pipeline/coupling/phase_loads.h"
#include "fem/pipeline/coupling/ring_load.h"

#include <cstddef>
#include <functional>
#include <memory>

namespace stemware::pipeline
{

/// The load of a foot on a table, one of them out of flat, as Load/Coupling wants it at every phase. Spins
/// are added to it as they are asked for.
struct PhasedLoad
{
  std::shared_ptr<const PhaseLoads> at_phase;
  /// Its at_spin is the mean over all phases; everything else is the load as the glass starts, at rest and at
  /// the phase of t = 0.
  RingLoad load;
  double least_load = 0;             ///< pointwise, at rest, of all sampled phases [N/rad]
  double least_contact_fraction = 0; ///< at rest, of all sampled phases
};

/// Samples the contact of @p foot over phases; the result keeps it and turns it. @p at_rest is its load at
/// the phase of t = 0. @p progress is called with the number of balanced states after each new one. Throws as
/// contact_load() and find_phases().
PhasedLoad find_phased_load(const Study &study, const std::shared_ptr<FootContact> &foot,
                            const fem::LoadHarmonics &at_rest,
                            const std::function<void(std::size_t n_states)> &progress);

} // namespace stemware::pipeline
