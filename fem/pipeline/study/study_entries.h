#pragma once

#include "fem/pipeline/study/study.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace stemware::pipeline
{

/// Present value of an entry: number, count or text.
using EntryValue = std::variant<double, unsigned int, std::string>;

/// Entry of a study file with its facts, bound to the member of a Study that it sets.
struct StudyEntry
{
  std::string section;
  std::string name;
  std::string allowed;               ///< as part of a sentence: "a number greater than 0 (m)"
  std::string help;                  ///< sentences, units included
  std::string unit;                  ///< "1" for pure numbers, empty for words and paths
  double *quantity = nullptr;        ///< value of an entry of real numbers, else nullptr
  std::string *path_value = nullptr; ///< value of an entry of a path, else nullptr
  /// True if the value, unless given, follows from the points of a drawn section.
  bool follows_from_profile = false;
  // State of the study when its entries were requested:
  bool is_given = false;  ///< the study was given the entry (Study::given_entries)
  bool has_effect = true; ///< some result depends on the entry
  /// Plausible values for a glass on a table; other values give a warning only. Listed in docs/values.md.
  std::optional<std::pair<double, double>> plausible;
  std::string plausible_reason; ///< description of the two bounds
  /// Allowed range of a length over the contact radius; a length outside it probably has another unit.
  std::optional<std::pair<double, double>> times_contact_radius;
  std::function<EntryValue()> value; ///< the present value
  /// Sets the value from a text; returns false if it is not allowed.
  std::function<bool(const std::string &)> assign;
  std::shared_ptr<Study> study = {}; ///< the study, if the entry keeps it alive

  /// Returns the present value as written in a study file.
  std::string text() const;

  /// Returns Section/Entry, as in --set.
  std::string path() const { return section + '/' + name; }
};

/// Returns all entries in file order. @p study must outlive them and records assigned ones (given_entries).
std::vector<StudyEntry> study_entries(Study &study);

/// Returns the entries of a copy of @p study, which they keep alive.
std::vector<StudyEntry> entries_of(const Study &study);

/// Returns the entries of the default study, made once; not to be assigned.
const std::vector<StudyEntry> &default_entries();

/// Returns the names of the sections of @p entries, in order.
std::vector<std::string> sections_of(const std::vector<StudyEntry> &entries);

/// Returns the path of the entry @p word, given with or, if unique, without its section; else @p word.
std::string full_path(const std::vector<StudyEntry> &entries, const std::string &word);

/// Returns the entry of @p path, or of that name if unique. Throws BadInput with a suggestion for unknown
/// entries; the message begins with @p origin, the source of the path.
const StudyEntry &entry_at(const std::vector<StudyEntry> &entries, const std::string &origin,
                           const std::string &path);

/// Sets an entry from a text. Throws BadInput, beginning with @p origin, if the text is not allowed.
void assign(const StudyEntry &entry, const std::string &origin, const std::string &value);

/// Sets the entry_at() @p path from a text. Throws as entry_at() and for a text that is not allowed.
void assign(const std::vector<StudyEntry> &entries, const std::string &origin, const std::string &path,
            const std::string &value);

/// Returns a copy of entry_at() @p path of the default study.
StudyEntry find_entry(const std::string &origin, const std::string &path);

/// Returns @p message, written by a library of fem/, with names of entries replaced by their paths:
/// "Glass/Foot radius" for "foot radius". Replaces names of at least two words in the sections Glass, Table
/// and Contact.
std::string with_entries(const std::string &message);

} // namespace stemware::pipeline
