#pragma once

#include "fem/pipeline/coupling/balanced_contact.h"
#include "fem/pipeline/coupling/elastic_foot.h"
#include "fem/pipeline/study/study.h"
#include "ring_model/spin/phases.h"

namespace stemware::pipeline
{

/// Returns the moment balance of a study with the marks of glass and table as at t = 0.
ContactBalance moment_balance(const Study &study, unsigned int n_harmonics = all_harmonics);

/// Returns true if find_load() returns a load that varies with the spin.
bool varies_with_spin(const Study &study);

/// Returns true if the spin affects the contact: friction enters the moment balance or deforms the foot.
bool depends_on_spin(const Study &study);

/// Returns the periods of a load, 2 pi over the greatest common divisor of the waviness harmonics [rad].
ring::PhasePeriods phase_periods(const fem::RimImperfection &imperfection);
/// Returns the periods of the study's waviness, and of the mesh of @p foot if it is not axisymmetric.
ring::PhasePeriods phase_periods(const Study &study, const ElasticFoot &foot);

} // namespace stemware::pipeline
