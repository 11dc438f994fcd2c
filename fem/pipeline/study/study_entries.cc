#include "fem/pipeline/study/study_entries.h"

#include "fem/pipeline/study/entry_list.h"
#include "fem/pipeline/study/quantity_text.h"
#include "fem/pipeline/study/renamed_entries.h"
#include "fem/pipeline/support/failures.h"
#include "fem/pipeline/support/numbers.h"
#include "fem/pipeline/support/text.h"

#include <algorithm>
#include <fmt/format.h>
#include <optional>

namespace stemware::pipeline
{

namespace
{

void add_motion(EntryList &list, MotionSection &motion)
{
  using ring::Closure;
  using ring::OrbitSense;
  list.enter("Motion");
  list.number("Mass", motion.orbit.mass, positive, "kg", "Mass of the glass with what is in it");
  list.number(
    "Yaw inertia", motion.orbit.yaw_inertia, positive, "kg m^2",
    "Moment of inertia about the axis of the glass; sets how fast the spin builds up, not where it ends");
  list.number("Centre of mass height", motion.orbit.centre_of_mass_height, not_negative, "m",
              "Height of the centre of mass above the table; used by the closure full");
  list.number(
    "Force offset", motion.orbit.force_offset, any_number, "m",
    "Height of the hand's force minus that of the centre of mass, negative when the hand is below it");
  list.number("Orbit radius", motion.orbit.orbit_radius, positive, "m",
              "Radius of the circle on which the glass is led");
  list.number("Orbit speed", motion.orbit.orbit_speed, positive, "m/s", "Speed along that circle");
  list.path(
    "Orbit speed file", motion.orbit_speed_file,
    "Speeds of a hand that is no motor, for the spin-up: a CSV file with the header \"t (s), v (m/s)\" "
    "(other units too) and a row for each time, from 0 to End time at least. All else belongs to Orbit "
    "speed. A relative "
    "path starts at the study file");
  list.choice(
    "Orbit sense", motion.orbit.orbit_sense,
    { { "counterclockwise", OrbitSense::counterclockwise }, { "clockwise", OrbitSense::clockwise } },
    "Which way round, seen from above: counterclockwise or clockwise");
  list.number("Friction coefficient", motion.orbit.friction_coefficient, positive, "",
              "Friction between foot and table; of Stribeck's law the kinetic coefficient");
  list.choice(
    "Friction law", motion.orbit.friction_law,
    { { "Coulomb", ring::FrictionLawKind::coulomb }, { "Stribeck", ring::FrictionLawKind::stribeck } },
    "How friction depends on the slip speed s of each place. Coulomb: not at all; Stribeck: "
    "mu_k + (mu_s - mu_k) exp(-(s/v_s)^2) + c s with the kinetic coefficient mu_k in Friction "
    "coefficient and the three entries below");
  list.number("Static friction coefficient", motion.orbit.static_coefficient, positive, "",
              "mu_s of Stribeck's law, in the limit of no slip");
  list.number("Friction decay speed", motion.orbit.friction_decay_speed, positive, "m/s",
              "v_s of Stribeck's law, the slip speed at which the static part has fallen to 1/e");
  list.number("Viscous friction", motion.orbit.viscous_friction, not_negative, "s/m",
              "c of Stribeck's law, the growth of the coefficient with the slip speed");
  list.number("Gravity", motion.orbit.gravity, positive, "m/s^2", "Acceleration of free fall");
  list.choice("Closure", motion.closure,
              { { "paper", Closure::paper }, { "hand", Closure::hand }, { "full", Closure::full } },
              "Which moments the table's pressure has to balance. paper: the centripetal part of the hand's "
              "force only; hand: the whole force of the hand; full: also the moment of the friction about "
              "the centre of mass");
  list.choice(
    "Tilt", motion.tilt, { { "included", true }, { "neglected", false } },
    "Whether the lean of the glass on its foot shifts the centre of mass in the balance of moments. "
    "Acts in the closure full, on a contact whose moment is not given");
  list.number(
    "Grip torque", motion.grip_torque, not_negative, "N m",
    "Friction of the fingers on the stem, against the spin: at most the friction coefficient of the "
    "fingers times the hand's force times the stem's radius; 0: the stem slips through without");
  list.number("End time", motion.end_time, positive, "s", "How long the spin-up is followed");
  list.number("Euler step", motion.euler_step, positive, "s",
              "Largest step of the forward Euler method that is shown beside the adaptive one");
  list.number("Step limit", motion.step_limit, positive, "",
              "A study whose spin-up would take more steps is refused before the work");
}

void add_glass(EntryList &list, GlassSection &glass)
{
  using fem::GlassShape;
  fem::GlassProfile &profile = glass.profile;
  list.enter("Glass");
  list.choice(
    "Shape", profile.shape,
    { { "step", GlassShape::step }, { "foot", GlassShape::foot }, { "profile", GlassShape::profile } },
    "Section of the glass near the table. step: a plate on a ring (the land) under a cylinder (the stem); "
    "foot: the foot of a wine glass, concave below, tapering to its edge, rounded into the stem; profile: "
    "the points in Profile file");
  list.path("Profile file", glass.profile_file,
            "Points (r, z) of the section's outline for Shape = profile, a CSV file (in m, or with the "
            "header \"r (mm), z (mm)\"): from the axis "
            "under the foot along the underside, round the edge, over the top and up the stem to the axis in "
            "its cut. A contact radius or crown radius that the study does not give follows from the points "
            "of the land. A relative path starts at the study file");
  list.number("Contact radius", profile.contact_radius, positive, "m",
              "Radius R of the rim that stands on the table");
  list.number("Foot radius", profile.foot_radius, positive, "m", "Outer radius of the foot");
  list.number("Foot thickness", profile.foot_thickness, positive, "m",
              "Thickness of a step above the land, of a foot where its top meets the stem");
  list.number("Land width", profile.land_width, positive, "m",
              "Width of the zone that may touch the table, half of it on either side of the contact radius");
  list.number("Land height", profile.land_height, positive, "m",
              "How far the land stands out below a step, or below the outer edge of a foot");
  list.number("Crown radius", profile.crown_radius, not_negative, "m",
              "Radius of the rim's rounding, seen in a cut through the axis; 0 means a flat land");
  list.number("Underside rise", profile.underside_rise, not_negative, "m",
              "Height of the underside of a foot on the axis, above the land; without effect on a step");
  list.number("Edge thickness", profile.edge_thickness, positive, "m",
              "Thickness of a foot at its outer edge; without effect on a step");
  list.number("Fillet radius", profile.fillet_radius, not_negative, "m",
              "Radius of the rounding between the top of a foot and the stem, 0 for a sharp corner; without "
              "effect on a step");
  list.number("Stem radius", profile.stem_radius, positive, "m", "Radius of the stem");
  list.number("Stem height", profile.stem_height, positive, "m",
              "From the top of the foot, where it meets the stem, to the cut through the stem");
  list.number("Young modulus", glass.material.young_modulus, positive, "Pa", "Young's modulus of the glass");
  list.number("Poisson ratio", glass.material.poisson_ratio, between(-1, 0.5), "",
              "Poisson's ratio of the glass");
  list.waviness("Rim waviness", glass.waviness,
                "How the rim is out of flat: harmonics of its height above the table, fixed to the glass and "
                "positive where it is higher. At the start azimuth 0 points away from the orbit's centre. "
                "Body of revolution only");
}

void add_table(EntryList &list, TableSection &table)
{
  list.enter("Table");
  list.choice("Interface", table.interface,
              { { "hard", TableInterface::hard },
                { "Winkler", TableInterface::winkler },
                { "rough", TableInterface::rough } },
              "How foot and table touch. hard: without penetration; Winkler: pressure proportional to the "
              "penetration, a layer much thinner than the contact is wide; rough: asperities, pressure "
              "exponential in the distance");
  list.choice(
    "Substrate", table.substrate,
    { { "rigid", TableSubstrate::rigid }, { "elastic", TableSubstrate::elastic } },
    "What lies under the interface. elastic: a disc of a material of its own, held at its bottom: a "
    "table top, or a layer of cork (body of revolution only)");
  list.number("Foundation modulus", table.foundation_modulus, positive, "Pa/m",
              "Pressure of a Winkler interface per depth of penetration");
  list.number(
    "Layer thickness", table.layer_thickness, not_negative, "m",
    "Thickness of the layer that a Winkler interface stands for, 0 where it stands for none. Changes "
    "no result: it lets the study say where the contact is too narrow for such an interface");
  list.number("Reference pressure", table.roughness.reference_pressure, positive, "Pa",
              "Pressure of a rough interface where the mean planes of the two surfaces touch");
  list.number("Decay length", table.roughness.decay_length, positive, "m",
              "Distance over which a rough interface's pressure falls by e, about its rms roughness");
  list.number("Disc radius", table.disc.radius, positive, "m", "Radius of the disc of an elastic substrate");
  list.number("Disc thickness", table.disc.thickness, positive, "m",
              "Thickness of that disc, which is held at its bottom");
  list.number("Disc Young modulus", table.disc_material.young_modulus, positive, "Pa",
              "Young's modulus of the disc (hardwood 10e9, cork 5e6)");
  list.number("Disc Poisson ratio", table.disc_material.poisson_ratio, between(-1, 0.5), "",
              "Poisson's ratio of the disc (cork 0)");
  list.waviness(
    "Waviness", table.waviness,
    "How the table is out of flat: harmonics of its depth, fixed to the ground and positive where it is "
    "lower. At the start azimuth 0 points away from the orbit's centre. Body of revolution only");
}

void add_contact(EntryList &list, ContactSection &contact)
{
  using fem::LinearSolver;
  list.enter("Contact");
  list.choice("Body", contact.body, { { "solid", BodyKind::solid }, { "revolution", BodyKind::revolution } },
              "revolution: displacement harmonics on a meridional mesh, for feet that are bodies of "
              "revolution: fast, and the way to elastic tables; solid: the foot in three-dimensional finite "
              "elements, for any mesh");
  list.path("Mesh file", contact.mesh_file,
            "Mesh of the foot (.msh, .inp or .vtu, hexahedra), which then also gives its shape; empty: "
            "generated from "
            "the subsection Glass. A relative path starts at the study file");
  list.count("Mesh contact id", contact.mesh_marks.contact_id, 1, 65000,
             "Id of the faces of the mesh file that may touch the table");
  list.count("Mesh stem id", contact.mesh_marks.stem_id, 1, 65000,
             "Id of the faces of the mesh file where the stem was cut");
  list.number(
    "Mesh contact height", contact.mesh_marks.contact_height, not_negative, "m",
    "All faces of the mesh file that look down and lie at most this high above its lowest point may "
    "touch the table, whatever their ids; 0: those of the id");
  list.count("Degree", contact.degree, 1, 4,
             "Polynomial degree of the elements: 1 or 2 for a solid body, 1 to 4 for a body of revolution");
  list.count("Azimuthal cells", contact.resolution.azimuthal_cells, 8, 2000,
             "Cells round the rim of the generated mesh of a solid body, a multiple of 4");
  list.count("Radial cells", contact.resolution.radial_cells, 2, 200,
             "Cells across the land of a generated mesh, an even number");
  list.count("Foot layers", contact.resolution.foot_layers, 1, 100,
             "Cells through the thickness of the foot of the generated mesh of a solid body");
  list.count(
    "Refinements", contact.refinements, 0, 6,
    "Halvings of every cell of the mesh with these counts; the way to a large solid body, which is then "
    "solved by multigrid over the meshes between");
  list.number("Land grading", contact.land_grading,
              { "a number from 1 to 10", [](double value) { return 1 <= value && value <= 10; } }, "",
              "Size of a cell of the land over that of its neighbour nearer to the contact radius, for a "
              "crowned body of revolution; 1 means equal cells");
  list.choice("Linear solver", contact.linear_solver,
              { { "automatic", LinearSolver::automatic },
                { "direct", LinearSolver::direct },
                { "multigrid", LinearSolver::multigrid } },
              "automatic: direct for small systems, multigrid for large ones");
  list.count("Harmonics", contact.harmonics, 1, 1000,
             "Elastic harmonics of a body of revolution; without effect on a solid body");
  list.count("Azimuth lines", contact.azimuth_lines, 16, 100000,
             "Azimuths at which a body of revolution meets the table, more than twice the harmonics; without "
             "effect on a solid body");
  list.count(
    "Rings", contact.rings, 1, most_rings,
    "Circles that take the pressure over, with all its radial moments below that number; 1: one ring "
    "of the radius that the moment asks for. More than 25 would magnify rounding");
  list.count("Load harmonics", contact.load_harmonics, 0, 1000,
             "Harmonics of each ring's load; 0: as many as the lines resolve and the torque asks for");
  list.choice(
    "Friction coupling", contact.friction_coupling,
    { { "elastic", FrictionCoupling::elastic }, { "none", FrictionCoupling::none } },
    "elastic: the friction's tractions deform the foot and an elastic substrate; none: friction does not act "
    "back on the pressure");
  list.choice("Goal", contact.goal,
              { { "none", Goal::none },
                { "terminal spin", Goal::terminal_spin },
                { "a2", Goal::a2 },
                { "torque", Goal::torque } },
              "What the cells that matter are halved for (torque: at half the terminal spin)");
  list.number("Goal tolerance", contact.goal_tolerance, positive, "",
              "Error left of the goal, over its value");
  list.folder(
    "Checkpoint folder", contact.checkpoint_folder,
    "Folder for the state of a long contact solve of a refined solid body, kept after each Newton step: "
    "the same study goes on from there when it was killed; empty: none. The state of another study is kept "
    "and said. A relative path starts at the study file");
  list.number("Memory limit", contact.memory_limit, positive, "B", "More is refused before the work");
}

void add_load(EntryList &list, LoadSection &load)
{
  list.enter("Load");
  list.choice("Source", load.source,
              { { "contact", LoadSource::contact },
                { "first harmonic", LoadSource::first_harmonic },
                { "file", LoadSource::file } },
              "contact: the finite-element contact; first harmonic: the paper's ansatz, in balance with the "
              "closure at every spin; file: Fourier coefficients from a file");
  list.choice("Coupling", load.coupling,
              { { "two-way", LoadCoupling::two_way }, { "one-way", LoadCoupling::one_way } },
              "two-way: contact, friction and moments are in balance at every spin; one-way: the load of the "
              "glass that does not spin yet is kept at every spin, as a given moment and a load from a file "
              "are by nature");
  list.number("Moment ratio", load.moment_ratio, not_tipping, "",
              "Moment of the table's pressure over N R / 2 for a static study; negative: the closure's "
              "moment. The foot tips at 2");
  list.number("Moment direction", load.moment_direction, any_number, "rad",
              "Where a static study's load is largest, counter-clockwise from the direction of travel; used "
              "with Moment ratio >= 0");
  list.path("File", load.file,
            "Fourier coefficients for Source = file: a line \"# ring radius: 0.03 (m)\", then rows n a_n b_n "
            "(N/rad) for n = 0, 1, 2, ...; harmonics.dat of a results folder is such a file");
}

} // namespace

std::vector<StudyEntry> study_entries(Study &study)
{
  EntryList list;
  add_motion(list, study.motion);
  add_glass(list, study.glass);
  add_table(list, study.table);
  add_contact(list, study.contact);
  add_load(list, study.load);
  for (StudyEntry &entry : list.entries)
    entry.assign = [&study, path = entry.path(), assign = entry.assign](const std::string &text)
    {
      const bool is_allowed = assign(text);
      if (is_allowed)
        study.given_entries.insert(path);
      return is_allowed;
    };
  return list.entries;
}

const StudyEntry &entry_at(const std::vector<StudyEntry> &entries, const std::string &origin,
                           const std::string &path)
{
  refuse_renamed(origin, path);
  const auto entry = std::find_if(entries.begin(), entries.end(),
                                  [&](const StudyEntry &candidate) { return candidate.path() == path; });
  require(entry != entries.end(), fmt::format(FMT_STRING("{}there is no entry \"{}\"{}"), origin,
                                              shortened(path), suggestion(entries, path)));
  return *entry;
}

void assign(const StudyEntry &entry, const std::string &origin, const std::string &value)
{
  if (entry.assign(value))
    return;
  const std::string trouble = entry.is_quantity ? trouble_with_unit(value, entry.unit) : "";
  throw BadInput(fmt::format(FMT_STRING("{}{} = {}{}"), origin, entry.path(),
                             value.empty() ? "(nothing)" : shortened(value),
                             trouble.empty() ? " is not allowed; give " + entry.allowed + '.' : trouble));
}

void assign(const std::vector<StudyEntry> &entries, const std::string &origin, const std::string &path,
            const std::string &value)
{
  refuse_renamed(origin, path, value);
  assign(entry_at(entries, origin, path), origin, value);
}

std::string suggestion(const std::vector<StudyEntry> &entries, const std::string &word)
{
  std::vector<std::string> names, paths;
  for (const StudyEntry &entry : entries)
  {
    names.push_back(entry.name);
    paths.push_back(entry.path());
  }
  std::optional<std::string> meant = likeliest(word, paths);
  if (const auto name = likeliest(word, names); name && !meant)
    meant = paths[static_cast<std::size_t>(std::find(names.begin(), names.end(), *name) - names.begin())];
  return meant ? "; did you mean " + *meant + "? (`stemware defaults` lists what there is.)"
               : "; `stemware defaults` lists what there is.";
}

nlohmann::ordered_json study_as_json(const Study &study)
{
  Study copy = study;
  nlohmann::ordered_json sections;
  for (const StudyEntry &entry : study_entries(copy))
    sections[entry.section][entry.name] = entry.json();
  return sections;
}

} // namespace stemware::pipeline
