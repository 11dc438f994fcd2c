#pragma once

#include <string>
#include <utility>
#include <vector>

namespace stemware::pipeline
{

/// An entry of the study and the values that a sweep gives it, as a study file writes them.
struct VariedEntry
{
  std::string path; ///< Section/Entry
  std::vector<std::string> values;
  bool by_factors = false; ///< a range by equal factors
};

/// Reads what --vary was given:
///
///   Load/Moment ratio=0.1:1.9:50                from 0.1 to 1.9 in equal steps, 50 values
///   Table/Foundation modulus=1e8:1e12:20:log    by equal factors
///   Motion/Mass=200,250,300 g                   these; a unit behind the last one only holds for all
///   Motion/Closure=paper,hand,full              these
///
/// Numbers may have units, also in a range; the values are in SI units.
/// Values of a range are rounded to 15 digits, in equal steps to 15 digits of the larger end, so that a third
/// of the way from 0 to 0.9 is 0.3, and half the way from -0.3 to 0.3 is 0. Throws BadInput with one sentence
/// for anything else; whether the entry exists and takes the values is not looked at.
VariedEntry parse_varied_entry(const std::string &text);

/// The range that somebody may mean by a value in @p unit that is none: "0.1:0.5:5" for "0.1-0.5", "0.1..0.5"
/// and "0.1 to 0.5". Empty for everything else.
std::string range_meant_by(const std::string &value, const std::string &unit);

/// "Section/Entry=rest" in its two parts, without blanks around them. @p option is named in the BadInput that
/// is thrown for texts without them.
std::pair<std::string, std::string> split_assignment(const std::string &option, const std::string &text);

} // namespace stemware::pipeline
