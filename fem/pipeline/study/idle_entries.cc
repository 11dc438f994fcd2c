#include "fem/pipeline/study/idle_entries.h"

#include "fem/pipeline/study/study_entries.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace stemware::pipeline
{

namespace
{

/// Entries of one section that have an effect on the same condition.
struct Condition
{
  bool holds;
  std::string section;
  std::vector<std::string> names;
};

/// Whether the moment that the table's pressure carries follows from the balance of moments.
bool has_moment_balance(const Study &study)
{
  return !study.load.is_static() && study.load.source != LoadSource::file;
}

std::vector<Condition> conditions_of_motion(const Study &study)
{
  const bool has_balance = has_moment_balance(study);
  const bool is_full = has_balance && study.motion.closure == ring::Closure::full;
  return { { has_balance, "Motion", { "Closure" } },
           { is_full, "Motion", { "Centre of mass height" } },
           { is_full && study.load.is_from_contact(), "Motion", { "Tilt" } },
           { study.motion.orbit.friction_law == ring::FrictionLawKind::stribeck,
             "Motion",
             { "Static friction coefficient", "Friction decay speed", "Viscous friction" } },
           { has_balance && study.load.is_from_contact(), "Load", { "Coupling" } },
           { study.load.is_static(), "Load", { "Moment direction" } } };
}

std::vector<Condition> conditions_of_shape(const Study &study)
{
  const bool is_generated = study.contact.mesh_file.empty();
  const fem::GlassShape shape = study.glass.profile.shape;
  const bool is_drawn = shape == fem::GlassShape::profile;
  return { { is_generated, "Glass", { "Shape", "Land width" } },
           { is_generated && is_drawn, "Glass", { "Profile file" } },
           { is_generated && !is_drawn,
             "Glass",
             { "Foot radius", "Foot thickness", "Land height", "Stem radius", "Stem height" } },
           { is_generated && shape == fem::GlassShape::foot,
             "Glass",
             { "Underside rise", "Edge thickness", "Fillet radius" } } };
}

std::vector<Condition> conditions_of_table(const TableSection &table)
{
  return {
    { table.interface == TableInterface::winkler, "Table", { "Foundation modulus", "Layer thickness" } },
    { table.interface == TableInterface::rough, "Table", { "Reference pressure", "Decay length" } },
    { table.substrate == TableSubstrate::elastic,
      "Table",
      { "Disc radius", "Disc thickness", "Disc Young modulus", "Disc Poisson ratio" } }
  };
}

std::vector<Condition> conditions_of_body(const Study &study)
{
  const bool is_of_revolution = abilities(study.contact.body).is_of_revolution;
  const bool is_generated = study.contact.mesh_file.empty();
  return { { is_generated, "Contact", { "Radial cells" } },
           { is_generated && !is_of_revolution, "Contact", { "Azimuthal cells", "Foot layers" } },
           { !is_of_revolution, "Contact", { "Linear solver" } },
           { !is_generated, "Contact", { "Mesh contact id", "Mesh stem id", "Mesh contact height" } },
           { is_of_revolution, "Contact", { "Harmonics", "Azimuth lines" } },
           { is_of_revolution && study.glass.profile.crown_radius > 0, "Contact", { "Land grading" } } };
}

/// Without a contact only the radius of the rim is left of glass, table and body.
bool belongs_to_contact(const std::string &path)
{
  const std::string section = path.substr(0, path.find('/'));
  return (section == "Glass" || section == "Table" || section == "Contact") && path != "Glass/Contact radius";
}

} // namespace

std::vector<std::string> idle_entries(const Study &study)
{
  std::set<std::string> idle;
  const auto add = [&](const std::vector<Condition> &conditions)
  {
    for (const Condition &condition : conditions)
      for (const std::string &name : condition.names)
        if (!condition.holds)
          idle.insert(condition.section + '/' + name);
  };
  add(conditions_of_motion(study));
  add(conditions_of_shape(study));
  add(conditions_of_table(study.table));
  add(conditions_of_body(study));

  std::vector<std::string> found;
  Study copy = study;
  for (const StudyEntry &entry : study_entries(copy))
    if (const std::string path = entry.path(); study.given_entries.count(path) > 0)
      if (idle.count(path) > 0 || (!study.load.is_from_contact() && belongs_to_contact(path)))
        found.push_back(path);
  return found;
}

std::string idle_note(const std::vector<std::string> &entries)
{
  return entries.empty() ? ""
                         : fmt::format(FMT_STRING("{} {} no effect in this study."), fmt::join(entries, ", "),
                                       entries.size() == 1 ? "has" : "have");
}

} // namespace stemware::pipeline
