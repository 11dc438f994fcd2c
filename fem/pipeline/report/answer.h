#pragma once

#include "fem/pipeline/analysis/comparison.h"
#include "fem/pipeline/analysis/refinement/refinement_study.h"
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

/// The answer of `run`: the terminal spin in words (seen from above; with or against the orbit) and with its
/// error band, the paper's beside it, what the harmonics beyond the first do to it, the largest other step of
/// the budget, and what the band does not contain; what a quick run lacks, first. A one-way load is called so
/// in each sentence about it.
std::string run_answer(const Study &study, const SpinStudy &spin, const std::vector<BandedQuantity> &bands);

/// Whether the load of rest is kept at every spin: that of Load/Coupling = one-way, of a given moment, or of
/// a file.
bool is_one_way(const Study &study);

/// "The harmonics of the load beyond the first ", with "one-way" where the load is that: a sentence goes on.
std::string harmonics_subject(const Study &study);

/// "With the load of rest kept at every spin (one-way), "; empty for a load in balance.
std::string one_way_beginning(const Study &study);

/// Says what the harmonics of the load beyond the first do to the spin; empty where there is no such effect
/// to speak of.
std::string harmonic_effect_sentence(const Study &study, const HarmonicEffect &effect);

/// Says that the load has left part of the rim, or, where it is given, that it would have to pull; empty
/// where it does neither.
std::string lift_off_remark(const LoadReport &load, const std::string &state);

/// Says that the contact is narrower than what its nodes can show; empty where it is not.
std::string narrow_contact_remark(const Study &study, const std::optional<FootReport> &foot);

/// Says that the contact is narrower than the layer that the Winkler interface stands for, which is then no
/// such interface; empty where it is not, or no layer is named. @p half_width [m] is that of the contact.
std::string layer_remark(const Study &study, double half_width);

/// Says what an out-of-flat rim or table does to the spin; empty for flat ones.
std::string waviness_remark(const Study &study, const std::optional<PhaseStudy> &phases);

/// The answer of `truncate`: what the harmonics do to the terminal spin, and how many of them are enough.
std::string truncation_answer(const Study &study, const TruncationStudy &truncations);

/// The answer of `compare`: what the harmonics do to the terminal spin, beside what the paper's moment
/// balance leaves out.
std::string comparison_answer(const Comparison &comparison);

/// A load of `compare` by the name that it is shown with, which says what is one-way.
std::string name_of_load(const std::string &load);

/// The answer of `converge` in a sentence or two.
std::string refinement_answer(const RefinementResult &result);

/// The answer of `sweep` in two or three sentences.
std::string sweep_answer(const SweepPlan &plan, const SweepFindings &findings);

/// The least number of harmonics from which on the terminal spin stays within @p share of that of all, which
/// is the last of @p rows.
unsigned int harmonics_enough(const std::vector<SpinRow> &rows, double share);

/// The sentences that are not empty, with a blank between them.
std::string joined(const std::vector<std::string> &sentences);

/// @p value with as many digits as an error of @p band leaves certain, and the band: "-3.6489 ± 0.0002"; with
/// six digits where no band is known.
std::string with_band(double value, const std::optional<double> &band);

} // namespace stemware::pipeline
