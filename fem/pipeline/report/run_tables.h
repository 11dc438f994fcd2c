#pragma once

#include "fem/pipeline/analysis/spin_study.h"
#include "fem/pipeline/coupling/contact_report.h"
#include "fem/pipeline/document/table.h"

#include <string>
#include <vector>

/// The data files of `run`.
namespace stemware::pipeline
{

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
