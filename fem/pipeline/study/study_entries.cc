#include "fem/pipeline/study/study_entries.h"

#include "fem/pipeline/base/failures.h"
#include "fem/pipeline/base/numbers.h"
#include "fem/pipeline/base/text.h"
#include "fem/pipeline/study/quantity_text.h"

#include <boost/algorithm/string/predicate.hpp>

#include <algorithm>
#include <cctype>
#include <stdexcept>
#include <utility>

namespace stemware::pipeline
{

namespace
{

struct EntryList
{
  Study &study;
  std::vector<StudyEntry> entries = {};
  StudyEntry subsection = {}; ///< template for the entries of the subsection

  /// Starts a subsection. Entries without a condition of their own have an effect if @p condition is true.
  void enter(const std::string &name, bool condition)
  {
    subsection.section = name;
    subsection.has_effect = condition;
  }

  /// Adds a quantity.
  template <typename... Facts>
  void number(const std::string &name, double &value, const Range &range, const std::string &unit,
              const std::string &help, const Facts &...facts)
  {
    const auto parse = [range, unit](const std::string &text)
    {
      const auto number = parse_quantity(text, unit);
      return number && range.contains(*number) ? number : std::nullopt;
    };
    const std::string allowed = range.words + (unit == "1" ? "" : " (" + unit + ")");
    StudyEntry &entry = append(name, value, allowed, help, parse, as_it_is, facts...);
    entry.unit = unit;
    entry.quantity = &value;
  }

  template <typename... Facts>
  void count(const std::string &name, unsigned int &value, unsigned int least, unsigned int most,
             const std::string &help, const Facts &...facts)
  {
    const auto parse = [=](const std::string &text)
    {
      const auto count = parse_count(text);
      return count && least <= *count && *count <= most ? count : std::nullopt;
    };
    const std::string allowed =
      "a whole number from " + std::to_string(least) + " to " + std::to_string(most);
    append(name, value, allowed, help, parse, as_it_is, facts...).unit = "1";
  }

  template <typename... Facts>
  void path(const std::string &name, std::string &value, const std::string &help, const Facts &...facts)
  {
    append(name, value, "a path without # and line ends, or nothing", help, in_one_line, as_it_is, facts...)
      .path_value = &value;
  }

  void waviness(const std::string &name, Waviness &value, const std::string &help)
  {
    append(name, value, waviness_words, help, parse_waviness, waviness_text);
  }

  template <typename Choice, typename... Facts>
  void choice(const std::string &name, Choice &value,
              const std::vector<std::pair<std::string, Choice>> &choices, const std::string &help,
              const Facts &...facts)
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
    append(name, value, listed(words), help, parse, print, facts...);
  }

  static std::optional<std::string> in_one_line(const std::string &text)
  {
    return text.find_first_of("\n\r#") == std::string::npos ? std::optional(text) : std::nullopt;
  }

  static constexpr auto as_it_is = [](const auto &value) { return value; };

  template <typename Value, typename Parse, typename Print, typename... Facts>
  StudyEntry &append(const std::string &name, Value &value, const std::string &allowed,
                     const std::string &help, const Parse &parse, const Print &print, const Facts &...facts)
  {
    StudyEntry entry = subsection;
    entry.name = name;
    entry.allowed = allowed;
    entry.help = help;
    entry.is_given = study.given_entries.count(entry.path()) > 0;
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
    (facts(entry), ...);
    return entries.emplace_back(entry);
  }
};

/// Technical terms that are no entry names. `paths`: entries that a term may mean, most common first.
struct FieldWords
{
  std::vector<std::string> words; ///< case-insensitive
  std::vector<std::string> paths;
};

const std::vector<FieldWords> field_words = {
  { { "E" }, { "Glass/Young modulus", "Table/Disc Young modulus" } },
  { { "nu", "ν" }, { "Glass/Poisson ratio", "Table/Disc Poisson ratio" } },
  { { "mu", "μ", "mu_k" }, { "Motion/Friction coefficient" } },
  { { "mu_s" }, { "Motion/Static friction coefficient" } },
  { { "v_s" }, { "Motion/Friction decay speed" } },
  { { "c" }, { "Motion/Viscous friction" } },
  { { "R", "radius" }, { "Glass/Contact radius", "Motion/Orbit radius", "Table/Disc radius" } },
  { { "m", "weight" }, { "Motion/Mass" } },
  { { "g" }, { "Motion/Gravity" } },
  { { "v", "speed", "omega", "ω" }, { "Motion/Orbit speed" } },
  { { "rho", "ρ" }, { "Motion/Orbit radius" } },
  { { "rho_c" }, { "Glass/Crown radius" } },
  { { "z_cm", "z" }, { "Motion/Centre of mass height" } },
  { { "h" }, { "Motion/Centre of mass height", "Table/Disc thickness", "Glass/Foot thickness" } },
  { { "thickness" }, { "Table/Disc thickness", "Glass/Foot thickness" } },
  { { "hand" }, { "Motion/Hand height" } },
  { { "dz" }, { "Motion/Force offset" } },
  { { "I", "inertia" }, { "Motion/Yaw inertia" } },
  { { "k", "stiffness" }, { "Table/Foundation modulus" } },
  { { "p_0", "p0" }, { "Table/Reference pressure" } },
  { { "l", "roughness" }, { "Table/Decay length" } },
};

/// Returns the entry meant by a technical term, e.g. "E" or "Table/E". Prefers the section in @p word.
std::optional<std::string> meant_by_field(const std::string &word)
{
  const std::size_t slash = word.find('/'), name = slash < word.size() ? slash + 1 : 0;
  const std::string section = word.substr(0, name);
  for (const FieldWords &known : field_words)
    if (std::any_of(known.words.begin(), known.words.end(),
                    [&](const std::string &term) { return boost::iequals(term, word.substr(name)); }))
    {
      const auto own =
        std::find_if(known.paths.begin(), known.paths.end(),
                     [&](const std::string &path) { return boost::istarts_with(path, section); });
      return own != known.paths.end() ? *own : known.paths.front();
    }
  return std::nullopt;
}

/// Returns the end of a message about an unknown entry, e.g. "; did you mean Glass/Contact radius?".
std::string suggestion(const std::vector<StudyEntry> &entries, const std::string &word)
{
  std::vector<std::string> names, paths;
  std::string name = word;
  for (const StudyEntry &entry : entries)
  {
    names.push_back(entry.name);
    paths.push_back(entry.path());
    if (word.rfind(entry.section + '/', 0) == 0)
      name = word.substr(entry.section.size() + 1);
  }
  std::optional<std::string> meant = meant_by_field(word);
  if (!meant)
    meant = closest_match(word, paths);
  if (const auto likely = closest_match(name, names); likely && !meant)
    meant = paths[static_cast<std::size_t>(std::find(names.begin(), names.end(), *likely) - names.begin())];
  for (const StudyEntry &entry : entries) // finds a name whose last words are missing in `word`
    if (!meant && !name.empty() && boost::istarts_with(entry.name, name + ' ') &&
        (name == word || word.rfind(entry.section + '/', 0) == 0))
      meant = entry.path();
  return meant ? "; did you mean " + *meant + "? (`stemware defaults` lists what there is.)"
               : "; `stemware defaults` lists what there is.";
}

} // namespace

std::vector<StudyEntry> study_entries(Study &study)
{
  EntryList list{ study };
  study.motion.declare(list);
  study.glass.declare(list);
  study.table.declare(list);
  study.contact.declare(list);
  study.load.declare(list);
  return list.entries;
}

std::vector<StudyEntry> entries_of(const Study &study)
{
  const auto copy = std::make_shared<Study>(study);
  std::vector<StudyEntry> entries = study_entries(*copy);
  for (StudyEntry &entry : entries)
    entry.study = copy;
  return entries;
}

const std::vector<StudyEntry> &default_entries()
{
  static const std::vector<StudyEntry> entries = entries_of(Study());
  return entries;
}

std::string StudyEntry::text() const
{
  const EntryValue present = value();
  if (const auto *words = std::get_if<std::string>(&present))
    return *words;
  const auto *count = std::get_if<unsigned int>(&present);
  return count ? std::to_string(*count) : to_text(std::get<double>(present));
}

std::vector<std::string> sections_of(const std::vector<StudyEntry> &entries)
{
  std::vector<std::string> sections;
  for (const StudyEntry &entry : entries)
    if (sections.empty() || sections.back() != entry.section)
      sections.push_back(entry.section);
  return sections;
}

std::string full_path(const std::vector<StudyEntry> &entries, const std::string &word)
{
  std::string path = word;
  std::size_t n_found = 0;
  for (const StudyEntry &entry : entries)
    if (entry.name == word)
    {
      path = entry.path();
      ++n_found;
    }
  return n_found == 1 ? path : word;
}

const StudyEntry &entry_at(const std::vector<StudyEntry> &entries, const std::string &origin,
                           const std::string &word)
{
  const std::string path = full_path(entries, word);
  const auto entry = std::find_if(entries.begin(), entries.end(),
                                  [&](const StudyEntry &candidate) { return candidate.path() == path; });
  if (entry == entries.end()) // ensure() would call the slow suggestion() even for known entries
    throw BadInput(origin + "there is no entry \"" + shortened(path) + '"' + suggestion(entries, path));
  return *entry;
}

void assign(const StudyEntry &entry, const std::string &origin, const std::string &value)
{
  if (entry.assign(value))
    return;
  const std::string trouble = entry.quantity != nullptr ? unit_error(value, entry.unit) : "";
  const std::vector<std::string> quotes = {
    "\"", "'", "`", "\u201c", "\u201e", "\u2018", "\u00ab", "\u00bb"
  };
  const bool is_quoted = std::any_of(quotes.begin(), quotes.end(),
                                     [&](const std::string &quote) { return value.rfind(quote, 0) == 0; });
  throw BadInput(origin + entry.path() + " = " + (value.empty() ? "(nothing)" : shortened(value)) +
                 (trouble.empty()
                    ? std::string(" is not allowed; ") + (is_quoted ? "leave the quotes out, and " : "") +
                        "give " + entry.allowed + '.'
                    : trouble));
}

void assign(const std::vector<StudyEntry> &entries, const std::string &origin, const std::string &path,
            const std::string &value)
{
  assign(entry_at(entries, origin, path), origin, value);
}

StudyEntry find_entry(const std::string &origin, const std::string &path)
{
  return entry_at(entries_of(Study()), origin, path);
}

std::string with_entries(const std::string &message)
{
  const std::vector<StudyEntry> &entries = default_entries();
  const auto is_letter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; };
  std::string result;
  for (std::size_t i = 0; i < message.size();)
  {
    const StudyEntry *found = nullptr;
    if (i == 0 || (!is_letter(message[i - 1]) && message[i - 1] != '/'))
      for (const StudyEntry &entry : entries)
      {
        const std::string &name = entry.name;
        const std::size_t end = i + name.size();
        if ((entry.section == "Glass" || entry.section == "Table" || entry.section == "Contact") &&
            name.find(' ') != std::string::npos && (!found || found->name.size() < name.size()) &&
            boost::iequals(message.substr(i, name.size()), name) &&
            (end >= message.size() || !is_letter(message[end])))
          found = &entry;
      }
    result += found ? found->path() : std::string(1, message[i]);
    i += found ? found->name.size() : 1;
  }
  return result;
}

} // namespace stemware::pipeline
