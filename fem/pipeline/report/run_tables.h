#pragma once

#include "fem/pipeline/analysis/spin_study.h"
#include "fem/pipeline/coupling/contact_report.h"
#include "fem/pipeline/report/render/table.h"

#include <string>
#include <vector>

/// The tables of `run`.
namespace stemware::pipeline
{

/// Size of the finite-element system and residuals of the contact at rest: one row.
Table contact_table(const FootReport &foot);

/// Friction of the table on the glass at rest, then at the terminal spin; values below 1e-12 of mu N and mu N
/// R are shown as 0.
Table friction_table(const Study &study, const SpinRow &all);

/// lambda(theta), round the rim: the sum of the rings, its first harmonic, and each ring where there are
/// several.
Table load_table(const ring::RingStack &load);

/// Fourier coefficients ring by ring.
Table ring_table(const ring::RingStack &load);

/// The Fourier coefficients of a load, sums over its rings, as a file that read_load_file() reads: ring
/// radius, then rows n a_n b_n, with amplitude over a_0 and direction of the crest as further columns.
std::string load_file_text(const ring::RingStack &load);

/// lambda(theta) at rest where the contact was solved.
Table pointwise_table(const std::vector<fem::AzimuthLoad> &pointwise);

/// p(r, theta): a row for each place, cut by cut.
Table footprint_table(const fem::PressureMap &footprint);

/// tau_z, T_x and T_y over the spin.
Table torque_table(const TorqueCurve &curve);

/// omega(t) from rest.
Table spin_up_table(const SpinUpCurves &curves, const std::optional<CouplingStatistics> &coupling);

/// The torque over the orientations of glass and table.
Table phase_table(const PhaseStudy &phases);

/// Newton steps of the contact at rest.
Table history_table(const std::vector<fem::ContactIteration> &history);

} // namespace stemware::pipeline
