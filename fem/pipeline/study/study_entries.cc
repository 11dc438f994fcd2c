#include "fem/pipeline/study/study_entries.h"

#include "fem/pipeline/support/number_text.h"

#include <limits>
#include <optional>

namespace stemware::pipeline
{

namespace
{

/// Numbers that an entry takes, with the words for it.
struct Range
{
  std::string words;
  std::function<bool(double)> contains;
};

const Range any_number = { "a finite number", [](double) { return true; } };
const Range positive = { "a number greater than 0", [](double value) { return value > 0; } };
const Range not_negative = { "a number not less than 0", [](double value) { return value >= 0; } };

Range between(double lower, double upper)
{
  return { "a number greater than " + to_text(lower) + " and less than " + to_text(upper),
           [=](double value) { return lower < value && value < upper; } };
}

const Range not_tipping = { "a number less than 2, where the foot tips",
                            [](double value) { return value < 2; } };

/// Collects the entries of one subsection after the other.
class EntryList
{
public:
  void enter(const std::string &name) { section = name; }

  /// A quantity; @p unit is empty for pure numbers.
  void add(const std::string &name, double &value, const Range &range, const std::string &unit,
           const std::string &help)
  {
    const auto parse = [range](const std::string &text)
    {
      const auto number = parse_number(text);
      return number && range.contains(*number) ? number : std::nullopt;
    };
    append(name, value, range.words + (unit.empty() ? "" : " (" + unit + ")"), help, parse, to_text);
    if (!unit.empty())
      entries.back().unit = unit;
  }

  /// A number of things, from @p least to @p most.
  void add(const std::string &name, unsigned int &value, unsigned int least, unsigned int most,
           const std::string &help)
  {
    const auto parse = [=](const std::string &text)
    {
      const auto count = parse_count(text);
      return count && least <= *count && *count <= most ? count : std::nullopt;
    };
    const auto print = [](unsigned int count) { return std::to_string(count); };
    append(name, value, "a whole number from " + std::to_string(least) + " to " + std::to_string(most), help,
           parse, print);
  }

  void add(const std::string &name, std::string &value, const std::string &help)
  {
    const auto parse = [](const std::string &text)
    { return text.find_first_of("\n\r#") == std::string::npos ? std::optional(text) : std::nullopt; };
    append(name, value, "a path without # and line ends, or nothing", help, parse,
           [](const std::string &text) { return text; });
  }

  void add(const std::string &name, Waviness &value, const std::string &help)
  {
    append(name, value, waviness_words, help, parse_waviness, waviness_text);
  }

  /// One of several named values.
  template <typename Choice>
  void add(const std::string &name, Choice &value, const std::vector<std::pair<std::string, Choice>> &choices,
           const std::string &help)
  {
    const auto parse = [choices](const std::string &text)
    {
      std::optional<Choice> found;
      for (const auto &[word, choice] : choices)
        if (word == text)
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
    std::string words = "one of";
    for (const auto &[word, choice] : choices)
      words += (word == choices.front().first ? " " : word == choices.back().first ? " or " : ", ") + word;
    append(name, value, words, help, parse, print);
  }

  std::vector<StudyEntry> entries;

private:
  template <typename Value, typename Parse, typename Print>
  void append(const std::string &name, Value &value, const std::string &allowed, const std::string &help,
              const Parse &parse, const Print &print)
  {
    StudyEntry entry;
    entry.section = section;
    entry.name = name;
    entry.allowed = allowed;
    entry.help = help;
    entry.unit = std::is_arithmetic_v<Value> ? "1" : "";
    entry.is_quantity = std::is_floating_point_v<Value>;
    entry.text = [&value, print] { return print(value); };
    if constexpr (std::is_arithmetic_v<Value>)
      entry.json = [&value] { return nlohmann::ordered_json(value); };
    else
      entry.json = [&value, print] { return nlohmann::ordered_json(print(value)); };
    entry.is_allowed = [parse](const std::string &text) { return parse(text).has_value(); };
    entry.assign = [&value, parse](const std::string &text) { value = parse(text).value(); };
    entries.push_back(entry);
  }

  std::string section;
};

void add_motion(EntryList &list, MotionSection &motion)
{
  using ring::Closure;
  using ring::OrbitSense;
  list.enter("Motion");
  list.add("Mass", motion.orbit.mass, positive, "kg", "Mass of the glass with what is in it");
  list.add(
    "Yaw inertia", motion.orbit.yaw_inertia, positive, "kg m^2",
    "Moment of inertia about the axis of the glass; sets how fast the spin builds up, not where it ends");
  list.add("Centre of mass height", motion.orbit.centre_of_mass_height, not_negative, "m",
           "Height of the centre of mass above the table; used by the closure full");
  list.add("Force offset", motion.orbit.force_offset, any_number, "m",
           "Height of the hand's force minus that of the centre of mass, negative when the hand is below it");
  list.add("Orbit radius", motion.orbit.orbit_radius, positive, "m",
           "Radius of the circle on which the glass is led");
  list.add("Orbit speed", motion.orbit.orbit_speed, positive, "m/s", "Speed along that circle");
  list.add("Orbit sense", motion.orbit.orbit_sense,
           { { "counterclockwise", OrbitSense::counterclockwise }, { "clockwise", OrbitSense::clockwise } },
           "Which way round, seen from above: counterclockwise or clockwise");
  list.add("Friction coefficient", motion.orbit.friction_coefficient, positive, "",
           "Coulomb friction between foot and table");
  list.add("Gravity", motion.orbit.gravity, positive, "m/s^2", "Acceleration of free fall");
  list.add(
    "Closure", motion.closure,
    { { "paper", Closure::paper }, { "hand", Closure::hand }, { "full", Closure::full } },
    "Which moments the table's pressure has to balance. paper: the centripetal part of the hand's force "
    "only; "
    "hand: the whole force of the hand; full: also the moment of the friction about the centre of mass");
  list.add("End time", motion.end_time, positive, "s", "How long the spin-up is followed");
  list.add("Euler step", motion.euler_step, positive, "s",
           "Largest step of the forward Euler method that is shown beside the adaptive one");
}

void add_glass(EntryList &list, GlassSection &glass)
{
  using fem::GlassShape;
  fem::GlassProfile &profile = glass.profile;
  list.enter("Glass");
  list.add("Shape", profile.shape, { { "step", GlassShape::step }, { "foot", GlassShape::foot } },
           "Section of the glass near the table. step: a plate on a ring (the land) under a cylinder (the "
           "stem); foot: the foot of a wine glass, concave below, tapering to its edge, rounded into the "
           "stem");
  list.add("Contact radius", profile.contact_radius, positive, "m",
           "Radius R of the rim that stands on the table");
  list.add("Foot radius", profile.foot_radius, positive, "m", "Outer radius of the foot");
  list.add("Foot thickness", profile.foot_thickness, positive, "m",
           "Thickness of a step above the land, of a foot where its top meets the stem");
  list.add("Land width", profile.land_width, positive, "m",
           "Width of the zone that may touch the table, half of it on either side of the contact radius");
  list.add("Land height", profile.land_height, positive, "m",
           "How far the land stands out below a step, or below the outer edge of a foot");
  list.add("Crown radius", profile.crown_radius, not_negative, "m",
           "Radius of the rim's rounding, seen in a cut through the axis; 0 means a flat land");
  list.add("Underside rise", profile.underside_rise, not_negative, "m",
           "Height of the underside of a foot on the axis, above the land; without effect on a step");
  list.add("Edge thickness", profile.edge_thickness, positive, "m",
           "Thickness of a foot at its outer edge; without effect on a step");
  list.add("Fillet radius", profile.fillet_radius, not_negative, "m",
           "Radius of the rounding between the top of a foot and the stem, 0 for a sharp corner; without "
           "effect on a step");
  list.add("Stem radius", profile.stem_radius, positive, "m", "Radius of the stem");
  list.add("Stem height", profile.stem_height, positive, "m",
           "From the top of the foot, where it meets the stem, to the cut through the stem");
  list.add("Young modulus", glass.material.young_modulus, positive, "Pa", "Young's modulus of the glass");
  list.add("Poisson ratio", glass.material.poisson_ratio, between(-1, 0.5), "",
           "Poisson's ratio of the glass");
  list.add(
    "Rim waviness", glass.waviness,
    "How the rim is out of flat: harmonics of its height above the table, fixed to the glass and positive "
    "where it is higher. At the start azimuth 0 points away from the orbit's centre. Body of revolution "
    "only");
}

void add_table(EntryList &list, TableSection &table)
{
  list.enter("Table");
  list.add(
    "Kind", table.kind,
    { { "rigid", TableKind::rigid },
      { "mat", TableKind::mat },
      { "rough", TableKind::rough },
      { "elastic", TableKind::elastic } },
    "rigid: a hard plane; mat: a thin elastic layer on it; rough: a hard plane with asperities, pressure "
    "exponential in the distance; elastic: a thick disc of a material of its own (body of revolution "
    "only)");
  list.add("Foundation modulus", table.foundation_modulus, positive, "Pa/m",
           "Pressure of the mat per depth of penetration");
  list.add("Reference pressure", table.roughness.reference_pressure, positive, "Pa",
           "Pressure of a rough table where the mean planes of the two surfaces touch");
  list.add("Decay length", table.roughness.decay_length, positive, "m",
           "Distance over which a rough table's pressure falls by e, about its rms roughness");
  list.add("Disc radius", table.disc.radius, positive, "m", "Radius of an elastic table");
  list.add("Disc thickness", table.disc.thickness, positive, "m",
           "Thickness of an elastic table, which is held at its bottom");
  list.add("Disc Young modulus", table.disc_material.young_modulus, positive, "Pa",
           "Young's modulus of an elastic table (hardwood 10e9)");
  list.add("Disc Poisson ratio", table.disc_material.poisson_ratio, between(-1, 0.5), "",
           "Poisson's ratio of an elastic table");
  list.add(
    "Waviness", table.waviness,
    "How the table is out of flat: harmonics of its depth, fixed to the ground and positive where it is "
    "lower. At the start azimuth 0 points away from the orbit's centre. Body of revolution only");
}

void add_contact(EntryList &list, ContactSection &contact)
{
  using fem::LinearSolver;
  list.enter("Contact");
  list.add("Body", contact.body, { { "solid", BodyKind::solid }, { "revolution", BodyKind::revolution } },
           "revolution: displacement harmonics on a meridional mesh, for feet that are bodies of revolution: "
           "fast, and the way to friction coupling and elastic tables; solid: the foot in three-dimensional "
           "finite elements, for any mesh");
  list.add("Mesh file", contact.mesh_file,
           "Mesh of the foot (.msh, hexahedra, physical ids 1 = stem cut, 2 = contact zone), which then also "
           "gives its shape; "
           "empty: generated from the subsection Glass. A relative path starts at the study file");
  list.add("Degree", contact.degree, 1, 4,
           "Polynomial degree of the elements: 1 or 2 for a solid body, 1 to 4 for a body of revolution");
  list.add("Azimuthal cells", contact.resolution.azimuthal_cells, 8, 2000,
           "Cells round the rim of a generated mesh, a multiple of 4");
  list.add("Radial cells", contact.resolution.radial_cells, 2, 200,
           "Cells across the land of a generated mesh, an even number");
  list.add("Foot layers", contact.resolution.foot_layers, 1, 100,
           "Cells through the thickness of the foot of a generated mesh");
  list.add("Refinements", contact.refinements, 0, 6,
           "Halvings of every cell of a body of revolution; without effect on a solid body");
  list.add(
    "Land grading", contact.land_grading,
    { "a number from 1 to 10", [](double value) { return 1 <= value && value <= 10; } }, "",
    "Size of a cell of the land over that of its neighbour nearer to the contact radius, for a crowned "
    "body of revolution; 1 means equal cells");
  list.add("Linear solver", contact.linear_solver,
           { { "automatic", LinearSolver::automatic },
             { "direct", LinearSolver::direct },
             { "multigrid", LinearSolver::multigrid } },
           "automatic: direct for small systems, multigrid for large ones");
  list.add("Harmonics", contact.harmonics, 1, 1000,
           "Elastic harmonics of a body of revolution; without effect on a solid body");
  list.add(
    "Azimuth lines", contact.azimuth_lines, 16, 100000,
    "Azimuths at which a body of revolution meets a mat or a rough table, more than twice the harmonics; "
    "without effect on a solid body");
  list.add(
    "Friction coupling", contact.friction_coupling,
    { { "automatic", FrictionCoupling::automatic },
      { "none", FrictionCoupling::none },
      { "elastic", FrictionCoupling::elastic } },
    "none: friction does not act back on the pressure; elastic: its tractions deform the foot (body of "
    "revolution only); automatic: elastic for a body of revolution on a rigid or elastic table, where "
    "friction "
    "decides the second harmonic, else none");
}

void add_load(EntryList &list, LoadSection &load)
{
  list.enter("Load");
  list.add("Source", load.source,
           { { "contact", LoadSource::contact },
             { "first harmonic", LoadSource::first_harmonic },
             { "file", LoadSource::file } },
           "contact: the finite-element contact; first harmonic: the paper's ansatz, in balance with the "
           "closure at every spin; "
           "file: Fourier coefficients from a file");
  list.add("Coupling", load.coupling,
           { { "frozen", LoadCoupling::frozen },
             { "response", LoadCoupling::response },
             { "exact", LoadCoupling::exact } },
           "frozen: the load of the glass that does not spin yet, at every spin; exact: a contact in balance "
           "with the friction at every spin; response: the same from a curve of contact solutions over the "
           "moment ratio (body of revolution, no friction coupling)");
  list.add("Response tolerance", load.response_tolerance, positive, "",
           "How far such a curve may miss a contact solution, over a_0; used with Coupling = response");
  list.add("Moment ratio", load.moment_ratio, not_tipping, "",
           "Moment of the table's pressure over N R / 2 for a static study; negative: the closure's moment. "
           "The foot tips at 2");
  list.add("Moment direction", load.moment_direction, any_number, "rad",
           "Where a static study's load is largest, counter-clockwise from the direction of travel; used "
           "with Moment ratio >= 0");
  list.add("File", load.file,
           "Fourier coefficients for Source = file: a line \"# ring radius: 0.03 (m)\", then rows n a_n b_n "
           "(N/rad) for n = 0, 1, 2, ...; "
           "harmonics.dat of a results folder is such a file");
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
  return list.entries;
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
