#pragma once

#include "fem/pipeline/analysis/spin_study.h"
#include "fem/pipeline/report/render/report.h"

#include <nlohmann/json.hpp>

#include <optional>

/// Where a glass can end: all its terminal spins with their stability.
namespace stemware::pipeline
{

/// The terminal spins as a table with a sentence in front; nothing where there is only the one that is
/// reached from rest.
std::optional<ReportSection> terminal_spins_section(const SpinStudy &spin);

/// A sentence about terminal spins beside the one that is reached from rest; empty where there is none.
std::string terminal_spins_remark(const SpinStudy &spin);

/// "terminal_spins" of summary.json.
nlohmann::ordered_json terminal_spins_summary(const SpinStudy &spin);

} // namespace stemware::pipeline
