#pragma once

#include "fem/pipeline/analysis/refinement/quantities_of_interest.h"
#include "fem/pipeline/analysis/spin_study.h"
#include "fem/pipeline/analysis/sweep/case_list.h"
#include "fem/pipeline/analysis/sweep/sweep_case.h"
#include "fem/pipeline/coupling/contact_report.h"
#include "fem/pipeline/document/document.h"
#include "fem/pipeline/study/data_files.h"

#include <optional>
#include <string>
#include <vector>

/// Numbers of the page's pictures: each function adds tables to a document, and to its words what stands
/// beside them. Angles in degrees, lengths of a section in mm.
namespace stemware::pipeline
{

/// Half-widths of the errors of sqrt(a_n^2 + b_n^2) / a_0 by n; 0 if not known, empty without @p bands.
std::vector<double> spectrum_band(const ErrorBands &bands, unsigned int n_harmonics);

/// "load_curves": load over its mean after 1, 2, 3 and all harmonics. "load_lines": the load where it was
/// solved, if the foot has lifted off. "spectrum": amplitudes with their error bands. @p sense_sign: of the
/// orbit.
void add_load_columns(const LoadReport &load, const std::vector<double> &band, double sense_sign,
                      Document &document);

/// "slip_at_rest" or another @p name: slip and friction round the rim.
void add_slip_columns(const std::string &name, const ring::Motion &motion, double radius,
                      const ring::RingStack &load, double omega, Document &document);

/// "torque" and "terminal_points": friction's torque of all harmonics and of up to 1, 2 and 3, and their
/// terminal spins.
void add_torque_columns(const TorqueCurve &curve, const std::vector<ring::Answer> &rows, Document &document);

/// "harmonic_torque": torque of all harmonics and of the first, and their difference.
void add_harmonic_torque_columns(const Budget &budget, Document &document);

/// "spin_up", and "measured" for the points of a file.
void add_spin_up_columns(const SpinUpCurves &curves, const std::vector<MeasuredSpin> &measured,
                         Document &document);

/// "phases": torque by the place of the mark of the glass or the table.
void add_phase_columns(const PhaseStudy &phases, Document &document);

/// "foot": pressures, stresses, section and rim, as far as they are known.
void add_foot_pictures(const Study &study, const FootReport &foot, Document &document);

/// "pictures" of a sweep over a grid: curves over an entry of numbers, one for each value of the other entry,
/// or maps over two entries of four values or more. No pictures for a list from a file and for words only.
void add_sweep_pictures(const CaseList &list, const FinishedCases &finished, Document &document);

} // namespace stemware::pipeline
