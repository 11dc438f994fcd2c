#include "fem/revolution/revolution_foot.h"

#include "fem/revolution/compliance_cache.h"
#include "fem/revolution/goal_estimate.h"
#include "fem/revolution/meridian_meshes.h"
#include "fem/revolution/revolution_output.h"

#include <Eigen/Geometry>
#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace stemware::fem
{

RevolutionFoot::Zone::Zone(const RevolutionFoot &foot, Eigen::Index first, Eigen::Index size)
    : first(first)
    , body(
        foot.compliance->part(first, size), [&foot](double r, double theta) { return foot.gap(r, theta); },
        foot.setup.n_lines)
    , law(foot.interface->make(body.contact_surface(), 0))
{
}

RevolutionFoot::RevolutionFoot(const RevolutionSetup &setup, ComplianceCache &cache)
    : setup(setup)
    , compliance(compliance_of(setup, MeridianMeshes(setup), setup.meridian, cache))
    , interface(setup.interface())
{
  constexpr double reach = 10; // half-widths: room for a load that gathers on a part of the rim
  setup.imperfection.validate();
  add_zone(reach * setup.contact_half_width);
}

void RevolutionFoot::add_zone(double reach)
{
  const Eigen::Index degree = compliance->degree;
  Eigen::Index first = 0, last = compliance->radii.size() - 1;
  if (reach > 0)
  {
    while (first + degree < last && compliance->radii(first + degree) < setup.profile.contact_radius - reach)
      first += degree;
    while (last - degree > first && compliance->radii(last - degree) > setup.profile.contact_radius + reach)
      last -= degree;
  }
  zones.push_back(std::make_unique<Zone>(*this, first, last - first + 1));
  before.reset();
  recent.clear();
  of_similar.clear();
}

bool RevolutionFoot::has_left_zone() const
{
  const Zone &zone = *zones.back();
  const Eigen::MatrixXd &forces = zone.body.forces();
  const double threshold = 1e-9 * forces.cwiseAbs().maxCoeff();
  const auto carries = [&](Eigen::Index row) { return forces.row(row).cwiseAbs().maxCoeff() > threshold; };
  return (zone.first > 0 && carries(0)) ||
         (zone.first + forces.rows() < compliance->radii.size() && carries(forces.rows() - 1));
}

RevolutionFoot::Zone &RevolutionFoot::zone_of(const ContactState &state)
{
  set_orientation(state.slip.orientation);
  return *zones.at(state.zone);
}

RevolutionFoot::RevolutionFoot(const RevolutionSetup &setup)
    : RevolutionFoot(setup, *std::make_unique<ComplianceCache>())
{
}

double RevolutionFoot::gap(double radius, double azimuth) const
{
  return setup.profile.gap(radius) +
         setup.imperfection.gap(radius / setup.profile.contact_radius, azimuth + axis(), phase);
}

FootDescription RevolutionFoot::description() const
{
  FootDescription description;
  description.body = "revolution";
  description.n_unknowns = elastic_body().n_unknowns();
  description.n_contact_nodes = elastic_body().contact_surface().n_nodes();
  return description;
}

FootCapabilities RevolutionFoot::capabilities() const
{
  FootCapabilities capabilities;
  capabilities.friction_deforms = setup.friction_coefficient > 0;
  return capabilities;
}

void RevolutionFoot::set_orientation(const FootOrientation &orientation)
{
  if (setup.imperfection.empty() || (orientation.glass == phase.glass && orientation.table == phase.table))
    return;
  const long line_before = crest_line();
  phase = orientation;
  const long n_turned = crest_line() - line_before;
  const Eigen::VectorXd gap_before = zones.back()->body.contact_surface().node_gap;
  for (const auto &zone : zones)
    zone->body.set_gap([this](double r, double theta) { return gap(r, theta); });
  turned.reset();
  recent.clear();
  crests_have_moved = true;
  if (!before)
    return;
  // The next contact starts from the penetration of the last one, where it is or turned with the crests.
  const Eigen::VectorXd &gap_now = zones.back()->body.contact_surface().node_gap;
  const Eigen::VectorXd penetration = -(gap_before + before->normal_displacement);
  before->normal_displacement = -(gap_now + penetration);
  if (n_turned == 0)
    return;
  turned = before;
  turned->normal_displacement = -(gap_now + turned_by_lines(penetration, n_turned));
  turned->motion.tail<2>() =
    Eigen::Rotation2Dd(static_cast<double>(n_turned) * line_spacing()) * before->motion.tail<2>();
}

double RevolutionFoot::line_spacing() const
{
  return boost::math::double_constants::two_pi / setup.n_lines;
}

double RevolutionFoot::crest() const
{
  if (setup.imperfection.empty())
    return 0;
  return setup.imperfection.glass.empty() ? phase.table : phase.glass;
}

long RevolutionFoot::crest_line() const
{
  return std::lround(crest() / line_spacing());
}

double RevolutionFoot::axis() const
{
  return crest() - static_cast<double>(crest_line()) * line_spacing();
}

ContactSolution RevolutionFoot::in_axes_of_lines(ContactSolution solution) const
{
  solution.motion.tail<2>() = Eigen::Rotation2Dd(-axis()) * solution.motion.tail<2>();
  return solution;
}

Eigen::VectorXd RevolutionFoot::turned_by_lines(const Eigen::VectorXd &nodal, long n) const
{
  const Eigen::Index n_lines = setup.n_lines, n_radii = nodal.size() / n_lines, shift = n % n_lines;
  Eigen::MatrixXd result(n_radii, n_lines);
  for (Eigen::Index j = 0; j < n_lines; ++j)
    result.col((j + shift + n_lines) % n_lines) = nodal.segment(j * n_radii, n_radii);
  return result.reshaped();
}

unsigned int RevolutionFoot::n_resolved_harmonics() const
{
  return (setup.n_lines - 1) / 2;
}

ContactState RevolutionFoot::solve(const ContactDemand &demand, const Slip &slip,
                                   const std::function<void(const ContactIteration &)> &)
{
  ContactState state;
  state.demand = demand;
  state.slip = slip;
  set_orientation(slip.orientation);
  state.solution = press(demand, slip);
  state.zone = static_cast<unsigned int>(zones.size() - 1);
  crests_have_moved = false;
  before = { state.solution.motion, state.solution.normal_displacement };
  remember(demand, slip);
  state.solution.motion.tail<2>() = Eigen::Rotation2Dd(axis()) * state.solution.motion.tail<2>();
  state.load = gather(state, demand.ring_radii, demand.n_harmonics);

  const BodyOfRevolution &body = zones.back()->body;
  const Eigen::VectorXd &radii = body.contact_compliance().radii;
  const Eigen::VectorXd on_circles = body.forces().cwiseAbs().rowwise().maxCoeff();
  const double threshold = 1e-9 * on_circles.maxCoeff();
  state.inner_radius = radii.tail<1>()(0);
  for (Eigen::Index i = 0; i < on_circles.size(); ++i)
    if (on_circles(i) > threshold)
    {
      state.inner_radius = std::min(state.inner_radius, radii(i));
      state.outer_radius = radii(i);
    }
  return state;
}

void RevolutionFoot::resume(const ContactState &state)
{
  set_orientation(state.slip.orientation);
  turned.reset();
  before.reset();
  crests_have_moved = false;
  if (state.zone + 1 != zones.size())
    return;
  zones.back()->body.set_forces(state.solution.forces);
  before = { in_axes_of_lines(state.solution).motion, state.solution.normal_displacement };
}

LoadHarmonics RevolutionFoot::gather(const ContactState &state, const std::vector<double> &ring_radii,
                                     unsigned int n_harmonics)
{
  const Zone &zone = zone_of(state);
  const Eigen::VectorXd &radii = zone.body.contact_compliance().radii;
  const unsigned int highest = kept_harmonics(n_harmonics);
  const auto of_nodes = [&](const Eigen::VectorXd &forces)
  { return harmonics_on_lines(forces.reshaped(radii.size(), setup.n_lines), radii, highest, ring_radii); };
  LoadHarmonics load = of_nodes(state.solution.forces);
  if (ring_radii.size() <= 2)
    return load.turned(axis());
  // Nodal forces have the radial moments of the pressure up to the elements' degree; what the pressure where
  // it lies has beyond is added. Force and moments stay what they are, those of the elastic forces.
  ContactForces by_law;
  zone.law->evaluate(state.solution.normal_displacement, by_law);
  const LoadHarmonics nodal = of_nodes(by_law.forces);
  const LoadHarmonics resolved = harmonics_of(
    zone.law->load(state.solution, parts_of_lines(ring_radii.size())).points, highest, ring_radii);
  for (std::size_t j = 0; j < load.n_rings(); ++j)
    for (std::size_t n = 0; n <= highest; ++n)
    {
      load.a[j][n] += resolved.a[j][n] - nodal.a[j][n];
      load.b[j][n] += resolved.b[j][n] - nodal.b[j][n];
    }
  return load.turned(axis());
}

std::vector<PointForce> RevolutionFoot::point_forces(const ContactState &state)
{
  const std::vector<PointForce> on_lines = zone_of(state).law->load(state.solution, 1).points;
  return turned_by(on_lines, axis()); // which is that of the state by now
}

PressureMap RevolutionFoot::pressure_map(const ContactState &state)
{
  PressureMap map = zone_of(state).law->pressure_map(state.solution);
  return axis() == 0 ? map : map.turned(axis());
}

std::optional<MeshError> RevolutionFoot::mesh_error(const ContactState &state, const ContactGoal &goal,
                                                    bool with_cells)
{
  if (!setup.imperfection.empty())
    return std::nullopt;
  const Zone &zone = zone_of(state);
  SolvedContact contact = { setup, zone.body, *interface };
  contact.gap = [this](double r, double theta) { return gap(r, theta); };
  contact.state = &state;
  contact.cache = &finer;
  if (setup.friction_coefficient > 0)
    contact.sliding =
      SlidingTraction{ setup.friction_coefficient, state.slip.spin_per_speed, 0, setup.friction_by_slip };
  return estimate_mesh_error(contact, goal, with_cells);
}

std::vector<FieldFile> RevolutionFoot::fields(const ContactState &state)
{
  const Zone &zone = zone_of(state);
  ContactState on_lines = state;
  on_lines.solution = in_axes_of_lines(state.solution);
  require_latest(zone.body, on_lines.solution);
  const MeridianMeshes meshes(setup);
  const MeridianSpace space(meshes.foot, setup.material, setup.meridian.degree);
  const auto on_land = [&](const Eigen::MatrixXd &modes) -> Eigen::MatrixXd
  {
    if (modes.size() == 0)
      return modes;
    Eigen::MatrixXd whole = Eigen::MatrixXd::Zero(compliance->n_nodes(), modes.cols());
    whole.middleRows(zone.first, modes.rows()) = modes;
    return whole;
  };
  const ForceModes modes = zone.body.elastic_response().force_modes(zone.body.forces());
  const MeridianField field(space, setup.material,
                            { on_land(modes.normal), on_land(modes.radial), on_land(modes.azimuthal) });
  const PressureField pressure(zone.body, *zone.law, on_lines.solution,
                               [this](double r, double theta) { return gap(r, theta); });
  std::ostringstream file;
  write_revolution_fields(field, pressure, state.solution.motion, axis(), file);
  return { { "contact.vtu", file.str() } };
}

} // namespace stemware::fem
