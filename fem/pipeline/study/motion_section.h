#pragma once

#include "fem/pipeline/study/entry_facts.h"
#include "ring_model/moment_balance.h"
#include "ring_model/motion.h"
#include "ring_model/orbit_speed_table.h"

#include <map>
#include <memory>
#include <set>
#include <string>

namespace stemware::pipeline
{

/// Subsection Motion: mass of the glass, orbit, friction.
struct MotionSection
{
  ring::Motion orbit;
  /// Height of the hand's force above the table: force offset plus height of the centre of mass [m].
  double hand_height = 0.03;
  ring::Closure closure = ring::Closure::full;
  bool tilt = true;             ///< include the tilt of the glass; see Study::tilts()
  double grip_torque = 0;       ///< maximum torque of the fingers, against the spin [N m]
  std::string orbit_speed_file; ///< v(t) of the spin-up; empty: Motion/Orbit speed throughout
  std::shared_ptr<const ring::OrbitSpeedTable> orbit_speeds = {}; ///< table of that file, if given
  /// Friction coefficient at which a glass at rest starts to slide; 0: the sliding coefficient.
  double breakaway_friction = 0;
  double end_time = 2;      ///< duration of the spin-up [s]
  double euler_step = 1e-3; ///< largest step of the forward Euler method [s]
  double step_limit = 1e6;  ///< estimated steps of the spin-up above which a study is refused

  /// Computes the force offset from hand_height, or hand_height if @p given has Force offset only, after the
  /// entry @p path was assigned. @p here: entries assigned by the present source (file, option); one of these
  /// two entries from a later source removes the other from @p given.
  void place_hand(const std::string &path, std::map<std::string, std::string> &given,
                  std::set<std::string> &here)
  {
    const std::string hand = "Motion/Hand height", offset = "Motion/Force offset";
    if (here.empty() && path != offset && given.count(hand) > 0)
      given.erase(offset);
    here.insert(path);
    if (const std::string &other = path == hand ? offset : hand;
        (path == hand || path == offset) && here.count(other) == 0)
      given.erase(other);
    if (given.count(offset) == 0)
      orbit.force_offset = hand_height - orbit.centre_of_mass_height;
    else if (given.count(hand) == 0)
      hand_height = orbit.centre_of_mass_height + orbit.force_offset;
  }

  /// Declares the entries with their facts. A template, to be compiled in one file only.
  template <typename List>
  void declare(List &list)
  {
    using ring::Closure;
    using ring::OrbitSense;
    const auto &load = list.study.load;
    const bool is_full = load.has_closure() && closure == ring::Closure::full;
    const bool leans = orbit.liquid.mass > 0 && load.has_closure();
    const bool is_stribeck = orbit.friction_law == ring::FrictionLawKind::stribeck;
    const bool hand_stays = list.study.given_entries.count("Motion/Force offset") == 0;
    const auto moves_hand =
      [this, all = &list.study.given_entries, here = std::make_shared<std::set<std::string>>()](auto &entry)
    {
      entry.assign = [=, assign = entry.assign, path = entry.path()](const std::string &text)
      {
        const bool is_assigned = assign(text);
        if (is_assigned)
          place_hand(path, *all, *here);
        return is_assigned;
      };
    };
    list.enter("Motion", true);
    list.number("Mass", orbit.mass, positive, "kg", "Mass of the glass without Liquid mass",
                plausible(0.02, 2, "a liqueur glass to a full beer mug"));
    list.number("Yaw inertia", orbit.yaw_inertia, positive, "kg m^2",
                "Moment of inertia about the axis of the glass; determines the duration of the spin-up, not "
                "the terminal spin",
                plausible(1e-6, 1e-2, "20 g at 7 mm from the axis to 2 kg at 7 cm"));
    list.number("Centre of mass height", orbit.centre_of_mass_height, not_negative, "m",
                "Height of the centre of mass of the glass without Liquid mass above the table; used by the "
                "moment balance full, with liquid, and to find Force offset from Hand height",
                used_if(is_full || leans || (hand_stays && load.has_closure())),
                plausible(0.01, 0.3, "a liqueur glass to a tall flute"), moves_hand);
    list.number(
      "Hand height", hand_height, any_number, "m",
      "Height of the hand's force above the table. Give this or Force offset; the other follows from "
      "Centre of mass height. Unless Force offset is given, the hand stays at its height",
      plausible(0, 0.5, "the table to above a tall flute"), moves_hand);
    list.number("Force offset", orbit.force_offset, any_number, "m",
                "Height of the hand's force minus Centre of mass height, negative when the hand is below it",
                plausible(-0.3, 0.3, "the hand on the glass"), moves_hand);
    list.number("Liquid mass", orbit.liquid.mass, not_negative, "kg",
                "Mass of a liquid in the bowl, whose surface leans outwards on the orbit and which does not "
                "turn with the glass; 0: none",
                plausible(0, 1, "empty to a litre"));
    list.number("Liquid density", orbit.liquid.density, positive, "kg/m^3", "Density of that liquid",
                used_if(leans), plausible(600, 2000, "light petrol to a heavy syrup"));
    list.number(
      "Bowl radius", orbit.liquid.bowl_radius, positive, "m",
      "Inner radius of the bowl at the surface of the liquid; the bowl is a cylinder of that radius",
      used_if(leans), plausible(0.01, 0.1, "a liqueur glass to a goblet"));
    list.number("Bowl height", orbit.liquid.bowl_height, not_negative, "m",
                "Height of the bowl's bottom, inside, above the table", used_if(leans),
                plausible(0, 0.3, "a tumbler to a tall flute"));
    list.number("Bowl depth", orbit.liquid.bowl_depth, positive, "m",
                "From that bottom to the brim; a study whose liquid reaches higher at the wall is refused",
                used_if(leans), plausible(0.01, 0.3, "a saucer to a tall flute"));
    list.number("Orbit radius", orbit.orbit_radius, positive, "m",
                "Radius of the circle on which the glass is led", times_contact_radius(0.01, 1e5),
                plausible(0.01, 2, "fingers to a whole arm"));
    list.number("Orbit speed", orbit.orbit_speed, positive, "m/s", "Speed along that circle",
                plausible(0.01, 3, "hardly moving to as fast as a hand can lead"));
    list.path("Orbit speed file", orbit_speed_file,
              "Speeds of a hand that is no motor, for the spin-up: a CSV file with the header \"t (s), v "
              "(m/s)\" (other units too) and a row for each time, from 0 to End time at least. The hand may "
              "start from rest. All else belongs to Orbit speed. A relative path starts at the study file");
    list.choice(
      "Orbit sense", orbit.orbit_sense,
      { { "counterclockwise", OrbitSense::counterclockwise }, { "clockwise", OrbitSense::clockwise } },
      "Which way round, seen from above: counterclockwise or clockwise");
    list.number("Friction coefficient", orbit.friction_coefficient, positive, "1",
                "Friction between foot and table; of Stribeck's law the kinetic coefficient",
                plausible(0.02, 1.5, "wet and soapy to clean rubber"));
    list.choice(
      "Friction law", orbit.friction_law,
      { { "Coulomb", ring::FrictionLawKind::coulomb }, { "Stribeck", ring::FrictionLawKind::stribeck } },
      "How friction depends on the slip speed s of each place. Coulomb: not at all; Stribeck: mu_k + (mu_s - "
      "mu_k) exp(-(s/v_s)^2) + c s with the kinetic coefficient mu_k in Friction coefficient and the three "
      "entries below");
    list.number("Static friction coefficient", orbit.static_coefficient, positive, "1",
                "mu_s of Stribeck's law, in the limit of no slip", used_if(is_stribeck),
                plausible(0.02, 2, "wet and soapy to clean rubber"));
    list.number(
      "Breakaway friction", breakaway_friction, not_negative, "1",
      "Coefficient of friction at which a glass that rests begins to slide, where the hand of Orbit "
      "speed file starts from rest; 0: Friction coefficient. Stribeck's law has Static friction "
      "coefficient",
      used_if(orbit_speeds && orbit_speeds->starts_from_rest() && !is_stribeck),
      plausible(0.02, 2, "wet and soapy to clean rubber"));
    list.number("Friction decay speed", orbit.friction_decay_speed, positive, "m/s",
                "v_s of Stribeck's law, the slip speed at which the static part has fallen to 1/e",
                used_if(is_stribeck), plausible(1e-4, 1, "creeping to as fast as the glass is led"));
    list.number("Viscous friction", orbit.viscous_friction, not_negative, "s/m",
                "c of Stribeck's law, the growth of the coefficient with the slip speed",
                used_if(is_stribeck), plausible(0, 10, "dry to a thick film of syrup"));
    list.number("Gravity", orbit.gravity, positive, "m/s^2", "Acceleration of free fall",
                plausible(1, 30, "the Moon (1.6) to Jupiter (25)"));
    list.choice("Closure", closure,
                { { "paper", Closure::paper }, { "hand", Closure::hand }, { "full", Closure::full } },
                "Which moments the table's pressure has to balance. paper: the centripetal part of the "
                "hand's force only; hand: the whole force of the hand; full: also the moment of the friction "
                "about the centre of mass",
                used_if(load.has_closure()));
    list.choice("Tilt", tilt, { { "included", true }, { "neglected", false } },
                "Whether the lean of the glass on its foot shifts the centre of mass in the balance of "
                "moments. Acts in the moment balance full, on a contact whose moment is not given",
                used_if(load.is_from_contact() && is_full));
    list.number(
      "Grip torque", grip_torque, not_negative, "N m",
      "Friction of the fingers on the stem, against the spin: at most the friction coefficient of the "
      "fingers times the hand's force times the stem's radius; 0: the stem slips through without",
      plausible(0, 0.1, "no grip to 10 N of fingers on a stem of 1 cm"));
    list.number("End time", end_time, positive, "s", "How long the spin-up is followed",
                plausible(0.01, 1000, "a hundredth of a second to a quarter of an hour"));
    list.number("Euler step", euler_step, positive, "s",
                "Largest step of the forward Euler method that is shown beside the adaptive one");
    list.number("Step limit", step_limit, positive, "1",
                "A study whose spin-up would take more steps is refused before the work");
  }
};

} // namespace stemware::pipeline
