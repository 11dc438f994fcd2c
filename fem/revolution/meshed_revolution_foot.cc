#include "fem/revolution/meshed_revolution_foot.h"

#include "fem/revolution/meridian_field.h"
#include "fem/revolution/meridian_meshes.h"
#include "fem/revolution/revolution_output.h"

#include <algorithm>
#include <cmath>

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

std::shared_ptr<const Foot> MeshedRevolutionFoot::clone() const
{
  return std::make_shared<MeshedRevolutionFoot>(*this);
}

std::shared_ptr<const ContactCompliance> MeshedRevolutionFoot::whole_land_compliance() const
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

struct MeshedRevolutionFoot::Meridian
{
  explicit Meridian(const RevolutionSetup &setup)
      : meshes(setup)
      , space(meshes.foot, setup.material, setup.meridian.degree)
  {
  }

  const MeridianMeshes meshes;
  const MeridianSpace space;
};

const MeshedRevolutionFoot::Meridian &MeshedRevolutionFoot::meridian() const
{
  if (!made_meridian)
    made_meridian = std::make_shared<const Meridian>(setup);
  return *made_meridian;
}

MeridianField MeshedRevolutionFoot::field(const ContactState &state) const
{
  const Zone &zone = zone_of(state);
  const ContactCompliance &part = zone.body.contact_compliance();
  const ForceModes modes = zone.body.elastic_response().force_modes(zone.body.forces());
  // Each harmonic costs one factorisation, so negligible harmonics are omitted: the highest harmonic is one
  // above the last load harmonic of at least 1e-4 of the mean load. Harmonic n of the load causes friction of
  // the harmonics n - 1 and n + 1.
  const auto load = [&](Eigen::Index mode)
  { return std::abs(modes.normal.col(mode).sum()) / FourierBasis::norm(static_cast<unsigned int>(mode)); };
  Eigen::Index n_modes = modes.normal.cols();
  while (n_modes > 5 && std::max(load(n_modes - 3), load(n_modes - 4)) < 1e-4 * load(0))
    n_modes -= 2;
  const auto kept = [&](const Eigen::MatrixXd &forces) -> Eigen::MatrixXd
  { return part.extended_to_land(forces.leftCols(std::min(n_modes, forces.cols()))); };
  return { meridian().space,
           setup.material,
           { kept(modes.normal), kept(modes.radial), kept(modes.azimuthal) } };
}

std::vector<FieldFile> MeshedRevolutionFoot::fields(const ContactState &state) const
{
  const Zone &zone = zone_of(state);
  const ring::Orientation &marks = state.slip.orientation;
  return { { "contact.vtu", revolution_fields(field(state), zone.body, *zone.law, state.solution,
                                              gap_at(marks), axis(marks)) } };
}

std::vector<StressedPatch> MeshedRevolutionFoot::section(const ContactState &state, double theta) const
{
  return revolution_section(field(state), theta - axis(state.slip.orientation));
}

} // namespace stemware::fem
