#pragma once

#include "fem/pipeline/coupling/balanced_contact.h"
#include "fem/pipeline/coupling/elastic_foot.h"
#include "fem/pipeline/study/study.h"
#include "fem/revolution/compliance_cache.h"
#include "ring_model/spin/phases.h"

#include <functional>
#include <memory>
#include <string>

namespace stemware::pipeline
{

/// Makes the foot that a study asks for, on its table; answers depend on the study alone. It may share what
/// is the same with @p similar, nothing or a foot that is not asked while it solves.
using FootMaker = std::function<std::shared_ptr<fem::Foot>(const Study &, const fem::Foot *similar)>;

/// The foot of a study, by @p make_foot; nothing where the load does not come from a contact. Its contacts
/// start from what those of @p similar let expect, the foot of a study that differs little, if any. Throws as
/// @p make_foot.
std::shared_ptr<ElasticFoot> study_foot(const Study &study, const FootMaker &make_foot,
                                        Progress &progress = silent_progress(),
                                        const ElasticFoot *similar = nullptr);
/// The same by make_foot() with @p cache, which feet share; not in the live cut, which has no meshes.
std::shared_ptr<ElasticFoot> study_foot(const Study &study, fem::ComplianceCache &cache,
                                        Progress &progress = silent_progress(),
                                        const ElasticFoot *similar = nullptr);

/// True if @p failure is a contact or a balance that does not exist or was not found.
bool is_balance_failure(const std::exception &failure);

/// Throws ring::Tipping where the foot of a study tips at rest.
void require_no_tipping(const Study &study);

/// Number of phases at which a load is sampled that depends on them. Under a hard table each phase takes ten
/// times as long: there `coarse`, for what stands beside the answer, has a quarter of the samples of `full`.
enum class PhaseSampling
{
  full,
  coarse
};

/// The load of a study on the ring, from wherever Load/Source wants it, followed through the spin as
/// Load/Coupling wants it. @p foot is study_foot().
///
/// A contact is solved at rest. `one-way`, and with a given moment: that load at every spin. `two-way`: in
/// balance at every spin, where friction enters the moment that the table has to carry, the moment enters the
/// contact, the contact's load enters the friction (docs/theory/closures.md). Where the spin does not matter
/// to the load (a moment balance without the moment of friction, no friction that deforms the foot), that is
/// the load at rest. An out-of-flat rim or table is sampled over its phases.
///
/// @p progress must live as long as the load; both keep @p foot. Rings are placed where the contact carries
/// at rest and at @p expected, a spin near the terminal one [rad/s]; nothing: where the load of rest leads
/// to. Throws BadInput and fem::ContactFailure; the load throws as balance()'s.
SharedLoad find_load(const Study &study, const std::shared_ptr<ElasticFoot> &foot,
                     Progress &progress = silent_progress(), unsigned int n_harmonics = all_harmonics,
                     const std::optional<double> &expected = {}, PhaseSampling phases = PhaseSampling::full);

/// find_load() of a contact with the marks of glass and table at @p orientation: a study whose rim or table
/// is out of flat has a load of its own there.
SharedLoad find_load_at_phase(const Study &study, const std::shared_ptr<ElasticFoot> &foot,
                              const ring::Orientation &orientation, unsigned int n_harmonics = all_harmonics);

/// Returns the periods of a load on these surfaces: 2 pi over the greatest common divisor of their harmonics.
ring::PhasePeriods phase_periods(const fem::RimImperfection &imperfection);
/// The same of the study's surfaces and of the mesh of @p foot, which may be no body of revolution.
ring::PhasePeriods phase_periods(const Study &study, const ElasticFoot &foot);

/// The moment balance of a study with the marks of glass and table where they are at t = 0.
ContactBalance moment_balance(const Study &study);

/// The paper's load for a glass: a first harmonic on a ring of the contact radius, in balance with @p closure
/// at every spin; in closed form where the friction does not depend on the slip.
SharedLoad first_harmonic_load(const Study &study, ring::Closure closure);

/// Report on the load of a contact state; with its tilt where that is part of the moment balance.
LoadReport report_of(const fem::ContactState &state, double contact_radius, bool tilts);

/// True if the load is another one at every spin.
bool varies_with_spin(const Study &study);

/// True if the load of the study's foot depends on the spin: the moment balance lets friction act back, or
/// friction deforms the foot.
bool depends_on_spin(const Study &study);

/// A sentence for the console where the load is that of rest although the spin would change it; empty
/// elsewhere.
std::string frozen_note(const Study &study);

} // namespace stemware::pipeline
