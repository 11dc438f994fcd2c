#pragma once

#include "fem/pipeline/analysis/budget.h"
#include "fem/pipeline/analysis/refinement/quantities_of_interest.h"
#include "fem/pipeline/analysis/spin_study.h"
#include "fem/pipeline/coupling/contact_report.h"
#include "fem/pipeline/report/document.h"
#include "fem/pipeline/study/study.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <utility>
#include <vector>

/// Facts, tables, sections and data files of `run` and other verbs. Facts are flags, words and derived
/// numbers for sentences beside the findings, by the names that the templates give them.
namespace stemware::pipeline
{

/// Whether the load of rest is kept at every spin: that of Load/Coupling = one-way, of a given moment, or of
/// a file.
bool is_one_way(const Study &study);

/// one_way, given_load, given_moment.
nlohmann::ordered_json study_facts(const Study &study);

/// omega, its size, sense ("clockwise, against its orbit", seen from above), seconds_a_turn and
/// turns_a_second.
nlohmann::ordered_json spin_facts(const Study &study, double omega);

/// absolute, relative ("2.5 % faster"), is_small and the rounding below which it is; null without an effect.
nlohmann::ordered_json effect_facts(const Study &study, const HarmonicEffect &effect);

/// state, least, share, moment_ratio, pulls, above_one of each of @p states, a load by the words for its
/// state, that has left part of the rim or, where it is given, would have to pull.
nlohmann::ordered_json lift_off_facts(const std::vector<std::pair<std::string, const LoadReport *>> &states);

/// "2.5 % faster", "0.81 % slower".
std::string faster_or_slower(double change);

// ---- sections

/// The load at rest: its plots, its tables and its files.
void add_load(const Study &study, const LoadReport &load, const ErrorBands &bands, Document &document);

/// Adds the chain of models for the templates "chain" and "chain_on_console": row by row and with its rows of
/// harmonics as one, and "waterfall", "effects" and "harmonic_torque".
void add_chain(const Study &study, const Budget &budget, Document &document);

/// Adds the answer by the number of harmonics for the template "truncations": "truncation" of summary.json,
/// its picture, and as "shown_truncations" the rows that change something, below them all harmonics on @p
/// one_ring.
void add_truncations(const std::vector<SpinRow> &rows, const std::optional<SpinRow> &one_ring,
                     Document &document);

/// Adds the tables for the template "error_bands".
void add_bands(const std::vector<BandedQuantity> &bands, Document &document);

/// "load" and "load_at_terminal" of summary.json: a_n and b_n of each ring beside its radius and of their
/// sum.
nlohmann::ordered_json load_summary(const LoadReport &load);

/// Quantities of interest with their error bands and Richardson values, for people.
nlohmann::ordered_json band_rows(const std::vector<BandedQuantity> &bands);

/// "error_bands" of summary.json: value, half-width, what it is made of (null where a part was not estimated)
/// and unit of each quantity.
nlohmann::ordered_json band_summary(const std::vector<BandedQuantity> &bands);

// ---- data files

/// lambda(theta), round the rim: the sum of the rings, its first harmonic, and each ring where there are
/// several.
Table load_table(const ring::RingStack &load);

/// Fourier coefficients ring by ring: lambda_j(theta) = a_0 + sum a_n cos(n theta) + b_n sin(n theta); the
/// load is the sum of the rings.
Table ring_table(const ring::RingStack &load);

/// The Fourier coefficients of a load, sums over its rings, as a file that read_load_file() reads: ring
/// radius, then rows n a_n b_n, with amplitude over a_0 and direction of the crest as further columns.
std::string load_file_text(const ring::RingStack &load);

/// lambda(theta) at rest at the azimuths of the contact's lines, 0 where they carry none.
Table pointwise_table(const std::vector<fem::AzimuthLoad> &pointwise);

/// p(r, theta): a row for each place, cut by cut.
Table footprint_table(const fem::PressureMap &footprint);

/// tau_z, T_x and T_y over the spin.
Table torque_table(const TorqueCurve &curve);

/// omega(t) from rest.
Table spin_up_table(const SpinUpCurves &curves);

/// omega(t) from rest with the speeds of Motion/Orbit speed file.
Table driven_spin_table(const DrivenSpinUp &driven);

/// The torque over the phase: where the marks of glass and table stand in the slip frame.
Table phase_table(const PhaseStudy &phases);

/// Newton steps of the contact at rest.
Table history_table(const std::vector<fem::ContactIteration> &history);

} // namespace stemware::pipeline
