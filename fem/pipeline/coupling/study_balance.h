#pragma once

#include "fem/pipeline/coupling/balanced_contact.h"
#include "fem/pipeline/coupling/elastic_foot.h"
#include "fem/pipeline/study/study.h"
#include "ring_model/spin/phases.h"

namespace stemware::pipeline
{

/// Returns the moment balance of a study with the marks of glass and table as at t = 0.
ContactBalance moment_balance(const Study &study, unsigned int n_harmonics = all_harmonics);

/// Returns the periods of a load, 2 pi over the greatest common divisor of the waviness harmonics [rad].
ring::PhasePeriods phase_periods(const fem::RimImperfection &imperfection);
/// Returns the periods of the waviness of a study, and of the mesh of its @p foot if it is not axisymmetric.
ring::PhasePeriods phase_periods(const ElasticFoot &foot);

} // namespace stemware::pipeline
