#include "fem/solid/solid_foot.h"

#include "fem/contact/winkler_interface.h"
#include "fem/solid/nested_contact.h"

#include <deal.II/distributed/tria.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <tuple>

namespace stemware::fem
{

namespace
{

SolidBody::Gap gap_of(const SolidMesh &mesh, const GlassProfile &profile)
{
  if (mesh.report)
    return [](double, double) { return 0.; };
  return [profile](double x, double y) { return profile.gap(std::hypot(x, y)); };
}

SolidOptions options_of(const SolidMesh &mesh, SolidOptions options)
{
  options.straight_edges = mesh.report && !mesh.report->round_rim;
  return options;
}

/// How much more a foot yields than the spring that stands for a hard interface, integrated along lines, on a
/// mesh that can be refined; that of the body of revolution.
constexpr double hardness = 1000;

/// How much softer it is on each coarser mesh.
constexpr double softening = 8;

/// A mesh of as many equal parts round the axis is one of a body of revolution, as far as it can say.
constexpr unsigned int fewest_repetitions = 12;

bool is_spring(const SolidSetup &setup, const SolidBody &body)
{
  return setup.table.interface->is_hard() && body.has_hierarchy();
}

std::shared_ptr<const InterfaceLaw> interface_of(const SolidSetup &setup, const SolidBody &body)
{
  if (setup.table.substrate)
    throw std::invalid_argument("A solid foot cannot stand on an elastic substrate; take a rigid one, or the "
                                "foot as a body of revolution.");
  if (!is_spring(setup, body))
    return setup.table.interface;
  const double nu = setup.material.poisson_ratio;
  const double width = setup.profile.crown_radius > 0 ? body.contact_cell_size() : setup.profile.land_width;
  return std::make_shared<WinklerInterface>(hardness * setup.material.young_modulus /
                                            ((1 - nu * nu) * width));
}

} // namespace

SolidMesh generate_solid_mesh(const GlassProfile &profile, const FootResolution &resolution)
{
  const auto mesh = std::make_shared<dealii::parallel::distributed::Triangulation<3>>(MPI_COMM_WORLD);
  make_foot_mesh(profile, resolution, *mesh);
  return { mesh, std::nullopt };
}

SolidMesh read_solid_mesh(const std::string &file, unsigned int refinements, const MeshMarks &marks)
{
  const auto mesh = std::make_shared<dealii::parallel::distributed::Triangulation<3>>(MPI_COMM_WORLD);
  const MeshReport report = read_foot_mesh(file, *mesh, marks);
  mesh->refine_global(refinements);
  return { mesh, report };
}

SolidFoot::SolidFoot(const SolidMesh &mesh, const SolidSetup &setup)
    : setup(setup)
    , mesh(mesh)
    , body(*mesh.triangulation, setup.material, gap_of(mesh, setup.profile), options_of(mesh, setup.options))
    , interface(interface_of(setup, body))
    , softening_of_coarser(is_spring(setup, body) ? softening : 1)
    , law(interface->make(body.contact_surface(), setup.material.young_modulus / body.contact_cell_size()))
{
}

FootDescription SolidFoot::description() const
{
  FootDescription description;
  description.body = "solid";
  description.n_cells = static_cast<unsigned int>(mesh.triangulation->n_global_active_cells());
  description.n_unknowns = body.n_unknowns();
  description.n_contact_nodes = body.contact_surface().n_nodes();
  description.mesh_report = mesh.report;
  return description;
}

FootCapabilities SolidFoot::capabilities() const
{
  FootCapabilities capabilities;
  capabilities.is_collective = true;
  capabilities.friction_deforms = setup.friction_coefficient > 0;
  if (mesh.report && mesh.report->n_repetitions < fewest_repetitions)
    capabilities.period_of_glass = 2 * dealii::numbers::PI / mesh.report->n_repetitions;
  return capabilities;
}

ContactState SolidFoot::solve(const ContactDemand &demand, const Slip &slip,
                              const std::function<void(const ContactIteration &)> &progress)
{
  ContactState state;
  state.slip = slip;
  ContactControl control;
  control.set_matters = softening_of_coarser == 1; // a spring's pressure is integrated along lines
  control.progress = [&](const ContactIteration &iteration)
  {
    state.history.push_back(iteration);
    if (progress)
      progress(iteration);
  };
  const double axis = axis_of(slip);
  body.set_sliding({ setup.friction_coefficient, slip.spin_per_speed, axis, setup.friction_by_slip });
  state.solution = press(axis == 0 ? demand : demand.in_axes_turned_by(axis), control);
  before = { state.solution.motion, state.solution.normal_displacement };
  state.solution.motion.tail<2>() = Eigen::Rotation2Dd(axis) * state.solution.motion.tail<2>();
  state.load = gather(state, demand.ring_radii, demand.n_harmonics);
  std::tie(state.inner_radius, state.outer_radius) = loaded_band(law->load(state.solution).points);
  return state;
}

ContactSolution SolidFoot::press(const ContactDemand &demand, const ContactControl &control)
{
  const double radius = setup.profile.contact_radius;
  const LinearConditions conditions = conditions_of(body.contact_surface(), demand);
  if (before)
    try
    {
      return solve_contact(body, *law, conditions, radius, control, &*before);
    }
    catch (const ContactFailure &failure)
    {
      before.reset();
      if (failure.outcome == ContactOutcome::tipping)
        throw;
    }
  const std::optional<ContactStart> start =
    start_from_coarser_mesh(body, *interface, softening_of_coarser, demand, radius);
  return solve_contact(body, *law, conditions, radius, control, start ? &*start : nullptr);
}

unsigned int SolidFoot::n_resolved_harmonics() const
{
  // Half the cells round the rim resolve that many; more than 24 matter nowhere.
  return std::clamp(body.contact_surface().n_sectors / 2, 1u, 24u);
}

LoadHarmonics SolidFoot::gather(const ContactState &state, const std::vector<double> &ring_radii,
                                unsigned int n_harmonics)
{
  return extract_load(*law, state.solution, kept_harmonics(n_harmonics), ring_radii)
    .turned(axis_of(state.slip));
}

std::vector<PointForce> SolidFoot::point_forces(const ContactState &state)
{
  return turned_by(law->load(state.solution).points, axis_of(state.slip));
}

PressureMap SolidFoot::pressure_map(const ContactState &state)
{
  const double axis = axis_of(state.slip);
  PressureMap map = law->pressure_map(state.solution);
  return axis == 0 ? map : map.turned(axis);
}

std::vector<FieldFile> SolidFoot::fields(const ContactState &state)
{
  ContactState in_mesh_axes = state;
  in_mesh_axes.solution.motion.tail<2>() =
    Eigen::Rotation2Dd(-axis_of(state.slip)) * state.solution.motion.tail<2>();
  require_latest(body, in_mesh_axes);
  std::string text = body.vtu_file(in_mesh_axes.solution.motion, law->nodal_pressure(state.solution));
  if (text.empty()) // not on the first rank
    return {};
  return { { "contact.vtu", std::move(text) } };
}

} // namespace stemware::fem
