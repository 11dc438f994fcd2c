#pragma once

#include "fem/pipeline/analysis/budget.h"
#include "fem/pipeline/analysis/spin_study.h"
#include "fem/pipeline/document/document.h"
#include "fem/pipeline/feet/contact_report.h"
#include "fem/pipeline/refinement/quantities_of_interest.h"
#include "fem/pipeline/study/study.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <utility>
#include <vector>

/// Tables and data files of `run` and other verbs.
namespace stemware::pipeline
{

// ---- tables of the page

/// Columns of the effect of harmonics on tau_z and on the terminal spin, for people.
inline constexpr char truncation_keys[] = "harmonics change_half change_half_relative change_terminal "
                                          "change_terminal_relative rest_terminal bound omega_terminal "
                                          "spin_change";

/// Returns truncation_rows() that matter: those whose rest of tau_z exceeds 1e-9 of the torque at rest, and
/// all harmonics; rounding is 0.
nlohmann::ordered_json shown_truncations(const nlohmann::ordered_json &rows);

/// Adds @p rows, truncation_rows(), as "truncation" of summary.json, as the table "truncations" and, with the
/// curves of @p effects, as the picture "torque_changes".
void add_truncations(const nlohmann::ordered_json &rows, const ring::TorqueEffects &effects,
                     Document &document);

/// Adds the tables "bands" and "band_parts".
void add_bands(const std::vector<BandedQuantity> &bands, Document &document);

// ---- parts of summary.json

/// Returns "load" or "load_at_terminal" of summary.json: a_n and b_n of each ring beside its radius and of
/// their sum.
nlohmann::ordered_json load_summary(const LoadReport &load);

/// Returns quantities of interest with error bands and Richardson values, for display.
nlohmann::ordered_json band_rows(const std::vector<BandedQuantity> &bands);

/// Returns "error_bands" of summary.json: value, half-width, its parts (null if not estimated) and unit of
/// each quantity.
nlohmann::ordered_json band_summary(const std::vector<BandedQuantity> &bands);

// ---- data files

/// Returns lambda(theta) round the rim: sum of the rings, its first harmonic, and each ring if there are
/// several.
Table load_table(const ring::RingStack &load);

/// Returns the table of Fourier coefficients ring by ring: lambda_j(theta) = a_0 + sum a_n cos(n theta) + b_n
/// sin(n theta); the load is the sum of the rings.
Table ring_table(const ring::RingStack &load);

/// Returns the Fourier coefficients of a load, summed over its rings, in the format of read_load_file(): ring
/// radius, then rows n a_n b_n; further columns: amplitude over a_0, direction of the crest.
std::string load_file_text(const ring::RingStack &load);

/// Returns the table of lambda(theta) at rest at the azimuths of the contact's lines, 0 on unloaded lines.
Table pointwise_table(const std::vector<fem::AzimuthLoad> &pointwise);

/// Returns p(r, theta): one row per point, cut by cut.
Table footprint_table(const fem::PressureMap &footprint);

/// Returns the table of tau_z, T_x and T_y over the spin.
Table torque_table(const TorqueCurve &curve);

/// Returns the table of omega(t) from rest.
Table spin_up_table(const SpinUpCurves &curves);

/// Returns the table of omega(t) from rest with the speeds of Motion/Orbit speed file.
Table driven_spin_table(const DrivenSpinUp &driven);

/// Returns the torque over the phase (positions of the marks of glass and table in the slip frame).
Table phase_table(const PhaseStudy &phases);

/// Returns the answer by number of harmonics, from "truncation" of summary.json.
Table truncation_table(const nlohmann::ordered_json &truncation);

/// Returns the effects of harmonics on tau_z against the spin.
Table torque_change_table(const ring::TorqueEffects &effects);

/// Returns the table of the Newton steps of the contact at rest.
Table history_table(const std::vector<fem::ContactIteration> &history);

} // namespace stemware::pipeline
