#pragma once

#include "fem/pipeline/analysis/refinement/refinement_study.h"
#include "fem/pipeline/output/render/report.h"
#include "fem/pipeline/study/study_options.h"

namespace stemware::pipeline
{

/// What the discretisation leaves open, as a section of a report.
ReportSection error_band_section(const std::vector<BandedFigure> &figures);

/// Bands of the amplitudes sqrt(a_n^2 + b_n^2) / a_0, n = 0 ... @p n_harmonics, 0 beyond those that are
/// followed; empty for no figures.
std::vector<double> spectrum_band(const std::vector<BandedFigure> &figures, unsigned int n_harmonics);

/// The report of `stemware converge`: the answer, one picture and one table for each axis, the bands.
Report converge_report(const StudyOptions &options, const RefinementResult &result);

} // namespace stemware::pipeline
