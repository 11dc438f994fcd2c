#pragma once

#include "fem/pipeline/output/render/report.h"

#include <filesystem>
#include <string>
#include <vector>

namespace stemware::pipeline
{

/// Writes figures/style.gnuplot and the scripts and data of @p plots into @p folder, then lets gnuplot draw
/// all of them, SVG and PDF side by side. A plot that fails costs the others nothing. Returns one or more
/// sentences on what could not be drawn and why; empty when everything was. Throws OutputFailure.
std::string draw_plots(const std::vector<Plot> &plots, const std::filesystem::path &folder);

/// A text as gnuplot's quoted string that shows these characters, whatever they mean to gnuplot, with the
/// subscripts of with_subscripts().
std::string gnuplot_text(const std::string &text);

} // namespace stemware::pipeline
