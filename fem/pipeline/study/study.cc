#include "fem/pipeline/study/study.h"

#include "fem/contact/hard_interface.h"
#include "fem/contact/rough_interface.h"
#include "fem/contact/winkler_interface.h"
#include "fem/pipeline/base/failures.h"
#include "fem/pipeline/base/numbers.h"
#include "ring_model/failures.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace stemware::pipeline
{

namespace
{

std::shared_ptr<const fem::InterfaceLaw> make_interface(const TableSection &table)
{
  switch (table.interface)
  {
  case TableInterface::hard:
    return std::make_shared<fem::HardInterface>();
  case TableInterface::winkler:
    return std::make_shared<fem::WinklerInterface>(table.foundation_modulus);
  case TableInterface::rough:
    return std::make_shared<fem::RoughInterface>(table.roughness);
  }
  throw std::logic_error("a table without an interface");
}

/// Returns true for a hard interface on a rigid table, or on a substrate with at least 1/100 of the foot's
/// Young's modulus. On such a table, friction bends the foot, which may change the pressure enough to cancel
/// the effect of the harmonics on the spin. A substrate with 1/1000 of the modulus follows the bent foot.
bool has_stiff_contact(const TableSection &table, const fem::ElasticMaterial &glass)
{
  return table.is_hard() && (table.substrate == TableSubstrate::rigid ||
                             table.disc_material.young_modulus >= glass.young_modulus / 100);
}

} // namespace

fem::Table TableSection::make() const
{
  fem::Table table = { make_interface(*this), {} };
  if (substrate == TableSubstrate::elastic)
    table.substrate = fem::Substrate{ disc, disc_material };
  return table;
}

bool TableSection::is_hard() const
{
  return make().interface->is_hard();
}

bool Study::depends_on_spin() const
{
  return ring::friction_arm(motion.closure, motion.orbit) != 0 || friction_deforms();
}

unsigned int Study::edge_halvings() const
{
  if (!contact.mesh_file.empty())
    return 0;
  const unsigned int wanted = fem::edge_halvings_for(glass.profile, table.is_hard());
  return contact.goal != Goal::none ? std::min(wanted, 2u) : wanted;
}

bool Study::tilts() const
{
  return motion.tilt && motion.closure == ring::Closure::full && load.is_from_contact() && !load.is_static();
}

fem::Resultants Study::required_resultants() const
{
  const double radius = glass.profile.contact_radius;
  fem::Resultants required;
  required.normal_force = motion.orbit.normal_force();
  if (load.is_static())
  {
    // Moment (sum y f, -sum x f) of a load f with its maximum at the azimuth moment_direction.
    const double moment = load.moment_ratio * required.normal_force * radius / 2;
    required.moment_x = moment * std::sin(load.moment_direction);
    required.moment_y = -moment * std::cos(load.moment_direction);
  }
  else
  {
    const Eigen::Vector2d moment = ring::required_moment_at_rest(motion.closure, motion.orbit);
    required.moment_x = moment.x();
    required.moment_y = moment.y();
  }
  const double ratio = pipeline::moment_ratio(required, radius), limit = tipping_ratio();
  if (ratio < limit)
    return required;
  const double unit = required.normal_force * radius / 2;
  const auto [asked, most] =
    load.is_static() ? distinct_texts(ratio, limit) : distinct_texts(ratio * unit, limit * unit);
  throw ring::Tipping(
    load.is_static()
      ? "Load/Moment ratio = " + asked + " is not allowed: the glass tips at " + most + "; give less."
      : "The glass would tip: the hand needs a moment of " + asked + " N m, the weight can give " + most +
          " N m. Hold it nearer to the centre of mass, go slower or on a larger circle.");
}

double Study::tipping_ratio() const
{
  if (load.is_from_contact() && !contact.mesh_file.empty())
    return std::numeric_limits<double>::infinity();
  const bool is_flat = load.is_from_contact() && glass.profile.crown_radius == 0;
  return is_flat ? 2 * glass.profile.land_outer_radius() / glass.profile.contact_radius : 2;
}

double Study::spin_scale() const
{
  const double unit = spin_unit();
  if (load.source == LoadSource::file)
    return unit;
  try
  {
    const fem::Resultants required = required_resultants();
    const double share = std::abs(required.moment_x) / (required.normal_force * glass.profile.contact_radius);
    return share < 1e-12 ? unit : unit * std::clamp(2 * share, 1e-6, 1.);
  }
  catch (const ring::Tipping &) // in some models of the budget, the glass tips at rest
  {
    return unit;
  }
}

double moment_ratio(const fem::Resultants &load, double contact_radius)
{
  return std::hypot(load.moment_x, load.moment_y) / (load.normal_force * contact_radius / 2);
}

std::string Study::friction_note() const
{
  const bool is_stiff = has_stiff_contact(table, glass.material);
  if (friction_deforms())
    return std::string("deforms the foot") + (table.make().substrate ? " and the table" : "") +
           (is_stiff ? ": with a hard interface on so stiff a table it may decide the second harmonic" : "");
  return std::string("does not deform the foot") +
         (is_stiff ? "; with a hard interface on so stiff a table it might decide the second harmonic" : "");
}

std::string Study::frozen_note() const
{
  return load.coupling == LoadCoupling::one_way && !load.is_static() && depends_on_spin()
           ? "the load at rest is used at every spin; Load/Coupling = two-way computes it at each spin"
           : "";
}

} // namespace stemware::pipeline
