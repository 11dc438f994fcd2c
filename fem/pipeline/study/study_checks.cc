#include "fem/pipeline/study/study_checks.h"

#include "fem/pipeline/base/failures.h"
#include "fem/pipeline/base/numbers.h"
#include "fem/pipeline/base/text.h"
#include "fem/pipeline/study/quantity_text.h"
#include "fem/pipeline/study/study_entries.h"
#include "ring_model/failures.h"
#include "ring_model/moment_balance.h"

#include <boost/algorithm/string/join.hpp>

#include <algorithm>
#include <cmath>

namespace stemware::pipeline
{

namespace
{

bool is_implausible(const StudyEntry &entry, double value)
{
  return entry.plausible && value != 0 && (value < entry.plausible->first || value > entry.plausible->second);
}

std::vector<StudyEntry> implausible_entries(const std::vector<StudyEntry> &entries)
{
  std::vector<StudyEntry> implausible;
  for (const StudyEntry &entry : entries)
    if (entry.is_given && entry.has_effect && entry.plausible && is_implausible(entry, *entry.quantity))
      implausible.push_back(entry);
  return implausible;
}

std::string unit_behind_number(const StudyEntry &entry)
{
  return entry.unit == "1" ? "" : ' ' + entry.unit;
}

std::string assignment(const StudyEntry &entry, double value)
{
  return entry.path() + " = " + to_short_text(value) + unit_behind_number(entry);
}

std::string plausible_text(const StudyEntry &entry)
{
  return to_short_text(entry.plausible->first) + " to " + to_short_text(entry.plausible->second) +
         unit_behind_number(entry);
}

/// Refuses a value outside its plausible range by a factor of more than 1e9: the computation would overflow.
void require_conceivable(const std::vector<StudyEntry> &entries)
{
  constexpr double far = 1e9;
  for (const StudyEntry &entry : entries)
    if (entry.plausible && entry.is_given)
    {
      const auto [least, most] = *entry.plausible;
      const double size = std::abs(*entry.quantity);
      ensure(size <= far * std::max(std::abs(least), most) && (size == 0 || size >= least / far),
             filled("{} is more than a billion times outside {}, {}; check number and unit.",
                    { assignment(entry, *entry.quantity), plausible_text(entry), entry.plausible_reason }));
    }
}

/// Checks the ratios of lengths to @p radius, the contact radius (StudyEntry::times_contact_radius).
void require_alike_lengths(const std::vector<StudyEntry> &entries, double radius)
{
  for (const StudyEntry &entry : entries)
    if (const auto &range = entry.times_contact_radius; range && entry.has_effect)
    {
      const double times = *entry.quantity / radius;
      const auto [least, most] = *range;
      const std::string text = distinct_texts(times, times < least ? least : most).first;
      ensure(least <= times && times <= most,
             filled("{} = {} m is {} times Glass/Contact radius = {} m, but from {} to {} is allowed; give "
                    "both in one unit.",
                    { entry.path(), to_text(*entry.quantity), text, to_text(radius), to_text(least),
                      to_text(most) }));
    }
}

/// Refuses settings that Contact/Body excludes, and load harmonics with two or fewer lines per wavelength.
void require_able_body(const ContactSection &contact, const TableSection &table)
{
  const bool is_of_revolution = contact.is_of_revolution();
  ensure(!is_of_revolution || contact.mesh_file.empty(),
         "Contact/Mesh file = " + shortened_path(contact.mesh_file) +
           " is read by a solid body only; set Contact/Body = solid, or leave Mesh file empty.");
  ensure(contact.degree <= contact.highest_degree(),
         "Contact/Degree = " + std::to_string(contact.degree) +
           " is not allowed for Contact/Body = solid; give 1 or 2, or set Contact/Body = revolution.");
  ensure(is_of_revolution || !table.make().substrate,
         "Table/Substrate = elastic needs a body of revolution; set Contact/Body = revolution, or "
         "Table/Substrate = rigid.");
  ensure(!is_of_revolution || 2 * contact.load_harmonics < contact.azimuth_lines,
         filled("Contact/Load harmonics = {} needs more than {} Contact/Azimuth lines, not {}; give more "
                "lines, or fewer load harmonics.",
                { std::to_string(contact.load_harmonics), std::to_string(2 * contact.load_harmonics),
                  std::to_string(contact.azimuth_lines) }));
}

/// Refuses a mat so stiff that the results equal the results on a hard table up to rounding.
void require_mat_that_yields(const TableSection &table, const GlassSection &glass)
{
  constexpr double most = 1e8;
  const double of_glass = glass.material.young_modulus / glass.profile.contact_radius;
  const auto [ratio, limit] = distinct_texts(table.foundation_modulus / of_glass, most);
  if (table.interface == TableInterface::winkler)
    ensure(
      table.foundation_modulus <= most * of_glass,
      filled("Table/Foundation modulus = {} Pa/m is {} times Glass/Young modulus over Glass/Contact radius, "
             "but at most {} is allowed; write Table/Interface = hard for a rigid interface.",
             { to_text(table.foundation_modulus), ratio, limit }));
}

void require_goal_with_estimate(const ContactSection &contact, const TableSection &table)
{
  if (contact.goal == Goal::none)
    return;
  const std::string rest = ", or set Contact/Goal = none.";
  ensure(!contact.is_of_revolution(),
         "Contact/Goal is given for a body of revolution, but halves cells of a solid body only; write "
         "Contact/Refinements, which halves all cells at little cost, or Contact/Body = solid" +
           rest);
  // A solid foot without refinement has nodal multipliers on a hard table, for which no error estimate
  // exists.
  ensure(!table.is_hard() || contact.refinements > 0,
         "Contact/Goal of a solid foot on a hard table needs a refined mesh; set Contact/Refinements to at "
         "least 1" +
           rest);
  ensure(contact.rings > 1, "Contact/Goal needs more than one ring; give Contact/Rings = 5" + rest);
}

void require_load_file(const LoadSection &load)
{
  if (load.source != LoadSource::file)
  {
    ensure(load.file.empty(), "Load/File = " + shortened_path(load.file) +
                                " is read only with Load/Source = file; set that, or leave Load/File empty.");
    return;
  }
  ensure(!load.file.empty(),
         "Load/Source = file needs Load/File; name a file with the load's Fourier coefficients.");
  ensure(!load.is_static(),
         "Load/Moment ratio = " + to_text(load.moment_ratio) +
           " contradicts Load/Source = file, whose load has a moment of its own; leave Moment ratio at -1.");
}

void require_known_waviness(const std::string &entry, const Waviness &waviness, const ContactSection &contact,
                            const LoadSection &load)
{
  if (waviness.empty())
    return;
  ensure(contact.is_of_revolution(),
         entry + " needs a body of revolution; set Contact/Body = revolution, or leave " + entry +
           " empty and draw the foot in a mesh file.");
  ensure(load.is_from_contact(),
         entry + " needs Load/Source = contact; set that, or leave " + entry + " empty.");
  for (const fem::WavinessHarmonic &harmonic : waviness)
    ensure(harmonic.n <= contact.harmonics,
           filled("{} has a harmonic n = {}, but the foot has {} elastic harmonics; set Contact/Harmonics "
                  "to at least n.",
                  { entry, std::to_string(harmonic.n), std::to_string(contact.harmonics) }));
}

/// Checks that the hand is above the table and that Motion/Hand height and Motion/Force offset agree.
void require_hand_above_table(const std::vector<StudyEntry> &entries, const MotionSection &section)
{
  const ring::Motion &motion = section.orbit;
  const double hand = section.hand_height, centre = motion.centre_of_mass_height;
  const StudyEntry &height_of_centre = entry_at(entries, "", "Motion/Centre of mass height");
  const bool by_offset = entry_at(entries, "", "Motion/Force offset").is_given,
             by_height = entry_at(entries, "", "Motion/Hand height").is_given;
  ensure(!by_height || !by_offset ||
           std::abs(hand - centre - motion.force_offset) <= 1e-9 * (std::abs(hand) + centre),
         filled("Motion/Hand height = {} m and Motion/Force offset = {} m contradict each other for "
                "Motion/Centre of mass height = {} m; give one of the two.",
                { to_text(hand), to_text(motion.force_offset), to_text(centre) }));
  const bool is_known = !by_offset || height_of_centre.is_given || height_of_centre.has_effect;
  const auto text = by_offset ? "Motion/Force offset = " + to_text(motion.force_offset)
                              : "Motion/Hand height = " + to_text(hand);
  ensure(hand >= -1e-12 || !is_known,
         filled("{} m puts the hand {} m below the table, for Motion/Centre of mass height = {} m; give at "
                "least {} m.",
                { text, to_short_text(-hand), to_text(centre), to_text(by_offset ? -centre : 0) }));
}

/// Returns a lower bound of the required moment at the instant @p now, divided by the maximum moment of a
/// pressure on the land. The bound is the moment without friction minus the maximum moment of friction. If
/// the result is 1 or more, the glass tips at every spin; if slightly less than 1, contact solves are slow
/// and fail.
double certain_tipping_share(ring::Closure closure, const fem::GlassProfile &profile, const ring::Motion &now)
{
  const double friction = now.has_constant_friction()
                            ? now.friction_coefficient
                            : std::max(now.static_coefficient, now.friction_coefficient) +
                                now.viscous_friction * 3 * now.orbit_speed;
  const double of_hand = ring::required_moment(closure, now, Eigen::Vector2d::Zero()).norm(),
               of_friction = std::abs(ring::friction_arm(closure, now)) * friction * now.normal_force(),
               outer = profile.contact_radius + profile.land_width / 2;
  return (of_hand - of_friction) / (now.normal_force() * outer);
}

void require_known_speeds(const Study &study)
{
  if (!study.motion.orbit_speeds)
    return;
  const std::string entry = "Motion/Orbit speed file = " + shortened_path(study.motion.orbit_speed_file);
  for (const double time : { 0., study.motion.end_time })
    try
    {
      study.motion.orbit_speeds->speed(time);
    }
    catch (const std::out_of_range &)
    {
      throw BadInput(filled("{} does not reach t = {} s; give speeds from 0 to Motion/End time = {} s.",
                            { entry, to_text(time), to_text(study.motion.end_time) }));
    }
  // At n_times equally spaced instants, the liquid must stay in the bowl and the glass must not tip.
  constexpr unsigned int n_times = 1000;
  for (unsigned int i = 0; i <= n_times && study.motion.orbit.liquid.mass > 0; ++i)
    try
    {
      const double time = study.motion.end_time * i / n_times;
      study.motion.orbit_speeds->motion_at(study.motion.orbit, time).validate();
    }
    catch (const std::invalid_argument &error)
    {
      throw BadInput(entry + ": " + error.what());
    }
  const std::string needs = entry + " needs ";
  ensure(!study.load.is_static() && study.load.source != LoadSource::file &&
           study.load.coupling == LoadCoupling::two_way,
         needs +
           "a load in balance at every speed; set Load/Coupling = two-way, and no given moment or load.");
  ensure(!study.load.is_from_contact() || study.contact.is_of_revolution(),
         needs + "a body of revolution; set Contact/Body = revolution.");
  ensure(!study.has_waviness(),
         needs + "a flat rim on a flat table; leave Glass/Rim waviness and Table/Waviness empty.");
  for (unsigned int i = 0; i <= n_times && study.contact.mesh_file.empty(); ++i)
  {
    const double time = study.motion.end_time * i / n_times;
    const ring::Motion now = study.motion.orbit_speeds->motion_at(study.motion.orbit, time);
    ensure(
      certain_tipping_share(study.motion.closure, study.glass.profile, now) < 1,
      filled("{}: at t = {} s, where v = {} m/s and dv/dt = {} m/s^2, the glass tips at every spin; give "
             "lower speeds, or lower the hand.",
             { entry, to_short_text(time), to_short_text(now.orbit_speed),
               to_short_text(now.orbit_acceleration) }));
  }
}

} // namespace

void Study::check_values() const
{
  const std::vector<StudyEntry> entries = entries_of(*this);
  const bool is_from_contact = load.is_from_contact();
  require_hand_above_table(entries, motion);
  ensure(
    motion.breakaway_friction == 0 || motion.breakaway_friction >= motion.orbit.friction_coefficient,
    filled("Motion/Breakaway friction = {} is less than Motion/Friction coefficient = {}, with which the "
           "glass slides; give at least the coefficient of sliding, or 0 to use it.",
           { to_text(motion.breakaway_friction), to_text(motion.orbit.friction_coefficient) }));
  require_conceivable(entries);
  require_able_body(contact, table);
  require_known_waviness("Glass/Rim waviness", glass.waviness, contact, load);
  require_known_waviness("Table/Waviness", table.waviness, contact, load);
  require_alike_lengths(entries, glass.profile.contact_radius);
  if (is_from_contact)
  {
    require_mat_that_yields(table, glass);
    require_goal_with_estimate(contact, table);
  }
  require_load_file(load);
  try
  {
    motion.orbit.validate();
    if (is_from_contact) // without a contact there is no foot
      glass.material.validate();
    if (is_from_contact && contact.mesh_file.empty())
    {
      glass.profile.validate();
      contact.resolution.validate();
    }
  }
  catch (const std::invalid_argument &error)
  {
    throw BadInput(with_entries(error.what()));
  }
  require_known_speeds(*this);
}

std::vector<std::string> unused_entries(const std::vector<StudyEntry> &entries)
{
  std::vector<std::string> idle;
  for (const StudyEntry &entry : entries)
    if (entry.is_given && !entry.has_effect)
      idle.push_back(entry.path());
  return idle;
}

std::string implausible_note(const StudyEntry &entry, double value)
{
  if (!is_implausible(entry, value))
    return "";
  const std::string number = to_short_text(value);
  const std::vector<std::string> units = usual_units(entry.unit);
  const auto meant = std::find_if(units.begin(), units.end(),
                                  [&](const std::string &unit)
                                  {
                                    const auto other = parse_quantity(number + ' ' + unit, entry.unit);
                                    return other && !is_implausible(entry, *other);
                                  });
  return assignment(entry, value) + " is outside " + plausible_text(entry) + " for a glass; " +
         (meant != units.end() ? "write " + number + ' ' + *meant + " if that is meant."
                               : "check number and unit.");
}

std::vector<std::string> implausible_notes(const std::vector<StudyEntry> &entries)
{
  std::vector<std::string> notes;
  for (const StudyEntry &entry : implausible_entries(entries))
    notes.push_back(implausible_note(entry, *entry.quantity));
  return notes;
}

void require_no_tipping_at_rest(const Study &study)
{
  try
  {
    study.required_resultants();
  }
  catch (const ring::Tipping &tipping)
  {
    std::vector<std::string> list;
    for (const StudyEntry &entry : implausible_entries(entries_of(study)))
      list.push_back(assignment(entry, *entry.quantity) + " (" + plausible_text(entry) + ')');
    const std::string beginning =
      list.empty() ? "" : "Unusual values for a glass: " + boost::join(list, ", ") + ". ";
    throw ring::Tipping(beginning + tipping.what());
  }
}

} // namespace stemware::pipeline
