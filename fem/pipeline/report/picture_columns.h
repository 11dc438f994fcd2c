#pragma once

#include "fem/pipeline/analysis/spin_study.h"
#include "fem/pipeline/answer/case_list.h"
#include "fem/pipeline/answer/sweep_case.h"
#include "fem/pipeline/document/document.h"
#include "fem/pipeline/feet/contact_report.h"
#include "fem/pipeline/input/data_files.h"
#include "fem/pipeline/refinement/quantities_of_interest.h"

#include <optional>
#include <string>
#include <vector>

/// Numbers of the page's pictures: each function adds tables to a document and captions to its words. Angles
/// in degrees, lengths of a section in mm.
namespace stemware::pipeline
{

/// Returns the half-widths of the errors of sqrt(a_n^2 + b_n^2) / a_0 by n; 0 if unknown, empty without @p
/// bands.
std::vector<double> spectrum_band(const ErrorBands &bands, unsigned int n_harmonics);

/// Adds "load_curves": load over its mean with 1, 2, 3 and all harmonics; "load_lines": pointwise load on the
/// azimuth lines, if the foot has lifted off; "spectrum": amplitudes with error bands. @p sense_sign: sign of
/// the orbit.
void add_load_columns(const LoadReport &load, const std::vector<double> &band, double sense_sign,
                      Document &document);

/// Adds "slip_at_rest" or another @p name: slip and friction round the rim.
void add_slip_columns(const std::string &name, const ring::Motion &motion, double radius,
                      const ring::RingStack &load, double omega, Document &document);

/// Adds "torque" and "terminal_points": torque of friction with 1, 2, 3 and all harmonics, and the terminal
/// spins.
void add_torque_columns(const TorqueCurve &curve, const std::vector<ring::Answer> &rows, Document &document);

/// Adds "harmonic_torque": torque with all harmonics and with the first only, and their difference.
void add_harmonic_torque_columns(const Budget &budget, Document &document);

/// Adds "spin_up", and "measured" for the points of a file.
void add_spin_up_columns(const SpinUpCurves &curves, const std::vector<MeasuredSpin> &measured,
                         Document &document);

/// Adds "phases": torque over the azimuth of the mark of the glass or the table.
void add_phase_columns(const PhaseStudy &phases, Document &document);

/// Adds "foot": pressures, stresses, section and rim, if known.
void add_foot_pictures(const Study &study, const FootReport &foot, Document &document);

/// Adds "pictures" of a sweep over a grid: curves over a numerical entry, one for each value of the other
/// entry, or maps over two numerical entries with four or more values. None for a list from a file and for
/// words only.
void add_sweep_pictures(const CaseList &list, const FinishedCases &finished, Document &document);

} // namespace stemware::pipeline
