#pragma once

#include "fem/pipeline/analysis/refinement/quantities_of_interest.h"
#include "fem/pipeline/analysis/spin_study.h"
#include "fem/pipeline/coupling/contact_report.h"
#include "fem/pipeline/study/study.h"

#include <string>

/// Sentences of `run`: the answer, and remarks that are empty if they do not apply.
namespace stemware::pipeline
{

/// Answer: the spin of the glass beside the paper's, its band and its largest effects. @p bands are empty if
/// they have not been estimated.
std::string run_answer(const Study &study, const SpinStudy &spin, const ErrorBands &bands);

/// Scatter of the points of a profile about the circle of its rim.
std::string profile_remark(const Study &study);

/// Lift-off in the state that the spin is about, else at rest.
std::string lift_off_remark(const Study &study, const ContactReport &report, const SpinStudy &spin);

/// Largest pressure and contact width, at rest and at the terminal spin.
std::string contact_remark(const ContactReport &report, const SpinStudy &spin);

/// A contact that is at most a few nodes wide.
std::string narrow_contact_remark(const Study &study, const ContactReport &report);

/// A contact that is narrower than the layer of a Winkler interface is thick.
std::string thin_layer_remark(const Study &study, double half_width);

/// Swing of spin and torque on a rim or table that is out of flat.
std::string out_of_flat_remark(const Study &study, const SpinStudy &spin);

/// Number of terminal spins, if there are several.
std::string several_spins_remark(const SpinStudy &spin);

/// Spins under the speeds of a file beside those at constant speed.
std::string driven_remark(const SpinStudy &spin, const ErrorBands &bands);

} // namespace stemware::pipeline
