#pragma once

#include "fem/pipeline/base/progress.h"
#include "fem/pipeline/coupling/balanced_contact.h"
#include "fem/pipeline/coupling/balanced_load.h"
#include "fem/pipeline/coupling/elastic_foot.h"
#include "fem/pipeline/study/study.h"
#include "ring_model/moment_balance.h"
#include "ring_model/motion.h"
#include "ring_model/spin/phases.h"

#include <memory>

namespace stemware::pipeline
{

/// Returns the moment balance of a study with the marks of glass and table as at t = 0.
ContactBalance moment_balance(const Study &study, unsigned int n_harmonics = all_harmonics);

/// Returns the periods of a load, 2 pi over the greatest common divisor of the waviness harmonics [rad].
ring::PhasePeriods phase_periods(const fem::RimImperfection &imperfection);
/// Returns the periods of the waviness of a study, and of the mesh of its @p foot if it is not axisymmetric.
ring::PhasePeriods phase_periods(const ElasticFoot &foot);

/// Returns the load of a study on the ring, by Load/Source and Load/Coupling. @p foot: study_foot() of
/// @p study, kept by the load; its rings are chosen here if it has none. @p progress must outlive the load.
///
/// A contact is solved at rest. This load is used at every spin if the coupling is one-way, the moment is
/// given, or the spin does not affect the load (Study::depends_on_spin()). Else contact, friction and moments
/// are in balance at every spin (docs/theory/closures.md). Loads with waviness are sampled over the phases;
/// with @p few_phases, for results other than the answer, a hard table has at most 16 phases instead of 32
/// (64 for a load that does not vary with the spin), because each phase takes ten times as long.
///
/// Throws BadInput and fem::ContactFailure; the load throws NoBalance.
BalancedLoad find_load(const Study &study, const std::shared_ptr<ElasticFoot> &foot,
                       Progress &progress = silent_progress(), unsigned int n_harmonics = all_harmonics,
                       bool few_phases = false);

/// Returns find_load() with the marks of glass and table at @p orientation, for a study with waviness.
BalancedLoad find_load_at_phase(const std::shared_ptr<ElasticFoot> &foot,
                                const ring::Orientation &orientation,
                                unsigned int n_harmonics = all_harmonics);

/// Returns a first-harmonic load on a ring of @p contact_radius [m], in the balance @p closure at every spin.
BalancedLoad first_harmonic_load(const ring::Motion &motion, ring::Closure closure, double contact_radius);

} // namespace stemware::pipeline
