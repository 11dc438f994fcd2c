#pragma once

#include "fem/pipeline/analysis/study_answer.h"
#include "fem/pipeline/result/results.h"
#include "fem/pipeline/study/study.h"

#include <optional>
#include <string>

/// Sentences of the answers of all verbs.

namespace stemware::pipeline
{

/// Returns a number with that common unit of the dimension @p unit that gives the shortest text: "300 g".
std::string in_usual_unit(double value, const std::string &unit);

/// Returns results with title (name of the study and @p what), inputs, sketch and entries.
Results begun_results(const Study &study, const std::string &what);

/// Appends a blank and @p sentence to @p text; nothing for an empty sentence.
void append(std::string &text, const std::string &sentence);

/// Returns "one-way " if the load at rest is used at every spin; empty otherwise.
std::string one_way_word(const LoadSection &load);

/// Returns @p sentence, which begins with a capital letter. If the load is one-way, "With the load at rest
/// kept at every spin (one-way), " or a similar clause is inserted before the sentence.
std::string under_its_load(const LoadSection &load, std::string sentence);

/// Returns the sense of a spin seen from above: "clockwise, against its orbit".
std::string sense_of(const ring::Motion &motion, double omega);

/// Returns a relative change of a spin as text: "2.5 % faster", "0.81 % slower".
std::string faster_or_slower(double change);

/// Returns a sentence on the effect of the harmonics beyond the first on tau_z of friction at half the
/// terminal spin, at its maximum, and at rest; empty without a terminal spin or further harmonics.
std::string torque_effect_sentence(const ring::TorqueEffects &effects);

/// Returns a sentence on the effect of the harmonics beyond the first on the terminal spin, with its @p band
/// [rad/s] if above a tenth of the effect; empty without an effect.
std::string harmonic_effect_sentence(const Study &study, const HarmonicEffect &effect,
                                     const std::optional<double> &band = {});

/// Returns sentences on a glass that tips during the spin-up (@p all has a `fall`).
std::string fall_sentences(const ring::Motion &motion, const ring::Answer &all);

/// Returns the texts of `run` by name: its answer, and remarks that are empty if they do not apply.
Json run_words(const StudyAnswer &run);

} // namespace stemware::pipeline
