#include "fem/pipeline/result/sentences.h"

#include "fem/pipeline/base/numbers.h"
#include "fem/pipeline/result/number_format.h"
#include "fem/pipeline/study/quantity_text.h"
#include "fem/pipeline/study/study_entries.h"

#include <cctype>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <vector>

namespace stemware::pipeline
{

namespace
{

std::string size_of(const std::string &words)
{
  for (const std::string minus : { "-", "\u2212" })
    if (words.rfind(minus, 0) == 0)
      return words.substr(minus.size());
  return words;
}

/// Values of the entries in words, by path.
using Given = std::map<std::string, std::string>;

/// Returns the end of a sentence about the table, e.g. "on a mat of 1 GPa/m".
std::string on_table(const LoadSection &load, const TableSection &table, const Given &given)
{
  if (!load.is_from_contact())
    return load.source == LoadSource::file ? "with a load from a file" : "with a first-harmonic load";
  const bool disc = table.substrate == TableSubstrate::elastic;
  const std::string rigid = disc ? "" : "rigid table";
  std::string text = table.interface == TableInterface::winkler
                       ? "on a mat of " + given.at("Table/Foundation modulus") + (disc ? " on" : "")
                     : table.interface == TableInterface::rough ? "on a rough " + rigid
                                                                : "on a smooth " + rigid;
  if (disc)
    text += std::string(text.back() == ' ' ? "" : " ") + "disc of " + given.at("Table/Disc Young modulus") +
            ", " + given.at("Table/Disc thickness") + " thick";
  return text;
}

std::string table_of_sketch(const LoadSection &load, const TableSection &table, const Given &given)
{
  if (!load.is_from_contact())
    return "table";
  const bool mat = table.interface == TableInterface::winkler;
  std::string text = mat ? "mat, " + given.at("Table/Foundation modulus") : "";
  if (table.substrate == TableSubstrate::elastic)
    return text + (mat ? " on " : "") + "disc, " + given.at("Table/Disc Young modulus");
  return mat ? text : table.interface == TableInterface::rough ? "rough, rigid table" : "smooth, rigid table";
}

/// Returns the value of @p entry as text. Numbers are rounded to ten digits; fewer digits could hide a change
/// from the default.
std::string value_of(const StudyEntry &entry)
{
  const std::string text = entry.text();
  const std::optional<double> number = parse_number(text);
  return number && std::isfinite(*number) ? to_text(rounded(*number, 10)) : text.empty() ? "(none)" : text;
}

/// Returns the value of an entry as given with a unit, "300 g", else in the unit of the shortest text.
std::string value_in_words(const StudyEntry &entry, const Given &texts)
{
  if (!entry.quantity)
    return entry.text();
  const auto given = texts.find(entry.path());
  if (given != texts.end() && !trailing_unit(given->second).empty() &&
      parse_quantity(given->second, entry.unit) == *entry.quantity) // not changed since it was given
    return given->second;
  return in_usual_unit(*entry.quantity, entry.unit);
}

std::string inputs_of(const Study &study, const Given &given)
{
  const std::string &offset = given.at("Motion/Force offset");
  const double height = study.motion.orbit.force_offset;
  const bool by_offset = study.given_entries.count("Motion/Force offset") > 0;
  const bool is_filled = study.motion.orbit.liquid.mass > 0;
  return given.at("Motion/Mass") + " glass" +
         (is_filled ? " with " + given.at("Motion/Liquid mass") + " of liquid" : "") + ", R " +
         given.at("Glass/Contact radius") + ", led at " + given.at("Motion/Orbit speed") +
         " round a circle of " + given.at("Motion/Orbit radius") +
         (study.motion.orbit.sense_sign() < 0 ? ", clockwise" : "") + ", the hand " +
         (!by_offset   ? given.at("Motion/Hand height") + " above the table"
          : height < 0 ? size_of(offset) + " below the centre of mass"
          : height > 0 ? offset + " above the centre of mass"
                       : "at the height of the centre of mass") +
         ", μ " + given.at("Motion/Friction coefficient") + ", " + on_table(study.load, study.table, given) +
         (study.load.is_static() ? ", its moment ratio given as " + given.at("Load/Moment ratio") : "") +
         (study.motion.grip_torque > 0 ? ", gripped with " + given.at("Motion/Grip torque") : "") + ".";
}

Json sketch_labels(const ring::Motion &motion, const std::string &table, const Given &given)
{
  // Force of the hand on a sliding glass without spin: F = m a - T(0), where T is the friction force.
  const double along = motion.total_mass() * motion.acceleration().x() +
                       motion.friction_at_rest() * motion.normal_force(),
               inwards = motion.total_mass() * std::abs(motion.acceleration().y());
  return { { "mass", given.at("Motion/Mass") },
           { "speed", given.at("Motion/Orbit speed") },
           { "orbit_radius", given.at("Motion/Orbit radius") },
           { "height", given.at("Motion/Centre of mass height") },
           { "offset", size_of(given.at("Motion/Force offset")) },
           { "friction", given.at("Motion/Friction coefficient") },
           { "radius", given.at("Glass/Contact radius") },
           { "table", table },
           { "clockwise", motion.sense_sign() < 0 },
           { "hand", motion.force_offset < 0   ? -1
                     : motion.force_offset > 0 ? 1
                                               : 0 },
           { "force", { { "along", along }, { "inwards", inwards } } } };
}

} // namespace

std::string in_usual_unit(double value, const std::string &unit)
{
  const std::string alone = fmt::format(FMT_STRING("{:.4g}"), value);
  if (unit.empty() || unit == "1")
    return alone;
  std::string best;
  std::vector<std::string> units = usual_units(unit);
  units.push_back(unit);
  for (const std::string &candidate : units)
  {
    const double factor = parse_quantity("1 " + candidate, unit).value();
    const std::string text = fmt::format(FMT_STRING("{:.4g} {}"), value / factor, candidate);
    const auto length = [](const std::string &words) { return words.find(' '); };
    if (best.empty() || length(text) < length(best))
      best = text;
  }
  return best;
}

Results begun_results(const Study &study, const std::string &what)
{
  const std::vector<StudyEntry> entries = entries_of(study), &defaults = default_entries();
  Given given;
  for (const StudyEntry &entry : entries)
    given[entry.path()] = value_in_words(entry, study.given_entries);
  Results results = { study };
  results.words = { { "title", (study.name == "default" ? "The default glass" : study.name) + ": " + what },
                    { "inputs", inputs_of(study, given) },
                    { "one_way", study.load.is_one_way() },
                    { "sketch", sketch_labels(study.motion.orbit,
                                              table_of_sketch(study.load, study.table, given), given) } };
  for (std::size_t i = 0; i < entries.size(); ++i)
  {
    const std::string value = value_of(entries[i]), by_default = value_of(defaults[i]);
    results.entries.push_back({ { "entry", entries[i].path() },
                                { "value", value },
                                { "unit", entries[i].unit == "1" ? "" : entries[i].unit },
                                { "meaning", entries[i].help } });
    if (value != by_default)
      results.entries.back()["default"] = by_default;
  }
  return results;
}

using format::number;

void append(std::string &text, const std::string &sentence)
{
  text += (text.empty() || sentence.empty() ? "" : " ") + sentence;
}

std::string one_way_word(const LoadSection &load)
{
  return load.is_one_way() ? "one-way " : "";
}

std::string under_its_load(const LoadSection &load, std::string sentence)
{
  if (!load.is_one_way())
    return sentence;
  sentence[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(sentence[0])));
  if (load.source == LoadSource::file)
    return "With the given load, constant over the spin (one-way), " + sentence;
  return std::string(load.is_static() ? "With the given moment and" : "With") +
         " the load at rest kept at every spin (one-way), " + sentence;
}

std::string sense_of(const ring::Motion &motion, double omega)
{
  const bool is_with_orbit = omega * motion.sense_sign() > 0;
  return std::string(omega < 0 ? "clockwise, " : "counter-clockwise, ") +
         (is_with_orbit ? "with" : "against") + " its orbit";
}

std::string faster_or_slower(double change)
{
  return number(std::abs(change), ".3g%") + (change > 0 ? " faster" : " slower");
}

std::string torque_effect_sentence(const ring::TorqueEffects &effects)
{
  if (effects.rows.size() < 2 || !effects.rows.back().half || effects.torque_at_rest == 0)
    return "";
  const ring::TorqueEffect &all = effects.rows.back();
  const auto relative = [&](double torque) { return number(torque / effects.torque_at_rest, "+.3g%"); };
  if (!(std::abs(all.largest.value_or(all.half->change)) > 1e-9 * effects.torque_at_rest))
    return "The harmonics beyond the first do not change the torque of friction at any spin.";
  std::string text = "At half the terminal spin the harmonics beyond the first change tau_z of friction by " +
                     number(all.half->change, "+.3g") + " N m (" + relative(all.half->change) +
                     " of |tau_z| at rest)";
  if (all.largest)
    text += ", at most by " + relative(*all.largest) + ", at " + number(*all.largest_at, ".3g") + " rad/s";
  return text + "; at rest by nothing, for every contact.";
}

std::string harmonic_effect_sentence(const Study &study, const HarmonicEffect &effect,
                                     const std::optional<double> &band)
{
  if (!effect.absolute)
    return "";
  const std::string opening = "The higher harmonics of the " + one_way_word(study.load) + "load ",
                    change = number(*effect.absolute, "+.3g") +
                             (band && *band > 0.1 * std::abs(*effect.absolute) ? " ± " + number(*band, "band")
                                                                               : "") +
                             " rad/s";
  if (!study.is_spin(*effect.absolute))
    return opening + "change the spin by less than " + number(study.rounding_of_spins(), ".2g") + " rad/s.";
  if (effect.relative)
    return opening + "make the spin " + faster_or_slower(*effect.relative) + " (" + change + ").";
  return opening + "change the spin by " + change + ".";
}

std::string fall_sentences(const ring::Motion &motion, const ring::Answer &all)
{
  const ring::RingState &fall = all.fall.value();
  return "The glass stands at rest and tips over while it spins up, at " +
         number(std::abs(fall.omega), ".3g") + " rad/s " + sense_of(motion, fall.omega) +
         ", where the moment ratio is " + number(fall.moment_ratio, ".3g") +
         ": no contact pressure balances a larger moment. There is no terminal spin. At rest the moment "
         "ratio is " +
         number(all.at_rest.value().moment_ratio, ".4g") + " and the torque of friction is " +
         number(all.at_rest.value().friction.torque, ".4g") + " N m.";
}

} // namespace stemware::pipeline
