#pragma once

#include "fem/pipeline/analysis/budget.h"
#include "fem/pipeline/coupling/contact_report.h"
#include "fem/pipeline/study/study.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <utility>
#include <vector>

/// Facts for sentences of several verbs, beside the findings: flags, words and derived numbers, by the names
/// that the templates give them.
namespace stemware::pipeline
{

/// Whether the load of rest is kept at every spin: that of Load/Coupling = one-way, of a given moment, or of
/// a file.
bool is_one_way(const Study &study);

/// one_way, given_load, given_moment.
nlohmann::ordered_json study_facts(const Study &study);

/// omega, its size, sense ("clockwise, against its orbit", seen from above), seconds_a_turn and
/// turns_a_second.
nlohmann::ordered_json spin_facts(const Study &study, double omega);

/// absolute, relative ("2.5 % faster"), is_small and the rounding below which it is; null without an effect.
nlohmann::ordered_json effect_facts(const Study &study, const HarmonicEffect &effect);

/// state, least, share, moment_ratio, pulls, above_one of each of @p states, a load by the words for its
/// state, that has left part of the rim or, where it is given, would have to pull.
nlohmann::ordered_json lift_off_facts(const std::vector<std::pair<std::string, const LoadReport *>> &states);

/// "2.5 % faster", "0.81 % slower".
std::string faster_or_slower(double change);

} // namespace stemware::pipeline
