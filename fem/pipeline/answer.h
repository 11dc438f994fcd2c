#pragma once

#include "fem/pipeline/study_result.h"

#include <optional>
#include <string>

namespace stemware::pipeline
{

/// The terminal spin of the study's glass beside those of simpler models of the same glass [rad/s].
struct SpinComparison
{
  double all_harmonics = 0;               ///< the study's own
  double first_harmonic = 0;              ///< of the first harmonic alone, in the same balance of moments
  std::optional<double> paper_closure;    ///< first harmonic, the paper's balance of moments
  std::optional<double> complete_closure; ///< first harmonic, closure `full`
  bool is_formal = false; ///< whether the last two, or one of them, would have to pull on the table

  /// What the harmonics beyond the first add to the spin, relative to the first alone; nothing where that
  /// does not spin.
  std::optional<double> harmonic_effect() const;
  /// What the closure `full` adds to the spin, relative to the closure `paper`.
  std::optional<double> closure_effect() const;
};

/// For a load in balance with friction at every spin, the first harmonic is in such a balance too; for a
/// frozen load it is the first harmonic of that load.
SpinComparison compare_spins(const Study &study, const StudyResult &result);

/// The same from its parts: the closures' own spins, and the terminal spin under all harmonics and under the
/// load cut off after the first.
SpinComparison compare_spins(const Study &study, const std::vector<ClosureRow> &closures,
                             double all_harmonics, double truncated);

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
