#pragma once

#include "fem/pipeline/analysis/quantities_of_interest.h"
#include "fem/pipeline/analysis/ring_quantities.h"
#include "fem/pipeline/analysis/study_answer.h"
#include "fem/pipeline/result/results.h"

#include <string>
#include <vector>

/// Parts of summary.json, tables and data files of several verbs.
namespace stemware::pipeline
{

// ---- parts of summary.json

/// Returns "load" and "load_at_terminal" of summary.json.
const Fields<LoadReport> &load_fields();

/// Returns an entry of "error_bands" of summary.json; @p with_richardson: with the extrapolated value.
Fields<BandedQuantity> band_fields(bool with_richardson);

/// Returns the key of the quantity of a band.
std::string key_of_band(const BandedQuantity &banded);

/// Returns the rows of "truncation" of summary.json.
std::vector<Truncation> truncations_of(const StudyAnswer &answer);

/// Returns "load", "harmonic_effect", "torque_effect" and "truncation" of summary.json.
const Fields<StudyAnswer> &harmonics_fields();

/// Returns the summary of `run`.
const Fields<StudyAnswer> &run_fields();

// ---- tables of the page

/// Returns the page's numbers of the contact, one column each.
Table contact_list(const FootReport &foot);

/// Adds the table "truncations" and the picture "torque_changes".
void add_truncations(const StudyAnswer &answer, Results &results);

/// Adds the tables "bands" and "band_parts".
void add_band_tables(const std::vector<BandedQuantity> &bands, Results &results);

// ---- data files

/// Returns lambda(theta) round the rim: the sum of the rings, its first harmonic, and each of several rings.
Table load_table(const ring::RingStack &load);

/// Returns the coefficients of each ring: lambda_j(theta) = a_0 + sum a_n cos(n theta) + b_n sin(n theta).
Table ring_table(const ring::RingStack &load);

/// Returns the Fourier coefficients of a load, summed over its rings, for read_load_file(), with further
/// columns: amplitude over a_0, direction of the crest.
std::string load_file_text(const ring::RingStack &load);

/// Returns lambda(theta) at rest at the azimuths of the contact's lines, 0 on unloaded lines.
Table pointwise_table(const std::vector<fem::AzimuthLoad> &pointwise);

/// Returns p(r, theta), one row per point, cut by cut.
Table footprint_table(const fem::PressureMap &footprint);

/// Returns tau_z, T_x and T_y over the spin.
Table torque_table(const TorqueCurve &curve);

/// Returns omega(t) from rest.
Table spin_up_table(const SpinUpCurves &curves);

/// Returns omega(t) from rest at the speeds of Motion/Orbit speed file.
Table driven_spin_table(const DrivenSpinUp &driven);

/// Returns the torque over the phase (azimuths of the marks of glass and table in the slip frame).
Table phase_table(const PhaseStudy &phases);

/// Returns the effects of harmonics on tau_z over the spin.
Table torque_change_table(const ring::TorqueEffects &effects);

/// Returns the Newton steps of the contact at rest.
Table history_table(const std::vector<fem::ContactIteration> &history);

} // namespace stemware::pipeline
