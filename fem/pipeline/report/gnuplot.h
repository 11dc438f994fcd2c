#pragma once

#include "fem/pipeline/report/plot.h"

#include <filesystem>
#include <string>
#include <vector>

namespace stemware::pipeline
{

/// Warning before long work where no gnuplot can be found: the report will then have no pictures, but their
/// scripts and data. Empty where there is one.
std::string missing_plotter();

/// The text of a file of plots/: of the folder share/stemware that comes with the program, where it has one,
/// or else as it was compiled in. Throws std::logic_error for a file that there is not.
std::string plot_file_text(const std::string &name);

/// Writes figures/style.gnuplot, the drawings among @p plots and the scripts and data of the others into
/// @p folder, then lets gnuplot draw those, SVG and PDF side by side. A plot that fails costs the others
/// nothing. Returns one or more sentences on what could not be drawn and why; empty when everything was.
/// Throws OutputFailure.
std::string draw_plots(const std::vector<Plot> &plots, const std::filesystem::path &folder);

} // namespace stemware::pipeline
