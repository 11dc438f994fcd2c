#pragma once

#include "fem/pipeline/study/study.h"

#include <string>
#include <vector>

namespace stemware::pipeline
{

/// Values of an entry that a glass on a table has, in the entry's unit; with others a study is computed too,
/// after a warning. docs/values.md shows the same table.
struct PlausibleRange
{
  std::string path; ///< Section/Entry
  double least = 0, most = 0;
  std::string reason; ///< from what to what
};

const std::vector<PlausibleRange> &plausible_ranges();

/// One sentence if @p value, in SI units, lies outside the range of that entry: "Motion/Mass = 300 kg is
/// outside 0.02 to 2 kg for a glass; write 300 g if grams are meant." Empty otherwise, and for the 0 of what
/// may be left out.
std::string implausible_note(const std::string &path, double value);

/// Throws BadInput with one sentence where a value that the study was given is more than a billion times
/// outside its range: no unit is meant there, and the computation would overflow.
void require_conceivable(const Study &study);

/// Such a sentence for each entry that the study was given (Study::given_entries) and that has an effect.
std::vector<std::string> implausible_notes(const Study &study);

/// The same entries in one line, with what glasses have: "Motion/Mass = 300 kg (0.02 to 2 kg), Motion/Orbit
/// speed = 35 m/s (0.01 to 3 m/s)". Empty where there are none.
std::string implausible_list(const Study &study);

} // namespace stemware::pipeline
