#pragma once

#include "fem/pipeline/analysis/quantities_of_interest.h"
#include "fem/pipeline/analysis/spin_study.h"
#include "fem/pipeline/coupling/contact_report.h"
#include "fem/pipeline/study/study.h"

#include <string>

/// Sentences of `run`: the answer, and remarks that are empty if they do not apply.
namespace stemware::pipeline
{

/// Returns the answer: the spin of the glass next to the paper's, its band and its largest effects. @p bands
/// are empty if they were not estimated.
std::string run_answer(const Study &study, const SpinStudy &spin, const ErrorBands &bands);

/// Returns the scatter of the points of a profile about its rim circle.
std::string profile_remark(const Study &study);

/// Returns a remark on lift-off at the terminal spin if the glass spins, else at rest.
std::string lift_off_remark(const Study &study, const ContactReport &report, const SpinStudy &spin);

/// Returns a remark on the largest pressure and the contact width at rest and at the terminal spin, with
/// bands that exceed a tenth of the value; at rest only if the glass does not spin.
std::string contact_remark(const Study &study, const ContactReport &report, const SpinStudy &spin,
                           const ErrorBands &bands);

/// Returns a remark on a contact that is at most a few nodes wide.
std::string narrow_contact_remark(const Study &study, const ContactReport &report);

/// Returns a remark on a contact narrower than the thickness of a Winkler interface's layer.
std::string thin_layer_remark(const Study &study, double half_width);

/// Returns a remark on the ripple of spin and torque due to waviness.
std::string out_of_flat_remark(const Study &study, const SpinStudy &spin);

/// Returns a remark on the number of terminal spins if there are several.
std::string several_spins_remark(const SpinStudy &spin);

/// Returns a remark on the spins under the speeds of a file and at constant speed.
std::string driven_remark(const SpinStudy &spin, const ErrorBands &bands);

} // namespace stemware::pipeline
