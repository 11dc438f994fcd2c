#pragma once

#include "fem/pipeline/base/progress.h"
#include "fem/pipeline/coupling/discretisation.h"
#include "fem/pipeline/coupling/elastic_foot.h"
#include "fem/pipeline/coupling/foot_load.h"
#include "fem/pipeline/coupling/study_balance.h"
#include "fem/pipeline/study/study.h"

#include <exception>
#include <functional>
#include <memory>
#include <string>

namespace stemware::pipeline
{

/// Makes the foot of a study on its table; results depend on the first three arguments only. The foot may
/// share data with @p similar (or nullptr), which must not be used while the foot solves.
using FootMaker = std::function<std::shared_ptr<fem::Foot>(const Study &, const Discretisation &,
                                                           const Model &, const fem::Foot *similar)>;

/// Returns the foot of a study, made by @p make_foot; nullptr for a load without a contact. Initial guesses
/// are predicted from the contacts of @p similar, if given. Throws as @p make_foot.
std::shared_ptr<ElasticFoot> study_foot(const Study &study, const FootMaker &make_foot,
                                        Progress &progress = silent_progress(),
                                        const ElasticFoot *similar = nullptr,
                                        const Discretisation &discretisation = {}, const Model &model = {});

/// Returns true if @p failure is a failed contact or balance.
bool is_balance_failure(const std::exception &failure);

/// Throws ring::Tipping if the foot of a study tips at rest.
void require_no_tipping(const Study &study);

/// Returns the load of a study on the ring, by Load/Source and Load/Coupling. @p foot: study_foot(), kept by
/// the load; its rings are chosen here if it has none. @p progress must outlive the load.
///
/// A contact is solved at rest. This load is used at every spin if the coupling is one-way, the moment is
/// given, or the spin does not affect the load (depends_on_spin()). Else contact, friction and moments are in
/// balance at every spin (docs/theory/closures.md). Loads with waviness are sampled over the phases.
///
/// Throws BadInput and fem::ContactFailure; the load throws NoBalance.
BalancedLoad find_load(const Study &study, const std::shared_ptr<ElasticFoot> &foot,
                       Progress &progress = silent_progress(), unsigned int n_harmonics = all_harmonics,
                       PhaseSampling phases = PhaseSampling::full);

/// Returns a first-harmonic load on a ring of the contact radius, in the balance @p closure at every spin.
BalancedLoad first_harmonic_load(const Study &study, ring::Closure closure);

/// Returns a sentence if the load at rest is used although it depends on the spin, else an empty string.
std::string frozen_note(const Study &study);

} // namespace stemware::pipeline
