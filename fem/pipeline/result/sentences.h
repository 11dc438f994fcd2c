#pragma once

#include "fem/pipeline/analysis/budget.h"
#include "fem/pipeline/coupling/contact_report.h"
#include "fem/pipeline/study/study.h"
#include "ring_model/spin/answer.h"
#include "ring_model/spin/torque_effect.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

/// Sentences that several answers share, and the words in them.
namespace stemware::pipeline
{

/// Appends a sentence to @p text, with a blank between them. An empty sentence changes nothing.
void append(std::string &text, const std::string &sentence);

/// Returns whether the load at rest is used at every spin: Load/Coupling = one-way, a given moment, or a load
/// file.
bool is_one_way(const Study &study);

/// Returns "one-way " if is_one_way(), else an empty string.
std::string one_way_word(const Study &study);

/// Returns @p sentence (first letter a capital), preceded by the name of the one-way load if is_one_way().
std::string under_its_load(const Study &study, std::string sentence);

/// Returns the sense of a spin seen from above: "clockwise, against its orbit".
std::string sense_of(const Study &study, double omega);

/// Returns the duration of one turn [s].
double seconds_a_turn(double omega);

/// Returns a relative change of a spin as text: "2.5 % faster", "0.81 % slower".
std::string faster_or_slower(double change);

/// Returns a sentence on the effect of the harmonics beyond the first on tau_z of friction at half the
/// terminal spin, where it is largest, and at rest; empty without a terminal spin or such harmonics.
std::string torque_effect_sentence(const ring::TorqueEffects &effects);

/// Returns a sentence on the effect of the harmonics beyond the first on the terminal spin; empty without an
/// effect. The @p band of the effect [rad/s] is added if it exceeds a tenth of it.
std::string harmonic_effect_sentence(const Study &study, const HarmonicEffect &effect,
                                     const std::optional<double> &band = {});

/// Returns sentences on a glass that stands at rest and tips on the way, whose answer @p all has a fall.
std::string fall_sentences(const Study &study, const ring::Answer &all);

/// Returns one sentence for each of @p states (name of the state, load) with lift-off or a tensile load.
std::string lift_off_sentences(const std::vector<std::pair<std::string, const LoadReport *>> &states);

} // namespace stemware::pipeline
