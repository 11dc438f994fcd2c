#pragma once

#include "fem/pipeline/study/quantity_text.h"
#include "fem/pipeline/study/study_entries.h"
#include "fem/pipeline/support/numbers.h"
#include "fem/pipeline/support/text.h"

#include <boost/algorithm/string/predicate.hpp>

#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace stemware::pipeline
{

/// Numbers that an entry takes, with the words for it.
struct Range
{
  std::string words;
  std::function<bool(double)> contains;
};

inline const Range any_number = { "a finite number", [](double) { return true; } };
inline const Range positive = { "a number greater than 0", [](double value) { return value > 0; } };
inline const Range not_negative = { "a number not less than 0", [](double value) { return value >= 0; } };

inline Range between(double lower, double upper)
{
  return { "a number greater than " + to_text(lower) + " and less than " + to_text(upper),
           [=](double value) { return lower < value && value < upper; } };
}

inline const Range not_tipping = { "a number less than 2, where the foot tips",
                                   [](double value) { return value < 2; } };

/// A further fact about an entry: sets the entry's member for it.
using Fact = std::function<void(StudyEntry &)>;
using Facts = std::vector<Fact>;

/// The entry has an effect where @p condition holds, whatever the other entries of its subsection do.
inline Fact used_if(StudyEntry::Condition condition)
{
  return [=](StudyEntry &entry) { entry.has_effect = condition; };
}

/// StudyEntry::plausible, and from what to what.
inline Fact plausible(double least, double most, const std::string &reason)
{
  return [=](StudyEntry &entry)
  {
    entry.plausible = { least, most };
    entry.plausible_reason = reason;
  };
}

/// StudyEntry::times_contact_radius.
inline Fact times_contact_radius(double least, double most)
{
  return [=](StudyEntry &entry) { entry.times_contact_radius = { least, most }; };
}

/// The path is that of a folder, which the program may make.
inline const Fact of_a_folder = [](StudyEntry &entry) { entry.is_folder = true; };

/// StudyEntry::follows_from_profile.
inline const Fact follows_from_profile = [](StudyEntry &entry) { entry.follows_from_profile = true; };

/// Collects the entries of one subsection after the other.
class EntryList
{
public:
  explicit EntryList(Study &study)
      : study(study)
  {
  }

  /// Begins the subsection @p name, whose entries have an effect where @p condition holds, unless they say
  /// otherwise.
  void enter(const std::string &name, StudyEntry::Condition condition)
  {
    subsection.section = name;
    subsection.has_effect = condition;
  }

  /// A quantity; @p unit is empty for pure numbers.
  void number(const std::string &name, double &value, const Range &range, const std::string &unit,
              const std::string &help, const Facts &facts = {})
  {
    const auto parse = [range, unit](const std::string &text)
    {
      const auto number = parse_quantity(text, unit);
      return number && range.contains(*number) ? number : std::nullopt;
    };
    StudyEntry &entry =
      append(name, value, range.words + (unit.empty() ? "" : " (" + unit + ")"), help, facts, parse);
    entry.unit = unit.empty() ? "1" : unit;
    entry.quantity = &value;
  }

  /// A number of things, from @p least to @p most.
  void count(const std::string &name, unsigned int &value, unsigned int least, unsigned int most,
             const std::string &help, const Facts &facts = {})
  {
    const auto parse = [=](const std::string &text)
    {
      const auto count = parse_count(text);
      return count && least <= *count && *count <= most ? count : std::nullopt;
    };
    append(name, value, "a whole number from " + std::to_string(least) + " to " + std::to_string(most), help,
           facts, parse)
      .unit = "1";
  }

  /// The path of a file.
  void path(const std::string &name, std::string &value, const std::string &help, const Facts &facts = {})
  {
    const auto parse = [](const std::string &text)
    { return text.find_first_of("\n\r#") == std::string::npos ? std::optional(text) : std::nullopt; };
    append(name, value, "a path without # and line ends, or nothing", help, facts, parse).path_value = &value;
  }

  /// How a surface is out of flat.
  void waviness(const std::string &name, Waviness &value, const std::string &help)
  {
    append(name, value, waviness_words, help, {}, parse_waviness, waviness_text);
  }

  /// An entry with one of several named values.
  template <typename Choice>
  void choice(const std::string &name, Choice &value,
              const std::vector<std::pair<std::string, Choice>> &choices, const std::string &help,
              const Facts &facts = {})
  {
    const auto parse = [choices](const std::string &text)
    {
      std::optional<Choice> found;
      for (const auto &[word, choice] : choices)
        if (boost::iequals(word, text))
          found = choice;
      return found;
    };
    const auto print = [choices](Choice present)
    {
      for (const auto &[word, choice] : choices)
        if (choice == present)
          return word;
      throw std::logic_error("a study holds a value without a name");
    };
    std::vector<std::string> words;
    for (const auto &[word, choice] : choices)
      words.push_back(word);
    append(name, value, listed(words), help, facts, parse, print);
  }

  std::vector<StudyEntry> entries;

private:
  static constexpr auto as_it_is = [](const auto &value) { return value; };

  template <typename Value, typename Parse, typename Print = decltype(as_it_is)>
  StudyEntry &append(const std::string &name, Value &value, const std::string &allowed,
                     const std::string &help, const Facts &facts, const Parse &parse,
                     const Print &print = as_it_is)
  {
    StudyEntry entry = subsection;
    entry.name = name;
    entry.allowed = allowed;
    entry.help = help;
    entry.value = [&value, print] { return EntryValue(print(value)); };
    entry.assign = [&value, parse, &given = study.given_entries, path = entry.path()](const std::string &text)
    {
      const auto parsed = parse(text);
      if (!parsed)
        return false;
      value = *parsed;
      given[path] = text;
      return true;
    };
    for (const Fact &fact : facts)
      fact(entry);
    entries.push_back(entry);
    return entries.back();
  }

  Study &study;
  StudyEntry subsection; ///< what its entries begin as
};

} // namespace stemware::pipeline
