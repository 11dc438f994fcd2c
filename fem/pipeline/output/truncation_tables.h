#pragma once

#include "fem/pipeline/analysis/truncation_study.h"
#include "fem/pipeline/output/publish.h"

#include <string>

namespace stemware::pipeline
{

/// All numbers of one table of answers, as a table of results; missing ones are nan.
std::string truncation_data(const TruncationStudy &study, const TruncationTable &table);

/// omega(t) by the number of harmonics, as a table of results.
std::string spin_up_data(const TruncationStudy &study, const TruncationTable &table);

/// What stands in summary.json: the load at rest, "truncation" and "truncation_self_consistent" (null where
/// there is none) as rows with at least the keys of `run`, and the key figures.
Findings truncation_findings(const Study &study, const RingLoad &load, const TruncationStudy &result);

/// What the harmonics do to the terminal spin, beside what the paper's balance of moments leaves out, in
/// sentences.
std::string truncation_answer(const Study &study, const TruncationStudy &result);

/// Both tables for the console.
std::string truncation_text(const TruncationStudy &result);

/// The change of spin for people: nothing but 0 where it is rounding.
std::string shown_change(const TruncatedAnswer &answer);

/// A torque for people [N m]: 0 where it is rounding beside the torque at rest, a dash where there is none.
std::string shown_torque(const TruncationTable &table, double torque);

/// A deviation of omega(t) for people [rad/s]: 0 where it is rounding.
std::string shown_deviation(const TruncationTable &table, const std::optional<double> &deviation);

/// The bound for people [N m]: 0 where nothing is left out.
std::string shown_bound(const TruncatedAnswer &answer);

/// The least number of harmonics from which on the terminal spin stays within @p share of that of all.
unsigned int harmonics_enough(const TruncationTable &table, double share);

} // namespace stemware::pipeline
