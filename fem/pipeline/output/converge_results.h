#pragma once

#include "fem/pipeline/analysis/refinement/refinement_study.h"
#include "fem/pipeline/output/publish.h"

#include <filesystem>
#include <string>

/// What a refinement study has found, for eyes and for programs.
namespace stemware::pipeline
{

/// A band that is printed by itself, rounded up to two digits: "4.9e-06".
std::string band_text(double band);

/// Tables for the console: every axis with its levels and orders, then the bands.
std::string refinement_tables(const RefinementResult &result);

/// The answer in a sentence or two.
std::string refinement_answer(const RefinementResult &result);

/// "refinement" of summary.json with its axes, "error_bands", and the key figures of --json.
Findings refinement_findings(const RefinementResult &result);

/// {"omega_terminal": {"value", "band", "unit"}, ...}
nlohmann::ordered_json error_bands_as_json(const std::vector<BandedFigure> &figures);

/// converge_<axis>.dat, one row a level, and error_bands.dat.
void write_refinement_tables(const RefinementResult &result, const std::filesystem::path &folder);

} // namespace stemware::pipeline
