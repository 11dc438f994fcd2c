#include "fem/revolution/meshed_revolution_foot.h"

#include "fem/revolution/goal_estimate.h"
#include "fem/revolution/meridian_field.h"
#include "fem/revolution/meridian_meshes.h"
#include "fem/revolution/pressure_field.h"
#include "fem/revolution/revolution_output.h"

#include <sstream>

namespace stemware::fem
{

MeshedRevolutionFoot::MeshedRevolutionFoot(const RevolutionSetup &setup, ComplianceCache &cache)
    : RevolutionFoot(setup, compliance_of(setup, MeridianMeshes(setup), setup.meridian_of_zone(), cache))
{
}

MeshedRevolutionFoot::MeshedRevolutionFoot(const RevolutionSetup &setup)
    : MeshedRevolutionFoot(setup, *std::make_unique<ComplianceCache>())
{
}

std::shared_ptr<const Foot> MeshedRevolutionFoot::twin() const
{
  const auto twin = std::make_shared<MeshedRevolutionFoot>(setup, compliance);
  twin->whole_land = whole_land;
  return twin;
}

std::shared_ptr<const ContactCompliance> MeshedRevolutionFoot::of_whole_land() const
{
  if (compliance->n_inside == 0 && compliance->n_outside == 0)
    return compliance;
  std::call_once(whole_land->once,
                 [&]
                 {
                   ComplianceCache cache;
                   whole_land->compliance =
                     compliance_of(setup, MeridianMeshes(setup), setup.meridian, cache);
                 });
  return whole_land->compliance;
}

std::optional<MeshError> MeshedRevolutionFoot::mesh_error(const ContactState &state, const ContactGoal &goal,
                                                          bool with_cells) const
{
  if (!setup.imperfection.empty())
    return std::nullopt;
  const Zone &zone = zone_of(state);
  SolvedContact contact = { setup, zone.body, *interface };
  contact.gap = gap_at({});
  contact.state = &state;
  contact.cache = &finer;
  if (setup.friction_coefficient > 0)
    contact.sliding = sliding_at(state.slip);
  return estimate_mesh_error(contact, goal, with_cells);
}

/// The fields of a body under the forces on a zone of its land, with the meshes that they live on.
struct MeshedRevolutionFoot::Field
{
  Field(const MeshedRevolutionFoot &foot, const Zone &zone)
      : meshes(foot.setup)
      , space(meshes.foot, foot.setup.material, foot.setup.meridian.degree)
      , field(space, foot.setup.material, forces(foot, zone))
  {
  }

  static ForceModes forces(const MeshedRevolutionFoot &foot, const Zone &zone)
  {
    const ContactCompliance &part = zone.body.contact_compliance();
    const ForceModes modes = zone.body.elastic_response().force_modes(zone.body.forces());
    return { part.on_land(modes.normal), part.on_land(modes.radial), part.on_land(modes.azimuthal) };
  }

  const MeridianMeshes meshes;
  const MeridianSpace space;
  const MeridianField field;
};

std::vector<FieldFile> MeshedRevolutionFoot::fields(const ContactState &state) const
{
  const Zone &zone = zone_of(state);
  const Field whole(*this, zone);
  const PressureField pressure(zone.body, *zone.law, state.solution, gap_at(state.slip.orientation));
  std::ostringstream file;
  write_revolution_fields(whole.field, pressure, state.solution.motion, axis(state.slip.orientation), file);
  return { { "contact.vtu", file.str() } };
}

std::vector<StressedPatch> MeshedRevolutionFoot::section(const ContactState &state, double theta) const
{
  return revolution_section(Field(*this, zone_of(state)).field, theta - axis(state.slip.orientation));
}

} // namespace stemware::fem
