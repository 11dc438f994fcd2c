#include "fem/revolution/revolution_foot.h"

#include "fem/revolution/compliance_cache.h"
#include "fem/revolution/revolution_output.h"

#include <deal.II/grid/tria.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace stemware::fem
{

namespace
{

std::shared_ptr<const ContactCompliance> compliance_of(const RevolutionSetup &setup, ComplianceCache &cache)
{
  dealii::Triangulation<2> foot;
  make_meridian_mesh(setup.profile, setup.resolution, foot);
  const auto compliance = cache.get(foot, setup.material, setup.meridian);
  if (!setup.table.substrate)
    return compliance;
  dealii::Triangulation<2> disc;
  make_meridian_mesh(setup.table.substrate->disc, setup.profile, setup.resolution, disc);
  const auto of_both = std::make_shared<ContactCompliance>(*compliance);
  *of_both += *cache.get(disc, setup.table.substrate->material, setup.meridian);
  return of_both;
}

/// Complementarity node by node has a unique answer only if every node has a degree of freedom: as many lines
/// as modes.
unsigned int lines_of(const RevolutionSetup &setup)
{
  return setup.table.interface->is_hard() ? 2 * setup.meridian.n_harmonics + 1 : setup.n_lines;
}

ContactControl control_of(const RevolutionSetup &setup)
{
  ContactControl control;
  control.tolerance = 1e-10; // one Newton step less on most of a path of neighbouring loads
  if (setup.table.interface->is_hard())
    control.max_steps = 400; // augmented-Lagrangian updates take steps too
  return control;
}

} // namespace

double hertz_half_width(const RevolutionSetup &setup, double normal_force)
{
  const auto plane_strain_compliance = [](const ElasticMaterial &material)
  { return (1 - material.poisson_ratio * material.poisson_ratio) / material.young_modulus; };
  double compliance = plane_strain_compliance(setup.material);
  if (setup.table.substrate)
    compliance += plane_strain_compliance(setup.table.substrate->material);
  const double line_load =
    normal_force / (2 * boost::math::double_constants::pi * setup.profile.contact_radius);
  return std::sqrt(4 * line_load * setup.profile.crown_radius * compliance /
                   boost::math::double_constants::pi);
}

RevolutionSetup RevolutionSetup::resolved_for(double normal_force) const
{
  RevolutionSetup resolved = *this;
  const bool flat = profile.crown_radius == 0;
  if (flat)
    resolved.resolution.land_grading = 1;
  if (!table.interface->is_hard())
    return resolved;
  if (flat)
  {
    // The foot bends, so the load gathers at the inner edge of the land.
    resolved.resolution.focus_radius = profile.land_inner_radius();
    resolved.resolution.focus_size = profile.land_width / resolution.land_cells / 32;
    return resolved;
  }
  const double half_width = hertz_half_width(*this, normal_force);
  resolved.resolution.focus_size = half_width / 2;
  resolved.resolution.focus_width = 1.5 * half_width;
  return resolved;
}

RevolutionFoot::RevolutionFoot(const RevolutionSetup &setup, ComplianceCache &cache)
    : setup(setup)
    , compliance(compliance_of(setup, cache))
    , body(
        *compliance, [this](double r, double theta) { return gap(r, theta); }, lines_of(setup))
    , law(make_law())
{
  setup.imperfection.validate();
}

RevolutionFoot::RevolutionFoot(const RevolutionSetup &setup)
    : RevolutionFoot(setup, *std::make_unique<ComplianceCache>())
{
}

double RevolutionFoot::gap(double radius, double azimuth) const
{
  return setup.profile.gap(radius) +
         setup.imperfection.gap(radius / setup.profile.contact_radius, azimuth, phase);
}

std::unique_ptr<TableLaw> RevolutionFoot::make_law() const
{
  double modulus = setup.material.young_modulus;
  if (setup.table.substrate)
    modulus = std::min(modulus, setup.table.substrate->material.young_modulus);
  const Eigen::Index n_steps = compliance->radii.size() - 1;
  const double smallest = (compliance->radii.tail(n_steps) - compliance->radii.head(n_steps)).minCoeff();
  return setup.table.interface->make(body.contact_surface(), 5 * modulus / smallest);
}

bool RevolutionFoot::is_isotropic() const
{
  return setup.imperfection.empty() && setup.friction_coefficient == 0;
}

FootDescription RevolutionFoot::description() const
{
  FootDescription description;
  description.body = "revolution";
  description.n_unknowns = body.n_unknowns();
  description.n_contact_nodes = body.contact_surface().n_nodes();
  return description;
}

FootCapabilities RevolutionFoot::capabilities() const
{
  FootCapabilities capabilities;
  capabilities.is_isotropic = is_isotropic();
  capabilities.friction_deforms = setup.friction_coefficient > 0;
  return capabilities;
}

void RevolutionFoot::set_orientation(const FootOrientation &orientation)
{
  if (setup.imperfection.empty())
    return;
  phase = orientation;
  body.set_gap([this](double r, double theta) { return gap(r, theta); });
}

ContactSolution RevolutionFoot::solve_from_before(const Resultants &load)
{
  const double radius = setup.profile.contact_radius;
  const ContactControl control = control_of(setup);
  if (motion)
    try
    {
      return solve_contact(body, *law, load, radius, control, &*motion);
    }
    catch (const ContactFailure &failure)
    {
      motion.reset();
      if (failure.outcome == ContactOutcome::tipping)
        throw;
      law = make_law(); // forgets its multipliers
    }
  return solve_contact(body, *law, load, radius, control);
}

ContactState RevolutionFoot::solve(const Resultants &load, const Slip &slip,
                                   const std::function<void(const ContactIteration &)> &)
{
  ContactState state;
  state.slip = slip;
  Resultants turned_load = load;
  if (is_isotropic())
  {
    // Solved with the load's maximum on the x axis, where the sine modes drop out.
    state.direction = std::atan2(load.moment_x, -load.moment_y);
    turned_load = { load.normal_force, 0, -std::hypot(load.moment_x, load.moment_y) };
  }
  set_orientation(slip.orientation);
  if (setup.friction_coefficient > 0)
    body.set_sliding(SlidingTraction{ setup.friction_coefficient, slip.spin_per_speed });
  state.solution = solve_from_before(turned_load);
  motion = state.solution.motion;
  state.load = extract_load(*law, state.solution, setup.n_load_harmonics);
  if (is_isotropic())
    state.load = state.load.turned(state.direction);
  return state;
}

std::vector<PointForce> RevolutionFoot::point_forces(const ContactState &state)
{
  set_orientation(state.slip.orientation);
  const double cosine = std::cos(state.direction);
  const double sine = std::sin(state.direction);
  std::vector<PointForce> points = law->load(state.solution).points;
  for (PointForce &point : points)
    point = { point.x * cosine - point.y * sine, point.x * sine + point.y * cosine, point.force };
  return points;
}

PressureMap RevolutionFoot::pressure_map(const ContactState &state)
{
  set_orientation(state.slip.orientation);
  return law->pressure_map(state.solution).turned(state.direction);
}

std::vector<FieldFile> RevolutionFoot::fields(const ContactState &state)
{
  require_latest(body, state);
  set_orientation(state.slip.orientation);
  dealii::Triangulation<2> triangulation;
  make_meridian_mesh(setup.profile, setup.resolution, triangulation);
  const MeridianSpace space(triangulation, setup.material, setup.meridian.degree);
  const MeridianField field(space, setup.material, body.force_modes());
  const PressureField pressure(body, *law, state.solution,
                               [this](double r, double theta) { return gap(r, theta); });
  std::ostringstream file;
  write_revolution_fields(field, pressure, { state.solution.motion, state.direction }, file);
  return { { "contact.vtu", file.str() } };
}

} // namespace stemware::fem
