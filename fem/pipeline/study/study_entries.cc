#include "fem/pipeline/study/study_entries.h"

#include "fem/pipeline/study/entry_list.h"
#include "fem/pipeline/study/quantity_text.h"
#include "fem/pipeline/support/failures.h"
#include "fem/pipeline/support/numbers.h"
#include "fem/pipeline/support/text.h"

#include <algorithm>
#include <optional>

namespace stemware::pipeline
{

namespace
{

// Where entries have an effect.
using Condition = StudyEntry::Condition;
constexpr Condition always = [](const Study &) { return true; };
constexpr Condition is_static = [](const Study &study) { return study.load.is_static(); };
constexpr Condition has_balance = [](const Study &study)
{ return !study.load.is_static() && study.load.source != LoadSource::file; };
constexpr Condition is_full = [](const Study &study)
{ return has_balance(study) && study.motion.closure == ring::Closure::full; };
constexpr Condition is_stribeck = [](const Study &study)
{ return study.motion.orbit.friction_law == ring::FrictionLawKind::stribeck; };
constexpr Condition has_contact = [](const Study &study) { return study.load.is_from_contact(); };
constexpr Condition may_tilt = [](const Study &study) { return has_contact(study) && is_full(study); };
constexpr Condition is_balanced_contact = [](const Study &study)
{ return has_contact(study) && has_balance(study); };
constexpr Condition is_generated = [](const Study &study)
{ return has_contact(study) && study.contact.mesh_file.empty(); };
constexpr Condition has_mesh_file = [](const Study &study)
{ return has_contact(study) && !study.contact.mesh_file.empty(); };
constexpr Condition is_foot = [](const Study &study)
{ return is_generated(study) && study.glass.profile.shape == fem::GlassShape::foot; };
constexpr Condition is_drawn = [](const Study &study)
{ return is_generated(study) && study.glass.profile.shape == fem::GlassShape::profile; };
constexpr Condition is_step_or_foot = [](const Study &study)
{ return is_generated(study) && !is_drawn(study); };
constexpr Condition is_winkler = [](const Study &study)
{ return has_contact(study) && study.table.interface == TableInterface::winkler; };
constexpr Condition is_rough = [](const Study &study)
{ return has_contact(study) && study.table.interface == TableInterface::rough; };
constexpr Condition is_on_disc = [](const Study &study)
{ return has_contact(study) && study.table.substrate == TableSubstrate::elastic; };
constexpr Condition is_of_revolution = [](const Study &study)
{ return has_contact(study) && abilities(study.contact.body).is_of_revolution; };
constexpr Condition is_crowned = [](const Study &study)
{ return is_of_revolution(study) && study.glass.profile.crown_radius > 0; };
constexpr Condition is_solid = [](const Study &study)
{ return has_contact(study) && !is_of_revolution(study); };
constexpr Condition is_generated_solid = [](const Study &study)
{ return is_solid(study) && is_generated(study); };

/// Bounds of a length over the contact radius: what lies outside is most likely given in another unit.
constexpr double smallest = 1e-5, largest = 300;

void add_motion(EntryList &list, MotionSection &motion)
{
  using ring::Closure;
  using ring::OrbitSense;
  list.enter("Motion", always);
  list.number("Mass", motion.orbit.mass, positive, "kg", "Mass of the glass with what is in it",
              { plausible(0.02, 2, "a liqueur glass to a full beer mug") });
  list.number(
    "Yaw inertia", motion.orbit.yaw_inertia, positive, "kg m^2",
    "Moment of inertia about the axis of the glass; sets how fast the spin builds up, not where it ends",
    { plausible(1e-6, 1e-2, "20 g at 7 mm from the axis to 2 kg at 7 cm") });
  list.number("Centre of mass height", motion.orbit.centre_of_mass_height, not_negative, "m",
              "Height of the centre of mass above the table; used by the closure full",
              { used_if(is_full), plausible(0.01, 0.3, "a liqueur glass to a tall flute") });
  list.number(
    "Force offset", motion.orbit.force_offset, any_number, "m",
    "Height of the hand's force minus that of the centre of mass, negative when the hand is below it",
    { plausible(-0.3, 0.3, "the hand on the glass") });
  list.number("Orbit radius", motion.orbit.orbit_radius, positive, "m",
              "Radius of the circle on which the glass is led",
              { times_contact_radius(0.01, 1e5), plausible(0.01, 2, "fingers to a whole arm") });
  list.number("Orbit speed", motion.orbit.orbit_speed, positive, "m/s", "Speed along that circle",
              { plausible(0.01, 3, "hardly moving to as fast as a hand can lead") });
  list.path("Orbit speed file", motion.orbit_speed_file,
            "Speeds of a hand that is no motor, for the spin-up: a CSV file with the header \"t (s), v "
            "(m/s)\" (other units too) and a row for each time, from 0 to End time at least. All else "
            "belongs to Orbit speed. A relative path starts at the study file");
  list.path("Measured spin file", motion.measured_spin_file,
            "Spins of a real glass, to be drawn beside the spin-up; nothing is fitted to them. A CSV file "
            "with the header \"t (s), omega (rad/s)\" (other units too) and a row for each point, clockwise "
            "negative. A relative path starts at the study file");
  list.choice(
    "Orbit sense", motion.orbit.orbit_sense,
    { { "counterclockwise", OrbitSense::counterclockwise }, { "clockwise", OrbitSense::clockwise } },
    "Which way round, seen from above: counterclockwise or clockwise");
  list.number("Friction coefficient", motion.orbit.friction_coefficient, positive, "",
              "Friction between foot and table; of Stribeck's law the kinetic coefficient",
              { plausible(0.02, 1.5, "wet and soapy to clean rubber") });
  list.choice(
    "Friction law", motion.orbit.friction_law,
    { { "Coulomb", ring::FrictionLawKind::coulomb }, { "Stribeck", ring::FrictionLawKind::stribeck } },
    "How friction depends on the slip speed s of each place. Coulomb: not at all; Stribeck: mu_k + (mu_s - "
    "mu_k) exp(-(s/v_s)^2) + c s with the kinetic coefficient mu_k in Friction coefficient and the three "
    "entries below");
  list.number("Static friction coefficient", motion.orbit.static_coefficient, positive, "",
              "mu_s of Stribeck's law, in the limit of no slip",
              { used_if(is_stribeck), plausible(0.02, 2, "wet and soapy to clean rubber") });
  list.number("Friction decay speed", motion.orbit.friction_decay_speed, positive, "m/s",
              "v_s of Stribeck's law, the slip speed at which the static part has fallen to 1/e",
              { used_if(is_stribeck), plausible(1e-4, 1, "creeping to as fast as the glass is led") });
  list.number("Viscous friction", motion.orbit.viscous_friction, not_negative, "s/m",
              "c of Stribeck's law, the growth of the coefficient with the slip speed",
              { used_if(is_stribeck), plausible(0, 10, "dry to a thick film of syrup") });
  list.number("Gravity", motion.orbit.gravity, positive, "m/s^2", "Acceleration of free fall",
              { plausible(1, 30, "the Moon (1.6) to Jupiter (25)") });
  list.choice(
    "Closure", motion.closure,
    { { "paper", Closure::paper }, { "hand", Closure::hand }, { "full", Closure::full } },
    "Which moments the table's pressure has to balance. paper: the centripetal part of the hand's force "
    "only; hand: the whole force of the hand; full: also the moment of the friction about the centre of mass",
    { used_if(has_balance) });
  list.choice("Tilt", motion.tilt, { { "included", true }, { "neglected", false } },
              "Whether the lean of the glass on its foot shifts the centre of mass in the balance of "
              "moments. Acts in the closure full, on a contact whose moment is not given",
              { used_if(may_tilt) });
  list.number("Grip torque", motion.grip_torque, not_negative, "N m",
              "Friction of the fingers on the stem, against the spin: at most the friction coefficient of "
              "the fingers times the hand's force times the stem's radius; 0: the stem slips through without",
              { plausible(0, 0.1, "no grip to 10 N of fingers on a stem of 1 cm") });
  list.number("End time", motion.end_time, positive, "s", "How long the spin-up is followed",
              { plausible(0.01, 1000, "a hundredth of a second to a quarter of an hour") });
  list.number("Euler step", motion.euler_step, positive, "s",
              "Largest step of the forward Euler method that is shown beside the adaptive one");
  list.number("Step limit", motion.step_limit, positive, "",
              "A study whose spin-up would take more steps is refused before the work");
}

void add_glass(EntryList &list, GlassSection &glass)
{
  using fem::GlassShape;
  fem::GlassProfile &profile = glass.profile;
  list.enter("Glass", has_contact);
  list.choice(
    "Shape", profile.shape,
    { { "step", GlassShape::step }, { "foot", GlassShape::foot }, { "profile", GlassShape::profile } },
    "Section of the glass near the table. step: a plate on a ring (the land) under a cylinder (the stem); "
    "foot: the foot of a wine glass, concave below, tapering to its edge, rounded into the stem; profile: "
    "the points in Profile file",
    { used_if(is_generated) });
  list.path(
    "Profile file", glass.profile_file,
    "Points (r, z) of the section's outline for Shape = profile, a CSV file (in m, or with the header \"r "
    "(mm), z (mm)\"): from the axis under the foot along the underside, round the edge, over the top and up "
    "the stem to the axis in its cut. A contact radius or crown radius that the study does not give follows "
    "from the points of the land. A relative path starts at the study file",
    { used_if(is_drawn) });
  list.number(
    "Contact radius", profile.contact_radius, positive, "m", "Radius R of the rim that stands on the table",
    { used_if(always), follows_from_profile, plausible(0.005, 0.1, "a liqueur glass to a carafe") });
  list.number("Foot radius", profile.foot_radius, positive, "m", "Outer radius of the foot",
              { used_if(is_step_or_foot), times_contact_radius(smallest, largest),
                plausible(0.006, 0.12, "a liqueur glass to a carafe") });
  list.number("Foot thickness", profile.foot_thickness, positive, "m",
              "Thickness of a step above the land, of a foot where its top meets the stem",
              { used_if(is_step_or_foot), times_contact_radius(0.01, largest),
                plausible(5e-4, 0.03, "the thinnest blown foot to a pressed base") });
  list.number("Land width", profile.land_width, positive, "m",
              "Width of the zone that may touch the table, half of it on either side of the contact radius",
              { used_if(is_generated), times_contact_radius(smallest, largest),
                plausible(1e-4, 0.03, "a ground edge to a broad ring") });
  list.number("Land height", profile.land_height, positive, "m",
              "How far the land stands out below a step, or below the outer edge of a foot",
              { used_if(is_step_or_foot), times_contact_radius(smallest, largest),
                plausible(1e-5, 0.02, "a polished to a deep ring") });
  list.number("Crown radius", profile.crown_radius, not_negative, "m",
              "Radius of the rim's rounding, seen in a cut through the axis; 0 means a flat land",
              { follows_from_profile,
                plausible(1e-4, 0.2, "a ground edge to a rim that is nearly flat; 0 is a flat land") });
  list.number("Underside rise", profile.underside_rise, not_negative, "m",
              "Height of the underside of a foot on the axis, above the land; without effect on a step",
              { used_if(is_foot), plausible(0, 0.03, "flat to a deep kick") });
  list.number("Edge thickness", profile.edge_thickness, positive, "m",
              "Thickness of a foot at its outer edge; without effect on a step",
              { used_if(is_foot), times_contact_radius(smallest, largest),
                plausible(2e-4, 0.02, "the thinnest blown foot to a pressed base") });
  list.number("Fillet radius", profile.fillet_radius, not_negative, "m",
              "Radius of the rounding between the top of a foot and the stem, 0 for a sharp corner; without "
              "effect on a step",
              { used_if(is_foot), plausible(0, 0.05, "a sharp corner to a trumpet foot") });
  list.number("Stem radius", profile.stem_radius, positive, "m", "Radius of the stem",
              { used_if(is_step_or_foot), times_contact_radius(smallest, largest),
                plausible(0.0015, 0.06, "a drawn stem to the body of a tumbler") });
  list.number("Stem height", profile.stem_height, positive, "m",
              "From the top of the foot, where it meets the stem, to the cut through the stem",
              { used_if(is_step_or_foot), times_contact_radius(smallest, largest),
                plausible(5e-4, 0.2, "a cut close to the foot to the longest stem") });
  list.number("Young modulus", glass.material.young_modulus, positive, "Pa", "Young's modulus of the glass",
              { plausible(1e9, 2.5e11, "plastic (2 GPa), lead crystal (60), soda lime (70), steel (210)") });
  list.number("Poisson ratio", glass.material.poisson_ratio, between(-1, 0.5), "",
              "Poisson's ratio of the glass", { plausible(0, 0.49, "cork (0) to nearly incompressible") });
  list.waviness("Rim waviness", glass.waviness,
                "How the rim is out of flat: harmonics of its height above the table, fixed to the glass and "
                "positive where it is higher. At the start azimuth 0 points away from the orbit's centre. "
                "Body of revolution only");
}

void add_table(EntryList &list, TableSection &table)
{
  list.enter("Table", has_contact);
  list.choice(
    "Interface", table.interface,
    { { "hard", TableInterface::hard },
      { "Winkler", TableInterface::winkler },
      { "rough", TableInterface::rough } },
    "How foot and table touch. hard: without penetration; Winkler: pressure proportional to the penetration, "
    "a layer much thinner than the contact is wide; rough: asperities, pressure exponential in the distance");
  list.choice("Substrate", table.substrate,
              { { "rigid", TableSubstrate::rigid }, { "elastic", TableSubstrate::elastic } },
              "What lies under the interface. elastic: a disc of a material of its own, held at its bottom: "
              "a table top, or a layer of cork (body of revolution only)");
  list.number("Foundation modulus", table.foundation_modulus, positive, "Pa/m",
              "Pressure of a Winkler interface per depth of penetration",
              { used_if(is_winkler), plausible(1e7, 1e14, "5 cm of foam to a micrometre of dirt") });
  list.number(
    "Layer thickness", table.layer_thickness, not_negative, "m",
    "Thickness of the layer that a Winkler interface stands for, 0 where it stands for none. Changes no "
    "result: it lets the study say where the contact is too narrow for such an interface",
    { used_if(is_winkler), plausible(0, 0.1, "a film to a cushion") });
  list.number("Reference pressure", table.roughness.reference_pressure, positive, "Pa",
              "Pressure of a rough interface where the mean planes of the two surfaces touch",
              { used_if(is_rough), plausible(1e5, 1e11, "a tenth of the softer body's modulus") });
  list.number(
    "Decay length", table.roughness.decay_length, positive, "m",
    "Distance over which a rough interface's pressure falls by e, about its rms roughness",
    { used_if(is_rough), plausible(1e-9, 1e-4, "float glass to sawn wood: half the rms roughness") });
  list.number("Disc radius", table.disc.radius, positive, "m", "Radius of the disc of an elastic substrate",
              { used_if(is_on_disc), times_contact_radius(smallest, largest),
                plausible(0.02, 3, "larger than the foot, up to a table") });
  list.number("Disc thickness", table.disc.thickness, positive, "m",
              "Thickness of that disc, which is held at its bottom",
              { used_if(is_on_disc), times_contact_radius(0.001, largest),
                plausible(1e-4, 0.5, "a tablecloth to a block") });
  list.number("Disc Young modulus", table.disc_material.young_modulus, positive, "Pa",
              "Young's modulus of the disc (hardwood 10e9, cork 5e6)",
              { used_if(is_on_disc), plausible(1e5, 1.2e12, "foam to diamond") });
  list.number("Disc Poisson ratio", table.disc_material.poisson_ratio, between(-1, 0.5), "",
              "Poisson's ratio of the disc (cork 0)",
              { used_if(is_on_disc), plausible(-0.2, 0.499, "cork (0), wood (0.3), rubber (0.49)") });
  list.waviness(
    "Waviness", table.waviness,
    "How the table is out of flat: harmonics of its depth, fixed to the ground and positive where it is "
    "lower. At the start azimuth 0 points away from the orbit's centre. Body of revolution only");
}

void add_contact(EntryList &list, ContactSection &contact)
{
  using fem::LinearSolver;
  list.enter("Contact", has_contact);
  list.choice(
    "Body", contact.body, { { "solid", BodyKind::solid }, { "revolution", BodyKind::revolution } },
    "revolution: displacement harmonics on a meridional mesh, for feet that are bodies of revolution: fast, "
    "and the way to elastic tables; solid: the foot in three-dimensional finite elements, for any mesh");
  list.path("Mesh file", contact.mesh_file,
            "Mesh of the foot (.msh, .inp or .vtu, hexahedra), which then also gives its shape; empty: "
            "generated from the subsection Glass. A relative path starts at the study file");
  list.count("Mesh contact id", contact.mesh_marks.contact_id, 1, 65000,
             "Id of the faces of the mesh file that may touch the table", { used_if(has_mesh_file) });
  list.count("Mesh stem id", contact.mesh_marks.stem_id, 1, 65000,
             "Id of the faces of the mesh file where the stem was cut", { used_if(has_mesh_file) });
  list.number("Mesh contact height", contact.mesh_marks.contact_height, not_negative, "m",
              "All faces of the mesh file that look down and lie at most this high above its lowest point "
              "may touch the table, whatever their ids; 0: those of the id",
              { used_if(has_mesh_file) });
  list.count("Degree", contact.degree, 1, 4,
             "Polynomial degree of the elements: 1 or 2 for a solid body, 1 to 4 for a body of revolution");
  list.count("Azimuthal cells", contact.resolution.azimuthal_cells, 8, 2000,
             "Cells round the rim of the generated mesh of a solid body, a multiple of 4",
             { used_if(is_generated_solid) });
  list.count("Radial cells", contact.resolution.radial_cells, 2, 200,
             "Cells across the land of a generated mesh, an even number", { used_if(is_generated) });
  list.count("Foot layers", contact.resolution.foot_layers, 1, 100,
             "Cells through the thickness of the foot of the generated mesh of a solid body",
             { used_if(is_generated_solid) });
  list.count("Refinements", contact.refinements, 0, 6,
             "Halvings of every cell of the mesh with these counts; the way to a large solid body, which is "
             "then solved by multigrid over the meshes between");
  list.number("Land grading", contact.land_grading,
              { "a number from 1 to 10", [](double value) { return 1 <= value && value <= 10; } }, "",
              "Size of a cell of the land over that of its neighbour nearer to the contact radius, for a "
              "crowned body of revolution; 1 means equal cells",
              { used_if(is_crowned) });
  list.choice("Linear solver", contact.linear_solver,
              { { "automatic", LinearSolver::automatic },
                { "direct", LinearSolver::direct },
                { "multigrid", LinearSolver::multigrid } },
              "automatic: direct for small systems, multigrid for large ones", { used_if(is_solid) });
  list.count("Harmonics", contact.harmonics, 1, 1000,
             "Elastic harmonics of a body of revolution; without effect on a solid body",
             { used_if(is_of_revolution) });
  list.count("Azimuth lines", contact.azimuth_lines, 16, 100000,
             "Azimuths at which a body of revolution meets the table, more than twice the harmonics; without "
             "effect on a solid body",
             { used_if(is_of_revolution) });
  list.count("Rings", contact.rings, 1, most_rings,
             "Circles that take the pressure over, with all its radial moments below that number; 1: one "
             "ring of the radius that the moment asks for. More than 25 would magnify rounding");
  list.count("Load harmonics", contact.load_harmonics, 0, 1000,
             "Harmonics of each ring's load; 0: as many as the lines resolve and the torque asks for");
  list.choice("Friction coupling", contact.friction_coupling,
              { { "elastic", FrictionCoupling::elastic }, { "none", FrictionCoupling::none } },
              "elastic: the friction's tractions deform the foot and an elastic substrate; none: friction "
              "does not act back on the pressure");
  list.choice("Goal", contact.goal,
              { { "none", Goal::none },
                { "terminal spin", Goal::terminal_spin },
                { "a2", Goal::a2 },
                { "torque", Goal::torque } },
              "What the cells that matter are halved for (torque: at half the terminal spin)");
  list.number("Goal tolerance", contact.goal_tolerance, positive, "",
              "Error left of the goal, over its value");
  list.path("Checkpoint folder", contact.checkpoint_folder,
            "Folder for the state of a long contact solve of a refined solid body, kept after each Newton "
            "step: the same study goes on from there when it was killed; empty: none. The state of another "
            "study is kept and said. A relative path starts at the study file",
            { used_if(is_solid), of_a_folder });
  list.number("Memory limit", contact.memory_limit, positive, "B", "More is refused before the work");
}

void add_load(EntryList &list, LoadSection &load)
{
  list.enter("Load", always);
  list.choice("Source", load.source,
              { { "contact", LoadSource::contact },
                { "first harmonic", LoadSource::first_harmonic },
                { "file", LoadSource::file } },
              "contact: the finite-element contact; first harmonic: the paper's ansatz, in balance with the "
              "closure at every spin; file: Fourier coefficients from a file");
  list.choice(
    "Coupling", load.coupling, { { "two-way", LoadCoupling::two_way }, { "one-way", LoadCoupling::one_way } },
    "two-way: contact, friction and moments are in balance at every spin; one-way: the load of the glass "
    "that does not spin yet is kept at every spin, as a given moment and a load from a file are by nature",
    { used_if(is_balanced_contact) });
  list.number("Moment ratio", load.moment_ratio, not_tipping, "",
              "Moment of the table's pressure over N R / 2 for a static study; negative: the closure's "
              "moment. The foot tips at 2");
  list.number("Moment direction", load.moment_direction, any_number, "rad",
              "Where a static study's load is largest, counter-clockwise from the direction of travel; used "
              "with Moment ratio >= 0",
              { used_if(is_static), plausible(-6.2832, 6.2832, "one turn either way") });
  list.path("File", load.file,
            "Fourier coefficients for Source = file: a line \"# ring radius: 0.03 (m)\", then rows n a_n b_n "
            "(N/rad) for n = 0, 1, 2, ...; harmonics.dat of a results folder is such a file");
}

/// An entry of version 0.1, or a value of one, and what to do instead.
struct Renamed
{
  std::string path;
  std::string value; ///< empty: every other one, and the entry itself
  std::string instead;
};

const std::vector<Renamed> all_renamed = {
  { "Table/Kind", "rigid", "write Table/Interface = hard, Table/Substrate = rigid" },
  { "Table/Kind", "mat", "write Table/Interface = Winkler, Table/Substrate = rigid" },
  { "Table/Kind", "rough", "write Table/Interface = rough, Table/Substrate = rigid" },
  { "Table/Kind", "elastic", "write Table/Interface = hard, Table/Substrate = elastic" },
  { "Table/Kind", "",
    "write Table/Interface = hard, Winkler or rough, and Table/Substrate = rigid or elastic" },
  { "Contact/Friction coupling", "automatic", "write Contact/Friction coupling = elastic" },
  { "Load/Coupling", "frozen", "write Load/Coupling = one-way" },
  { "Load/Coupling", "response", "write Load/Coupling = two-way" },
  { "Load/Coupling", "exact", "write Load/Coupling = two-way" },
  { "Load/Response tolerance", "",
    "leave it out: with Load/Coupling = two-way the contact is solved in balance at every spin" },
};

/// Throws BadInput with the words of today for an entry of version 0.1 that has another name now, and for a
/// value of it that has. @p origin begins the sentence; @p value is the text that the entry is given, nothing
/// where the entry alone is asked for.
void refuse_renamed(const std::string &origin, const std::string &path,
                    const std::optional<std::string> &value = {})
{
  const auto is_gone = [&](const Renamed &renamed) { return renamed.path == path && renamed.value.empty(); };
  const bool entry_is_gone = std::any_of(all_renamed.begin(), all_renamed.end(), is_gone);
  for (const Renamed &renamed : all_renamed)
    if (renamed.path == path && (renamed.value.empty() || renamed.value == value))
      throw BadInput(origin + path + (value ? " = " + shortened(*value) : "") + " is " +
                     (entry_is_gone ? "an entry" : "a value") + " of version 0.1; " + renamed.instead + '.');
}

/// The end of a sentence about an entry that does not exist, "; did you mean Glass/Contact radius?" with the
/// likeliest one; @p word may be meant for an entry's path, for its name alone, or for that of another
/// section.
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
  std::optional<std::string> meant = likeliest(word, paths);
  if (const auto likely = likeliest(name, names); likely && !meant)
    meant = paths[static_cast<std::size_t>(std::find(names.begin(), names.end(), *likely) - names.begin())];
  return meant ? "; did you mean " + *meant + "? (`stemware defaults` lists what there is.)"
               : "; `stemware defaults` lists what there is.";
}

} // namespace

std::vector<StudyEntry> study_entries(Study &study)
{
  EntryList list(study);
  add_motion(list, study.motion);
  add_glass(list, study.glass);
  add_table(list, study.table);
  add_contact(list, study.contact);
  add_load(list, study.load);
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

const StudyEntry &entry_at(const std::vector<StudyEntry> &entries, const std::string &origin,
                           const std::string &path)
{
  refuse_renamed(origin, path);
  const auto entry = std::find_if(entries.begin(), entries.end(),
                                  [&](const StudyEntry &candidate) { return candidate.path() == path; });
  require(entry != entries.end(),
          origin + "there is no entry \"" + shortened(path) + '"' + suggestion(entries, path));
  return *entry;
}

void assign(const StudyEntry &entry, const std::string &origin, const std::string &value)
{
  if (entry.assign(value))
    return;
  const std::string trouble = entry.quantity != nullptr ? trouble_with_unit(value, entry.unit) : "";
  throw BadInput(origin + entry.path() + " = " + (value.empty() ? "(nothing)" : shortened(value)) +
                 (trouble.empty() ? " is not allowed; give " + entry.allowed + '.' : trouble));
}

void assign(const std::vector<StudyEntry> &entries, const std::string &origin, const std::string &path,
            const std::string &value)
{
  refuse_renamed(origin, path, value);
  assign(entry_at(entries, origin, path), origin, value);
}

StudyEntry find_entry(const std::string &option, const std::string &path)
{
  return entry_at(entries_of(Study()), option + ": ", path);
}

} // namespace stemware::pipeline
