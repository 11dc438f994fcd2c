#pragma once

#include "fem/pipeline/study/study.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace stemware::pipeline
{

/// Numbers from least to most.
struct Interval
{
  double min = 0, max = 0;
  bool contains(double value) const { return min <= value && value <= max; }
};

/// The present value of an entry: a number, a number of things, or words.
using EntryValue = std::variant<double, unsigned int, std::string>;

/// One entry of a study file with all that is known of it, tied to the member of a Study that it sets.
struct StudyEntry
{
  std::string section;
  std::string name;
  std::string allowed;               ///< as part of a sentence: "a number greater than 0 (m)"
  std::string help;                  ///< sentences, units included
  std::string unit;                  ///< "1" for pure numbers, empty for words and paths
  double *quantity = nullptr;        ///< where the entry takes any number, not only whole ones: its value
  std::string *path_value = nullptr; ///< where the entry is a path: its value
  bool follows_from_profile = false; ///< from the points of a drawn section, where it is not given
  // The study as it was when its entries were asked for:
  bool is_given = false;  ///< the study was given the entry (Study::given_entries)
  bool has_effect = true; ///< a result of the study depends on the entry
  /// Values that a glass on a table has; with others a study is computed too, after a warning. docs/values.md
  /// shows them as a table.
  std::optional<Interval> plausible;
  std::string plausible_reason; ///< from what to what
  /// Range of a length over the contact radius: a study outside it, most likely in another unit, is refused.
  std::optional<Interval> times_contact_radius;
  std::function<EntryValue()> value; ///< the present value
  /// Sets the value from a text; false where it is not allowed.
  std::function<bool(const std::string &)> assign;
  std::shared_ptr<Study> study = {}; ///< where the entry keeps the study alive that it refers to

  /// The present value as a study file writes it.
  std::string text() const;

  /// Section/Entry, as in --set.
  std::string path() const { return section + '/' + name; }
};

/// All entries of @p study in the order of the study file. They refer to the study, which must outlive them
/// and remembers those that are assigned.
std::vector<StudyEntry> study_entries(Study &study);

/// The same of a copy of @p study, which lives as long as one of them.
std::vector<StudyEntry> entries_of(const Study &study);

/// Names of their sections, in that order.
std::vector<std::string> sections_of(const std::vector<StudyEntry> &entries);

/// The path of an entry that is named with its section or, if one entry alone has that name, without. Returns
/// any other @p word as it is.
std::string full_path(const std::vector<StudyEntry> &entries, const std::string &word);

/// The entry of that path, or of that name if one entry alone has it; throws BadInput, with a suggestion,
/// where there is none. @p origin begins the sentence: where the path comes from.
const StudyEntry &entry_at(const std::vector<StudyEntry> &entries, const std::string &origin,
                           const std::string &path);

/// Sets an entry from a text; throws BadInput where it does not take it. @p origin begins the sentence.
void assign(const StudyEntry &entry, const std::string &origin, const std::string &value);

/// Sets the entry of that path from a text; throws BadInput where there is none, or it does not take the
/// text.
void assign(const std::vector<StudyEntry> &entries, const std::string &origin, const std::string &path,
            const std::string &value);

/// The entry of that path; throws BadInput, with a suggestion, where there is none. @p option is named as
/// where it comes from.
StudyEntry find_entry(const std::string &option, const std::string &path);

} // namespace stemware::pipeline
