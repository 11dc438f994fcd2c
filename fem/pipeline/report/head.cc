#include "fem/pipeline/report/head.h"

#include "fem/pipeline/document/number_format.h"
#include "fem/pipeline/study/quantity_text.h"
#include "fem/pipeline/study/study_entries.h"
#include "fem/pipeline/support/numbers.h"

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>

namespace stemware::pipeline
{

using Json = nlohmann::ordered_json;

namespace
{

using boost::math::double_constants::pi;
using boost::math::double_constants::two_pi;

/// The words without their sign.
std::string size_of(const std::string &words)
{
  for (const std::string minus : { "-", "\u2212" })
    if (words.rfind(minus, 0) == 0)
      return words.substr(minus.size());
  return words;
}

/// How the study's table is called, as flags for sentences.
Json table_facts(const Study &study)
{
  const TableSection &table = study.table;
  const bool contact = study.load.is_from_contact(), disc = table.substrate == TableSubstrate::elastic;
  return { { "contact", contact },
           { "file", study.load.source == LoadSource::file },
           { "winkler", contact && table.interface == TableInterface::winkler },
           { "rough", contact && table.interface == TableInterface::rough },
           { "hard", contact && table.interface == TableInterface::hard },
           { "disc", contact && disc },
           { "mesh", contact && !study.contact.mesh_file.empty() },
           { "given_moment", study.load.is_static() },
           { "clockwise", study.motion.orbit.sense_sign() < 0 },
           { "gripped", study.motion.grip_torque > 0 } };
}

/// Lengths of the arrows of the sketch and the numbers at them; the load is there where it is known.
Json sketch_facts(const Study &study, const std::optional<ring::RingStack> &load)
{
  const ring::Motion &motion = study.motion.orbit;
  const double sign = motion.force_offset < 0 ? -1 : motion.force_offset > 0 ? 1 : 0;
  Json facts = { { "force", motion.mass * motion.acceleration().norm() },
                 { "weight", motion.normal_force() },
                 { "hand_y", 224 - 72.5 * sign },
                 { "middle_y", 224 - 72.5 * sign / 2 },
                 { "pressure", nullptr } };
  if (!load)
    return facts;
  // Outside is away from the orbit's centre, which lies at theta = 90 degrees of a counter-clockwise orbit.
  const double side = motion.sense_sign() * pi / 2, mean = load->a(0), radius = load->radius();
  const auto arrow = [&](double theta) { return 350 + 24 * std::clamp((*load)(theta) / mean, 0., 2.); };
  facts["pressure"] = { { "outside", (*load)(-side) / radius },
                        { "inside", (*load)(side) / radius },
                        { "outside_y", arrow(-side) },
                        { "inside_y", arrow(side) } };
  return facts;
}

/// The band round a rim that shows its load, as a path about the glass's centre; @p travel is the direction
/// of travel on the page, counter-clockwise from the right.
std::string band_path(const ring::RingStack &load, double rim, double travel)
{
  std::string path;
  for (int i = 0; i < 72; ++i)
  {
    const double theta = two_pi * i / 72, reach = rim * (1 + 0.35 * std::max(0., load(theta) / load.a(0)));
    path += fmt::format(FMT_STRING("{}{:.2f},{:.2f}"), i == 0 ? "M" : " L", reach * std::cos(travel + theta),
                        -reach * std::sin(travel + theta));
  }
  return path + " Z";
}

/// Places on the page in points; angles there run against the screen's, whose y points down.
Json orbit_facts(const Study &study, const std::vector<TurningGlass> &glasses)
{
  constexpr double panel = 270, reach = 130, least_rim = 15;
  const ring::Motion &motion = study.motion.orbit;
  const double radius = study.glass.profile.contact_radius,
               foot = std::clamp(study.glass.profile.foot_radius, radius, 1.4 * radius);
  const double true_rim = reach * radius / (motion.orbit_radius + 1.9 * radius);
  const double rim = std::max(true_rim, least_rim);
  const double orbit = std::min(reach - 1.9 * rim, true_rim / radius * motion.orbit_radius);
  const double travel = motion.sense_sign() * pi / 2; // the glass begins at the right of its orbit
  const double width = panel * std::max(2., static_cast<double>(glasses.size()));
  const double share = glasses.empty() ? width : width / static_cast<double>(glasses.size());
  Json facts = { { "width", width },
                 { "shows_load",
                   std::any_of(glasses.begin(), glasses.end(),
                               [](const TurningGlass &glass) { return glass.load.has_value(); }) },
                 { "seconds", two_pi / std::abs(motion.orbit_rate()) },
                 { "clockwise", motion.orbit_rate() < 0 },
                 { "radius", orbit },
                 { "rim", rim },
                 { "foot", rim * foot / radius },
                 { "dot", std::max(3., 0.16 * rim) },
                 { "arrow", -motion.sense_sign() * 2.1 * rim },
                 { "arrow_base", -motion.sense_sign() * 1.65 * rim },
                 { "larger", rim > 1.05 * true_rim ? Json(rim / true_rim) : Json(nullptr) },
                 { "glasses", Json::array() } };
  for (std::size_t i = 0; i < glasses.size(); ++i)
  {
    const TurningGlass &glass = glasses[i];
    const double omega = glass.omega.value_or(0), against_orbit = omega - motion.orbit_rate();
    const bool turns = std::abs(omega) > 1e-6 * std::abs(motion.orbit_rate());
    facts["glasses"].push_back(
      { { "x", share * (static_cast<double>(i) + 0.5) },
        { "title", glass.title },
        { "is_ring", glass.is_ring },
        { "no_spin", !glass.omega },
        { "rests", glass.omega && !turns },
        { "turns", turns },
        { "omega", (omega < 0 ? "\u2212" : "") + fmt::format(FMT_STRING("{:.3f}"), std::abs(omega)) },
        { "seconds_a_turn", turns ? Json(two_pi / std::abs(omega)) : Json(nullptr) },
        { "seconds_in_orbit", std::min(two_pi / std::abs(against_orbit), 1e4) }, // where its mark is again
        { "clockwise_in_orbit", against_orbit < 0 },
        { "load", glass.load ? band_path(*glass.load, rim * foot / radius, travel) : "" } });
  }
  return facts;
}

std::string value_of(const StudyEntry &entry)
{
  const std::string text = entry.text();
  return text.empty() ? "(none)" : text;
}

/// The value of an entry to ten digits, which is what a reader can tell apart.
std::string shown_value(const StudyEntry &entry)
{
  const std::string text = value_of(entry);
  const std::optional<double> number = parse_number(text);
  return number && std::isfinite(*number) ? to_text(rounded(*number, 10)) : text;
}

/// Entries of the study for the template "study": those that are not the defaults, and all of them.
void add_entries(const Study &study, Document &document)
{
  Study given = study, usual;
  const std::vector<StudyEntry> entries = study_entries(given), defaults = study_entries(usual);
  Json changed = Json::array(), all = Json::array();
  for (std::size_t i = 0; i < entries.size(); ++i)
  {
    const StudyEntry &entry = entries[i];
    const std::string unit = entry.unit == "1" ? "" : entry.unit;
    if (const std::string value = shown_value(entry), by_default = shown_value(defaults[i]);
        value != by_default)
      changed.push_back(
        { { "entry", entry.path() }, { "value", value }, { "default", by_default }, { "unit", unit } });
    all.push_back({ { "entry", entry.path() },
                    { "value", value_of(entry) },
                    { "unit", unit },
                    { "meaning", entry.help } });
  }
  document.facts["is_default_study"] = changed.empty();
  document.facts["study_differences"] = changed;
  document.facts["study_entries"] = all;
}

} // namespace

std::string in_words(double value, const std::string &unit)
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

std::string in_words(const Study &study, const StudyEntry &entry)
{
  if (!entry.quantity)
    return entry.text();
  const auto given = study.given_entries.find(entry.path());
  if (given != study.given_entries.end() && !unit_behind(given->second).empty() &&
      parse_quantity(given->second, entry.unit) == *entry.quantity) // and not that of a variant
    return given->second;
  return in_words(*entry.quantity, entry.unit);
}

void add_study(const Study &study, const std::vector<TurningGlass> &glasses, Document &document,
               const std::optional<ring::RingStack> &load)
{
  Study copy = study;
  Json given = Json::object();
  for (const StudyEntry &entry : study_entries(copy))
    given[entry.path()] = in_words(study, entry);
  const std::string offset = given["Motion/Force offset"].get<std::string>();
  const double height = study.motion.orbit.force_offset;
  document.facts.update({ { "study_name", study.name },
                          { "study_title", study.name == "default" ? "The default glass" : study.name },
                          { "given", given },
                          { "hand",
                            { { "below", height < 0 ? size_of(offset) : "" },
                              { "above", height > 0 ? offset : "" },
                              { "at", height == 0 } } },
                          { "table", table_facts(study) },
                          { "sketch", sketch_facts(study, load) },
                          { "orbits", orbit_facts(study, glasses) } });
  add_entries(study, document);
}

} // namespace stemware::pipeline
