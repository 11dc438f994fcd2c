#pragma once

#include "fem/pipeline/analysis/spin_comparison.h"

#include <optional>
#include <string>

namespace stemware::pipeline
{

/// The answer in sentences: the terminal spin, what the harmonics beyond the first do to it, and what the
/// paper's balance of moments leaves out does to it; the spin with its error band where one is known.
std::string answer(const Study &study, const StudyResult &result);

/// Says, after a blank, what the paper's balance of moments leaves out does to the spin of a first-harmonic
/// load; empty where one of the two spins does not exist.
std::string closure_sentence(const SpinComparison &spins);

/// Says that the load has left part of the rim, so that its first harmonic would have to pull; empty where it
/// has not.
std::string lift_off_remark(const RingLoad &load);

/// Says that the contact is narrower than what its nodes can show; empty where it is not.
std::string narrow_contact_remark(const Study &study, const std::optional<ContactFigures> &contact);

/// Says what an out-of-flat rim or table does to the spin; empty for flat ones.
std::string waviness_remark(const Study &study, const std::optional<PhaseFigures> &phases);

/// @p value with as many digits as a spread of @p spread leaves meaningful: to two digits of the spread.
std::string to_spread(double value, double spread);

/// @p value with as many digits as an error of @p band leaves certain, and the band: "-3.6489 ± 0.0002"; with
/// six digits where no band is known.
std::string with_band(double value, const std::optional<double> &band);

} // namespace stemware::pipeline
