#pragma once

#include "fem/pipeline/analysis/comparison.h"
#include "fem/pipeline/analysis/refinement/refinement_study.h"
#include "fem/pipeline/analysis/spin_comparison.h"
#include "fem/pipeline/analysis/spin_study.h"
#include "fem/pipeline/analysis/sweep/sweep_findings.h"
#include "fem/pipeline/analysis/truncation.h"
#include "fem/pipeline/coupling/contact_report.h"

#include <optional>
#include <string>
#include <vector>

/// What the results say in sentences.
namespace stemware::pipeline
{

/// The answer of `run`: the terminal spin, what the harmonics beyond the first do to it, and what the paper's
/// moment balance leaves out; the spin with its error band where one is known.
std::string run_answer(const Study &study, const ContactReport &report, const SpinStudy &spin,
                       const std::vector<BandedQuantity> &bands);

/// Says what the paper's moment balance leaves out does to the spin of a first-harmonic load; empty where one
/// of the two spins does not exist. @p closures as SpinStudy::closures.
std::string closure_sentence(const std::vector<SpinRow> &closures);

/// Says that the load has left part of the rim, so that its first harmonic would have to pull; empty where it
/// has not.
std::string lift_off_remark(const LoadReport &load);

/// Says that the contact is narrower than what its nodes can show; empty where it is not.
std::string narrow_contact_remark(const Study &study, const std::optional<FootReport> &foot);

/// Says what an out-of-flat rim or table does to the spin; empty for flat ones.
std::string waviness_remark(const Study &study, const std::optional<PhaseStudy> &phases);

/// The answer of `truncate`: what the harmonics do to the terminal spin, how many of them are enough, and
/// what the paper's moment balance leaves out.
std::string truncation_answer(const TruncationStudy &study);

/// The answer of `compare`: what the harmonics do to the terminal spin, beside what the paper's moment
/// balance leaves out.
std::string comparison_answer(const Comparison &comparison);

/// The answer of `converge` in a sentence or two.
std::string refinement_answer(const RefinementResult &result);

/// The answer of `sweep` in two or three sentences.
std::string sweep_answer(const SweepPlan &plan, const SweepFindings &findings);

/// Position of the quantity with that key; throws std::out_of_range where there is none.
std::size_t index_of(const std::vector<BandedQuantity> &quantities, const std::string &key);

/// The least number of harmonics from which on the terminal spin stays within @p share of that of all.
unsigned int harmonics_enough(const TruncationTable &table, double share);

/// The sentences that are not empty, with a blank between them.
std::string joined(const std::vector<std::string> &sentences);

/// @p value with as many digits as an error of @p band leaves certain, and the band: "-3.6489 ± 0.0002"; with
/// six digits where no band is known.
std::string with_band(double value, const std::optional<double> &band);

} // namespace stemware::pipeline
