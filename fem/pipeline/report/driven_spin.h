#pragma once

#include "fem/pipeline/analysis/spin_study.h"
#include "fem/pipeline/report/render/table.h"

/// The spin-up under a hand that is no motor, beside that at constant speed.
namespace stemware::pipeline
{

/// driven_spin_up.csv.
Table driven_spin_table(const DrivenSpinUp &driven);

/// "driven" of summary.json.
nlohmann::ordered_json driven_spin_summary(const DrivenSpinUp &driven);

} // namespace stemware::pipeline
