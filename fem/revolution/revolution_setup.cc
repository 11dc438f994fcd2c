#include "fem/revolution/revolution_setup.h"

#include "fem/contact/stiff_spring.h"
#include "ring_model/load/constants.h"

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_2.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace stemware::fem
{

namespace
{

/// Returns (1 - nu^2) / E [1/Pa].
double plane_strain_compliance_of(const ElasticMaterial &material)
{
  return (1 - material.poisson_ratio * material.poisson_ratio) / material.young_modulus;
}

/// A rigid foot uses the mesh of the elastic foot if the elasticity of the foot multiplies the compliance of
/// foot and substrate by less than this factor.
constexpr double most_added_by_foot = 1.2;

} // namespace

double RevolutionSetup::plane_strain_compliance() const
{
  double compliance = foot_is_rigid ? 0 : plane_strain_compliance_of(material);
  if (table.substrate)
    compliance += plane_strain_compliance_of(table.substrate->material);
  return compliance;
}

ContactCompliance RevolutionSetup::total_compliance(const ContactCompliance &foot,
                                                    const ContactCompliance *disc) const
{
  ContactCompliance sum = foot_is_rigid ? foot.scaled(0) : friction_in_foot ? foot : foot.without_friction();
  if (disc)
    sum += friction_in_substrate ? *disc : disc->without_friction();
  return sum;
}

MeridianOptions RevolutionSetup::meridian_of_zone() const
{
  const double reach = zone_half_width();
  MeridianOptions options = meridian;
  if (reach > 0)
  {
    options.inner_radius = profile.contact_radius - reach;
    options.outer_radius = profile.contact_radius + reach;
  }
  return options;
}

double RevolutionSetup::line_load(double normal_force) const
{
  return normal_force / (2 * ring::pi * profile.contact_radius);
}

std::shared_ptr<const InterfaceLaw> RevolutionSetup::interface() const
{
  if (!table.interface->is_hard())
    return table.interface;
  const double width =
    profile.crown_radius > 0 && contact_half_width > 0 ? contact_half_width : profile.land_width;
  double compliance = foot_is_rigid ? 0 : plane_strain_compliance_of(material) * width;
  if (table.substrate)
  {
    const ElasticMaterial &below = table.substrate->material;
    compliance +=
      std::min(plane_strain_compliance_of(below) * width,
               table.substrate->disc.thickness / (below.lame_lambda() + 2 * below.shear_modulus()));
  }
  if (compliance == 0)
    throw std::invalid_argument("A rigid foot on a hard, rigid table has no defined pressure; make foot, "
                                "interface or substrate compliant.");
  return make_stiff_spring(hardness / compliance);
}

double hertz_half_width(const RevolutionSetup &setup, double normal_force)
{
  return std::sqrt(4 * setup.line_load(normal_force) * setup.profile.crown_radius *
                   setup.plane_strain_compliance() / ring::pi);
}

double crest_half_width(const RevolutionSetup &setup, double normal_force)
{
  const RimImperfection &waviness = setup.imperfection;
  double sum = 0;
  for (const auto *harmonics : { &waviness.glass, &waviness.table })
    for (const WavinessHarmonic &harmonic : *harmonics)
      sum += std::pow(harmonic.amplitude * harmonic.n * harmonic.n, 2);
  if (sum == 0)
    return 0;
  const double across = setup.profile.crown_radius;
  const double along = std::max(across, std::pow(setup.profile.contact_radius, 2) / std::sqrt(sum));
  double slenderness = std::pow(along / across, 2. / 3), second = 0;
  for (unsigned int i = 0; i < 50; ++i)
  {
    const double modulus = std::sqrt((1 - 1 / slenderness) * (1 + 1 / slenderness));
    const double first = boost::math::ellint_1(modulus);
    second = boost::math::ellint_2(modulus);
    slenderness = std::sqrt((along / across * (first - second) + first) / second);
  }
  // Hertzian half-width under a third of the normal force, because the foot stands on at least three crests.
  return std::cbrt(normal_force * second * setup.plane_strain_compliance() /
                   (ring::pi * slenderness * (1 / across + 1 / along)));
}

double expected_half_width(const RevolutionSetup &setup, double normal_force)
{
  if (setup.profile.crown_radius == 0)
    return 0;
  double of_bodies = hertz_half_width(setup, normal_force);
  // A foot that is stiff in bending stands on crests only, a soft foot on the whole rim. The bending
  // stiffness is unknown here, so the geometric mean of both half-widths is used.
  if (setup.table.interface->is_hard())
    of_bodies = std::sqrt(of_bodies * std::max(of_bodies, crest_half_width(setup, normal_force)));
  if (setup.table.substrate)
  {
    // A layer thinner than the contact width acts as independent springs of modulus E / thickness.
    const WinklerInterface layer(setup.table.substrate->material.young_modulus /
                                 setup.table.substrate->disc.thickness);
    of_bodies =
      std::min(of_bodies, layer.half_width(setup.line_load(normal_force), setup.profile.crown_radius));
  }
  const double of_interface =
    setup.table.interface->half_width(setup.line_load(normal_force), setup.profile.crown_radius);
  return std::min(std::max(of_bodies, of_interface), setup.profile.land_width / 2);
}

RevolutionSetup RevolutionSetup::resolved_for(double normal_force) const
{
  RevolutionSetup resolved = *this;
  resolved.normal_force = normal_force;
  // On a substrate much more compliant than the foot, a rigid foot uses the mesh of the elastic foot, so that
  // the results differ only by the model.
  RevolutionSetup as_elastic = *this;
  as_elastic.foot_is_rigid = false;
  const bool is_meshed_as_elastic =
    as_elastic.plane_strain_compliance() < most_added_by_foot * plane_strain_compliance();
  resolved.contact_half_width = expected_half_width(is_meshed_as_elastic ? as_elastic : *this, normal_force);
  const bool flat = profile.crown_radius == 0;
  if (flat)
    resolved.resolution.land_grading = 1;
  if (flat && table.interface->is_hard())
  {
    // The foot bends, so the pressure concentrates at the inner edge of the land.
    resolved.resolution.focus_radius = profile.land_inner_radius();
    resolved.resolution.focus_size = profile.land_width / resolution.land_cells / 32 / fineness;
    // The concentration depends on the tilt of the land. Coarse cells at re-entrant corners of the section
    // would dominate the error of this tilt.
    resolved.corner_halvings = 2;
    return resolved;
  }
  // If the interface is a thousand times more compliant than the bodies, the displacement of the bodies is
  // smooth within the contact, and only their overall compliance must be resolved.
  const double depth = flat ? 0 : std::pow(resolved.contact_half_width, 2) / (2 * profile.crown_radius);
  if (flat || line_load(normal_force) * plane_strain_compliance() < 1e-3 * depth)
  {
    const double halvings = std::round(resolution.refinements + 1 + std::log2(fineness));
    resolved.resolution.refinements = static_cast<unsigned int>(std::max(halvings, 0.));
    return resolved;
  }
  double size = resolved.contact_half_width / 6;
  if (table.substrate)
    size = std::min(size, table.substrate->disc.thickness / 3);
  resolved.resolution.focus_size = size / fineness;
  resolved.resolution.focus_width = 1.5 * resolved.contact_half_width;
  resolved.resolution.focus_growth = 1 + (resolution.focus_growth - 1) / std::sqrt(fineness);
  return resolved;
}

} // namespace stemware::fem
