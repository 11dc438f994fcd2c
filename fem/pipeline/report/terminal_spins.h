#pragma once

#include "fem/pipeline/analysis/spin_study.h"
#include "fem/pipeline/report/render/table.h"

#include <nlohmann/json.hpp>

/// Where a glass can end: all its terminal spins with their stability.
namespace stemware::pipeline
{

/// All of them for people: spin, stability, time constant, which one is reached from rest.
Table terminal_spins_table(const SpinStudy &spin);

/// "terminal_spins" of summary.json.
nlohmann::ordered_json terminal_spins_summary(const SpinStudy &spin);

} // namespace stemware::pipeline
