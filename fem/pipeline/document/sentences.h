#pragma once

#include "fem/pipeline/analysis/budget.h"
#include "fem/pipeline/coupling/contact_report.h"
#include "fem/pipeline/study/study.h"

#include <string>
#include <utility>
#include <vector>

/// Sentences that several answers share, and the words in them.
namespace stemware::pipeline
{

/// Appends a sentence to @p text, with a blank between them. An empty sentence changes nothing.
void append(std::string &text, const std::string &sentence);

/// True if the load of rest acts at every spin: Load/Coupling = one-way, a given moment, or a load file.
bool is_one_way(const Study &study);

/// "one-way " if the load of rest acts at every spin, else empty.
std::string one_way_word(const Study &study);

/// A @p sentence that begins with a capital letter, behind the words that say which one-way load acts, if one
/// does.
std::string under_its_load(const Study &study, std::string sentence);

/// Sense of a spin, seen from above: "clockwise, against its orbit".
std::string sense_of(const Study &study, double omega);

/// Duration of one turn [s].
double seconds_a_turn(double omega);

/// Relative change of a spin: "2.5 % faster", "0.81 % slower".
std::string faster_or_slower(double change);

/// Effect of the harmonics beyond the first on the terminal spin. Empty without an effect.
std::string harmonic_effect_sentence(const Study &study, const HarmonicEffect &effect);

/// One sentence for each of @p states, a load by the words for its state, that has left part of the table
/// or would have to pull.
std::string lift_off_sentences(const std::vector<std::pair<std::string, const LoadReport *>> &states);

} // namespace stemware::pipeline
