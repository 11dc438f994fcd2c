#include "fem/pipeline/study/study_notes.h"

#include "fem/pipeline/study/quantity_text.h"
#include "fem/pipeline/study/study_entries.h"
#include "fem/pipeline/support/failures.h"
#include "fem/pipeline/support/numbers.h"
#include "fem/pipeline/support/text.h"

#include <boost/algorithm/string/join.hpp>

#include <algorithm>
#include <cmath>

namespace stemware::pipeline
{

namespace
{

/// The entries that a study was given and that have an effect, or those that have none.
std::vector<StudyEntry> given_entries(Study &study, bool with_effect)
{
  std::vector<StudyEntry> given;
  for (const StudyEntry &entry : study_entries(study))
    if (study.given_entries.count(entry.path()) > 0 && entry.has_effect(study) == with_effect)
      given.push_back(entry);
  return given;
}

bool is_implausible(const StudyEntry &entry, double value)
{
  return entry.plausible && value != 0 && !entry.plausible->contains(value);
}

/// " m", empty for pure numbers.
std::string unit_behind_number(const StudyEntry &entry)
{
  return entry.unit == "1" ? "" : ' ' + entry.unit;
}

/// "Motion/Mass = 300 kg"
std::string assignment(const StudyEntry &entry, double value)
{
  return entry.path() + " = " + to_short_text(value) + unit_behind_number(entry);
}

/// "0.02 to 2 kg"
std::string plausible_text(const StudyEntry &entry)
{
  return to_short_text(entry.plausible->least) + " to " + to_short_text(entry.plausible->most) +
         unit_behind_number(entry);
}

} // namespace

std::vector<std::string> idle_entries(const Study &study)
{
  Study copy = study;
  std::vector<std::string> idle;
  for (const StudyEntry &entry : given_entries(copy, false))
    idle.push_back(entry.path());
  return idle;
}

std::string idle_note(const std::vector<std::string> &entries)
{
  return entries.empty() ? ""
                         : boost::join(entries, ", ") + (entries.size() == 1 ? " has" : " have") +
                             " no effect in this study.";
}

std::string implausible_note(const std::string &path, double value)
{
  const StudyEntry entry = find_entry("", path);
  if (!is_implausible(entry, value))
    return "";
  const std::string number = to_short_text(value);
  std::string meant;
  for (const std::string &usual : usual_units(entry.unit))
    if (const auto other = parse_quantity(number + ' ' + usual, entry.unit);
        meant.empty() && other && entry.plausible->contains(*other))
      meant = "write " + number + ' ' + usual + " if that is meant";
  return assignment(entry, value) + " is outside " + plausible_text(entry) + " for a glass; " +
         (meant.empty() ? "check number and unit" : meant) + '.';
}

std::vector<std::string> implausible_notes(const Study &study)
{
  Study copy = study;
  std::vector<std::string> notes;
  for (const StudyEntry &entry : given_entries(copy, true))
    if (entry.quantity != nullptr && is_implausible(entry, *entry.quantity))
      notes.push_back(implausible_note(entry.path(), *entry.quantity));
  return notes;
}

std::string implausible_list(const Study &study)
{
  Study copy = study;
  std::vector<std::string> list;
  for (const StudyEntry &entry : given_entries(copy, true))
    if (entry.quantity != nullptr && is_implausible(entry, *entry.quantity))
      list.push_back(assignment(entry, *entry.quantity) + " (" + plausible_text(entry) + ')');
  return boost::join(list, ", ");
}

void require_conceivable(const Study &study)
{
  constexpr double far = 1e9;
  Study copy = study;
  for (const StudyEntry &entry : study_entries(copy))
  {
    if (!entry.plausible || study.given_entries.count(entry.path()) == 0)
      continue;
    const auto [least, most] = *entry.plausible;
    const double size = std::abs(*entry.quantity);
    require(size <= far * std::max(std::abs(least), most) && (size == 0 || size >= least / far),
            filled("{} is more than a billion times outside {}, {}; check number and unit.",
                   { assignment(entry, *entry.quantity), plausible_text(entry), entry.plausible_reason }));
  }
}

void require_alike_lengths(const Study &study)
{
  const double radius = study.glass.profile.contact_radius;
  Study copy = study;
  for (const StudyEntry &entry : study_entries(copy))
    if (const auto &range = entry.times_contact_radius; range && entry.has_effect(study))
      require(
        range->contains(*entry.quantity / radius),
        filled(
          "{} = {} m is {} times Glass/Contact radius = {} m, but from {} to {} is allowed; give both in one "
          "unit.",
          { entry.path(), to_text(*entry.quantity), to_short_text(*entry.quantity / radius), to_text(radius),
            to_text(range->least), to_text(range->most) }));
}

} // namespace stemware::pipeline
