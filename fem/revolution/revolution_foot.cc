#include "fem/revolution/revolution_foot.h"

#include "fem/revolution/compliance_cache.h"
#include "fem/revolution/revolution_output.h"

#include <deal.II/grid/tria.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace stemware::fem
{

namespace
{

bool touches_without_penetration(const RevolutionSetup &setup)
{
  return setup.support == TableSupport::rigid || setup.support == TableSupport::elastic;
}

std::shared_ptr<const ContactCompliance> compliance_of(const RevolutionSetup &setup, ComplianceStore &store)
{
  dealii::Triangulation<2> foot;
  make_meridian_mesh(setup.profile, setup.resolution, foot);
  const auto compliance = store.get(foot, setup.material, setup.meridian);
  if (setup.support != TableSupport::elastic)
    return compliance;
  dealii::Triangulation<2> disc;
  make_meridian_mesh(setup.disc, setup.profile, setup.resolution, disc);
  const auto of_both = std::make_shared<ContactCompliance>(*compliance);
  *of_both += *store.get(disc, setup.disc_material, setup.meridian);
  return of_both;
}

std::unique_ptr<TableLaw> law_of(const RevolutionSetup &setup, const ContactCompliance &compliance,
                                 const ContactSurface &surface)
{
  if (setup.support == TableSupport::mat)
    return make_mat(surface, setup.foundation_modulus);
  if (setup.support == TableSupport::rough)
    return make_rough_interface(surface, setup.interface);
  const Eigen::Index n_steps = compliance.radii.size() - 1;
  const double smallest = (compliance.radii.tail(n_steps) - compliance.radii.head(n_steps)).minCoeff();
  const double modulus = setup.support == TableSupport::rigid
                           ? setup.material.young_modulus
                           : std::min(setup.material.young_modulus, setup.disc_material.young_modulus);
  return make_rigid_table(surface, 5 * modulus / smallest);
}

/// Complementarity node by node has a unique answer only if every node has a degree of freedom: as many lines
/// as modes.
unsigned int lines_of(const RevolutionSetup &setup)
{
  return touches_without_penetration(setup) ? 2 * setup.meridian.n_harmonics + 1 : setup.n_lines;
}

/// The load turned counter-clockwise.
LoadHarmonics turned(LoadHarmonics load, double angle)
{
  for (unsigned int n = 1; n < load.a.size(); ++n)
  {
    const double a = load.a[n];
    const double b = load.b[n];
    load.a[n] = a * std::cos(n * angle) - b * std::sin(n * angle);
    load.b[n] = a * std::sin(n * angle) + b * std::cos(n * angle);
  }
  for (AzimuthLoad &place : load.pointwise)
    place.azimuth += angle;
  const double x = load.moment_x;
  const double y = load.moment_y;
  load.moment_x = x * std::cos(angle) - y * std::sin(angle);
  load.moment_y = x * std::sin(angle) + y * std::cos(angle);
  return load;
}

} // namespace

double hertz_half_width(const RevolutionSetup &setup, double normal_force)
{
  const auto plane_strain_compliance = [](const ElasticMaterial &material)
  { return (1 - material.poisson_ratio * material.poisson_ratio) / material.young_modulus; };
  double compliance = plane_strain_compliance(setup.material);
  if (setup.support == TableSupport::elastic)
    compliance += plane_strain_compliance(setup.disc_material);
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
  if (!touches_without_penetration(*this))
    return resolved;
  if (flat)
  {
    // The foot bends, so the load gathers at the inner edge of the land.
    resolved.resolution.focus_radius = profile.land_inner_radius();
    resolved.resolution.focus_levels = 5;
    return resolved;
  }
  const double wanted = hertz_half_width(*this, normal_force) / 2;
  double cells = 0; // of the finest size, from the contact radius to the border of the land
  for (unsigned int i = 0; i < resolution.land_cells / 2; ++i)
    cells += std::pow(resolution.land_grading, i);
  const double size = profile.land_width / 2 / cells;
  resolved.resolution.focus_levels =
    static_cast<unsigned int>(std::max(0., std::ceil(std::log2(size / wanted))));
  return resolved;
}

struct FootResponse::Implementation
{
  Implementation(const RevolutionSetup &setup, ComplianceStore &store)
      : setup(setup)
      , compliance(compliance_of(setup, store))
      , body(
          *compliance, [this](double r, double theta) { return gap(r, theta); }, lines_of(setup))
      , law(law_of(setup, *compliance, body.contact_surface()))
  {
    setup.imperfection.validate();
    control.tolerance = 1e-10; // one Newton step less on most of a path of neighbouring loads
    if (touches_without_penetration(setup))
      control.max_steps = 400; // the multipliers of complementarity are steps too
  }

  double gap(double radius, double theta) const
  {
    return setup.profile.gap(radius) +
           setup.imperfection.gap(radius / setup.profile.contact_radius, theta, phase);
  }

  bool is_isotropic() const { return setup.imperfection.empty() && setup.friction_coefficient == 0; }

  void solve(const ContactLoad &load)
  {
    const double radius = setup.profile.contact_radius;
    if (solution)
      try
      {
        const Eigen::Vector3d start = solution->motion;
        solution = solve_contact(body, *law, load, radius, control, &start);
        return;
      }
      catch (const ContactFailure &failure)
      {
        solution.reset();
        if (failure.outcome == ContactOutcome::tipping)
          throw;
        law = law_of(setup, *compliance, body.contact_surface());
      }
    ++n_cold_starts;
    solution = solve_contact(body, *law, load, radius, control);
  }

  const RevolutionSetup setup;
  const std::shared_ptr<const ContactCompliance> compliance;
  FootPhase phase;
  double direction = 0; ///< of the solution's x axis in the slip frame [rad]
  BodyOfRevolution body;
  std::unique_ptr<TableLaw> law;
  ContactControl control;
  std::optional<ContactSolution> solution;
  unsigned int n_cold_starts = 0;
};

FootResponse::FootResponse(const RevolutionSetup &setup, ComplianceStore &store)
    : implementation(std::make_unique<Implementation>(setup, store))
{
}

FootResponse::FootResponse(const RevolutionSetup &setup)
{
  ComplianceStore store;
  implementation = std::make_unique<Implementation>(setup, store);
}

FootResponse::~FootResponse() = default;

LoadHarmonics FootResponse::press(const ContactLoad &load, const FootPhase &phase, double spin_per_speed)
{
  Implementation &foot = *implementation;
  if (foot.is_isotropic())
  {
    // Solved with the load's maximum on the x axis, where the sine modes drop out.
    foot.direction = std::atan2(load.moment_x, -load.moment_y);
    foot.solve({ load.normal_force, 0, -std::hypot(load.moment_x, load.moment_y) });
    return turned(extract_load(*foot.law, *foot.solution, foot.setup.n_load_harmonics), foot.direction);
  }
  foot.phase = phase;
  if (!foot.setup.imperfection.empty())
    foot.body.set_gap([&foot](double r, double theta) { return foot.gap(r, theta); });
  if (foot.setup.friction_coefficient > 0)
    foot.body.set_sliding(SlidingTraction{ foot.setup.friction_coefficient, spin_per_speed });
  foot.solve(load);
  return extract_load(*foot.law, *foot.solution, foot.setup.n_load_harmonics);
}

bool FootResponse::is_isotropic() const
{
  return implementation->is_isotropic();
}

void FootResponse::forget()
{
  implementation->solution.reset();
  implementation->law =
    law_of(implementation->setup, *implementation->compliance, implementation->body.contact_surface());
}

const ContactSolution &FootResponse::solution() const
{
  if (!implementation->solution)
    throw std::logic_error(
      "The foot has not been pressed on the table yet, so there is no contact solution.");
  return *implementation->solution;
}

double FootResponse::direction() const
{
  return implementation->direction;
}

void FootResponse::write_fields(std::ostream &file) const
{
  const Implementation &foot = *implementation;
  const RevolutionSetup &setup = foot.setup;
  dealii::Triangulation<2> triangulation;
  make_meridian_mesh(setup.profile, setup.resolution, triangulation);
  const MeridianSpace space(triangulation, setup.material, setup.meridian.degree);
  const MeridianField field(space, setup.material, foot.body.force_modes());
  const PressureField pressure(foot.body, *foot.law, solution(),
                               [&foot](double r, double theta) { return foot.gap(r, theta); });
  write_revolution_fields(field, pressure, { solution().motion, foot.direction }, file);
}

const BodyOfRevolution &FootResponse::body() const
{
  return implementation->body;
}

const TableLaw &FootResponse::law() const
{
  return *implementation->law;
}

unsigned int FootResponse::n_cold_starts() const
{
  return implementation->n_cold_starts;
}

} // namespace stemware::fem
