#pragma once

#include "fem/pipeline/coupling/balanced_contact.h"
#include "fem/pipeline/coupling/elastic_foot.h"
#include "fem/pipeline/study/study.h"
#include "ring_model/spin/phases.h"

namespace stemware::pipeline
{

/// Returns the moment balance of a study with the marks of glass and table at their positions at t = 0; @p
/// n_harmonics: ContactBalance::n_harmonics.
ContactBalance moment_balance(const Study &study, unsigned int n_harmonics = all_harmonics);

/// Returns whether find_load() gives a load that varies with the spin.
bool varies_with_spin(const Study &study);

/// Returns whether the spin affects the contact: the friction's moment enters the moment balance, or friction
/// deforms the foot.
bool depends_on_spin(const Study &study);

/// Returns the periods of a load with this waviness: 2 pi over the greatest common divisor of the harmonics.
ring::PhasePeriods phase_periods(const fem::RimImperfection &imperfection);
/// Returns the periods of the study's waviness and of the mesh of @p foot, which may lack axial symmetry.
ring::PhasePeriods phase_periods(const Study &study, const ElasticFoot &foot);

} // namespace stemware::pipeline
