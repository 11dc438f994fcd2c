#include "fem/solid/solid_foot.h"

#include "fem/contact/winkler_interface.h"
#include "fem/geometry/mesh_io.h"
#include "fem/solid/cell_numbers.h"
#include "fem/solid/condensed_body.h"
#include "fem/solid/mesh_estimate.h"
#include "fem/solid/nested_contact.h"
#include "ring_model/load/constants.h"

#include <deal.II/base/mpi.h>
#include <deal.II/distributed/tria.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <tuple>

namespace stemware::fem
{

namespace
{

SolidGap gap_of(const SolidMesh &mesh, const GlassProfile &profile)
{
  if (mesh.report)
    return [](double, double) { return 0.; };
  return [profile](double x, double y) { return profile.gap(std::hypot(x, y)); };
}

/// Returns @p setup with the edges of @p mesh.
SolidSetup setup_on(const SolidMesh &mesh, SolidSetup setup)
{
  setup.options.straight_edges = mesh.report && !mesh.report->round_rim;
  return setup;
}

struct FootNumbers
{
  /// Ratio of the foot's compliance to the compliance of the spring that approximates a hard interface on a
  /// mesh with coarser levels. The body of revolution uses the same ratio.
  double hardness = 1000;
  /// Softening factor of the spring per coarser mesh. From one mesh to the next, Newton's method then needs
  /// only a few steps.
  double softening = 8;
  /// Penalty of the multipliers relative to E / (cell size), and residual reduction of a linear solve between
  /// their updates. With a penalty of 1, one update halves the error of the highest modes; with 10, a tenth
  /// remains. With 100, the linear solves need more additional iterations than the fewer updates save.
  double penalty = 10, reduction = 0.1;
  /// Ratio of the tolerances of consecutive multiplier solves, about the fraction of the multipliers' error
  /// that remains after one update.
  double tighter = 0.02;
  /// Maximum number of Newton steps with multipliers, which is large because each step has a loose tolerance.
  unsigned int max_steps = 300;
  /// Minimum number of symmetry sectors of a mesh that is treated as axisymmetric.
  unsigned int min_symmetry_sectors = 12;
  unsigned int max_condensed_nodes = 1000;
};
constexpr FootNumbers foot_numbers = {};

/// Returns true if the contact is solved with the condensed compliance of the contact nodes. Condensation
/// costs as much as about four contact solves of the whole body.
bool is_condensed(const SolidBody &body, const SolidOptions &options)
{
  if (options.linear_solver == LinearSolver::multigrid)
    return false;
  const unsigned int n_ranks = dealii::Utilities::MPI::n_mpi_processes(body.dofs().get_communicator()),
                     n_nodes = body.contact_surface().n_global_nodes();
  const bool is_small = n_ranks == 1 && body.n_unknowns() <= max_condensed_unknowns &&
                        n_nodes <= foot_numbers.max_condensed_nodes;
  if (options.linear_solver == LinearSolver::automatic)
    return is_small && !body.has_coarser_mesh();
  if (!is_small)
    throw std::invalid_argument("A foot of " + std::to_string(body.n_unknowns()) + " unknowns and " +
                                std::to_string(n_nodes) + " contact nodes on " + std::to_string(n_ranks) +
                                " ranks cannot be condensed to its contact nodes; at most " +
                                std::to_string(max_condensed_unknowns) + ", " +
                                std::to_string(foot_numbers.max_condensed_nodes) +
                                " and 1 are allowed. Take the linear solver multigrid.");
  return true;
}

bool is_spring(const SolidSetup &setup, const SolidBody &body)
{
  return setup.table.interface->is_hard() && body.has_coarser_mesh();
}

std::shared_ptr<const InterfaceLaw> interface_of(const SolidSetup &setup, const SolidBody &body)
{
  if (setup.table.substrate)
    throw std::invalid_argument("A solid foot cannot stand on an elastic substrate; take a rigid one, or the "
                                "foot as a body of revolution.");
  if (!is_spring(setup, body))
    return setup.hardness < 1 ? setup.table.interface->softened(1 / setup.hardness) : setup.table.interface;
  const double nu = setup.material.poisson_ratio;
  const double width = setup.profile.crown_radius > 0 ? body.contact_cell_size() : setup.profile.land_width;
  return std::make_shared<WinklerInterface>(setup.hardness * foot_numbers.hardness *
                                            setup.material.young_modulus / ((1 - nu * nu) * width));
}

} // namespace

void halve(SolidMesh &mesh, const std::vector<unsigned int> &marked)
{
  const CellNumbers number(*mesh.triangulation);
  const std::set<std::size_t> among(marked.begin(), marked.end());
  for (const auto &cell : mesh.triangulation->active_cell_iterators())
    if (cell->is_locally_owned() && among.count(number(cell->id())) > 0)
      cell->set_refine_flag();
  mesh.triangulation->execute_coarsening_and_refinement();
}

SolidMesh generate_solid_mesh(const GlassProfile &profile, const FootResolution &resolution)
{
  const auto mesh = std::make_shared<dealii::parallel::distributed::Triangulation<3>>(MPI_COMM_WORLD);
  make_foot_mesh(profile, resolution, *mesh);
  return { mesh, std::nullopt };
}

SolidMesh read_solid_mesh(const std::string &file, unsigned int refinements, const MeshFileOptions &marks)
{
  const auto mesh = std::make_shared<dealii::parallel::distributed::Triangulation<3>>(MPI_COMM_WORLD);
  const MeshReport report = read_foot_mesh(file, *mesh, marks);
  mesh->refine_global(refinements);
  return { mesh, report };
}

SolidFoot::SolidFoot(const SolidMesh &mesh, const SolidSetup &given, const SolidFoot *similar)
    : setup(setup_on(mesh, given))
    , mesh(mesh)
    , body(std::make_unique<SolidBody>(*mesh.triangulation, setup.material, gap_of(mesh, setup.profile),
                                       setup.options, similar ? similar->body.get() : nullptr))
    , interface(interface_of(setup, *body))
    , softening_of_coarser(is_spring(setup, *body) ? foot_numbers.softening : 1)
    , law(interface->make(body->contact_surface(),
                          foot_numbers.penalty * setup.material.young_modulus / body->contact_cell_size()))
    , n_contact_nodes(body->contact_surface().n_global_nodes())
{
  if (has_multipliers())
    body->set_linear_tolerance(foot_numbers.reduction);
  if (!is_condensed(*body, setup.options))
    return;
  const bool slides = setup.friction_coefficient > 0;
  if (similar && similar->compliance && (!slides || similar->compliance->along_x.size() > 0))
    compliance = similar->compliance;
  else
    compliance = std::make_shared<const NodalCompliance>(
      condense(body->mesh(), setup.material, body->contact_nodes(), slides));
  condensed = std::make_unique<CondensedBody>(body->contact_surface(), compliance);
}

SolidFoot::~SolidFoot() = default;

FootDescription SolidFoot::description() const
{
  FootDescription description;
  description.body = "solid";
  description.n_cells = static_cast<unsigned int>(mesh.triangulation->n_global_active_cells());
  description.n_unknowns = body->n_unknowns();
  description.n_contact_nodes = n_contact_nodes;
  description.mesh_report = mesh.report;
  description.contact_cell_size = body->contact_cell_size();
  return description;
}

FootCapabilities SolidFoot::capabilities() const
{
  FootCapabilities capabilities;
  capabilities.is_collective = true;
  capabilities.friction_deforms = setup.friction_coefficient > 0;
  if (mesh.report && mesh.report->n_symmetry_sectors < foot_numbers.min_symmetry_sectors)
    capabilities.glass_period = 2 * ring::pi / mesh.report->n_symmetry_sectors;
  return capabilities;
}

ContactState SolidFoot::solve(const ContactDemand &demand, const ring::Slip &slip, const ContactGuess &guess,
                              const std::function<void(const ContactIteration &)> &progress) const
{
  ContactState state;
  state.demand = demand;
  state.slip = slip;
  ContactControl control;
  if (softening_of_coarser != 1)
    control = penalty_control();
  control.progress = [&](const ContactIteration &iteration)
  {
    state.history.push_back(iteration);
    if (progress)
      progress(iteration);
  };
  const double axis = axis_of(slip);
  state.solution = press(demand.in_rotated_axes(axis), slip, guess.previous, control);
  if (!condensed)
    state.body = std::make_shared<const std::string>(body->state());
  state.solution.motion.tail<2>() = Eigen::Rotation2Dd(axis) * state.solution.motion.tail<2>();
  state.load = project_onto_rings(state, demand.ring_radii, demand.n_harmonics);
  std::tie(state.inner_radius, state.outer_radius) = loaded_band(law->load(state.solution, 1));
  return state;
}

void SolidFoot::restore_displacement(const ContactState &state) const
{
  if (!condensed)
    return body->set_state(*state.body);
  body->set_sliding(sliding_at(state.slip));
  body->set_forces(state.solution.forces);
}

SlidingTraction SolidFoot::sliding_at(const ring::Slip &slip) const
{
  return { setup.friction_coefficient, slip.spin_per_speed, axis_of(slip), setup.friction_by_slip };
}

ContactSolution SolidFoot::in_mesh_axes(const ContactState &state) const
{
  ContactSolution solution = state.solution;
  solution.motion.tail<2>() = Eigen::Rotation2Dd(-axis_of(state.slip)) * solution.motion.tail<2>();
  return solution;
}

ContactSolution SolidFoot::find_contact(const LinearConditions &conditions, ContactControl control,
                                        std::optional<ContactStart> start) const
{
  ElasticBody &pressed = condensed ? static_cast<ElasticBody &>(*condensed) : *body;
  const auto solve = [&](const ContactControl &to)
  {
    return solve_contact(pressed, *law, conditions, setup.profile.contact_radius, to,
                         start ? &*start : nullptr);
  };
  if (!has_multipliers())
    return solve(control);
  // The tolerances decrease with the error of the multipliers, because the next update of the multipliers
  // would destroy a more accurate equilibrium.
  control.max_steps = foot_numbers.max_steps;
  ContactControl loose = control;
  loose.resultant_tolerance = std::numeric_limits<double>::infinity();
  for (double share = foot_numbers.tighter; share > control.equilibrium_tolerance;
       share *= foot_numbers.tighter)
  {
    loose.tolerance = loose.equilibrium_tolerance = share;
    const ContactSolution found = solve(loose);
    start = { found.motion, found.normal_displacement, found.n_iterations, found.n_linear_iterations };
  }
  return solve(control);
}

ContactSolution SolidFoot::press(const ContactDemand &demand, const ring::Slip &slip,
                                 const ContactState *before, const ContactControl &control) const
{
  const double radius = setup.profile.contact_radius;
  const LinearConditions conditions = conditions_of(body->contact_surface(), demand);
  body->set_sliding(sliding_at(slip));
  if (condensed)
    condensed->set_friction(body->friction_per_force());
  if (before)
    try
    {
      if (condensed)
        condensed->set_forces(before->solution.forces);
      else
        body->set_state(*before->body);
      law->set_multipliers(before->solution.forces);
      const ContactSolution nearby = in_mesh_axes(*before);
      const ContactStart start = { nearby.motion, nearby.normal_displacement };
      const ContactSolution solution = find_contact(conditions, control, start);
      if (solution.stability_margin > 0)
        return solution;
    }
    catch (const ContactFailure &failure)
    {
      if (failure.outcome == ContactOutcome::tipping)
        throw;
    }
  law->set_multipliers({});
  const ContactSolution solution = find_contact(
    conditions, control, start_from_coarser_mesh(*body, *interface, softening_of_coarser, demand, radius));
  if (!(solution.stability_margin > 0))
    throw ContactFailure(ContactOutcome::tipping, "the only balance found is unstable: the glass tips. Lower "
                                                  "the centre of mass or the hand, or reduce the speed.");
  return solution;
}

unsigned int SolidFoot::n_resolved_harmonics() const
{
  // Two cells resolve one harmonic. Harmonics above 24 are negligible.
  return std::clamp(body->contact_surface().n_sectors / 2, 1u, 24u);
}

ContactLoad SolidFoot::project_onto_rings(const ContactState &state, const std::vector<double> &ring_radii,
                                          unsigned int n_harmonics) const
{
  return extract_load(*law, state.solution, kept_harmonics(n_harmonics), ring_radii)
    .rotated(axis_of(state.slip));
}

std::vector<PointForce> SolidFoot::point_forces(const ContactState &state) const
{
  std::vector<double> packed;
  for (const PointForce &point : law->load(state.solution, 1).points)
    packed.insert(packed.end(), { point.x, point.y, point.force });
  packed = body->contact_surface().parts.gather(packed);
  std::vector<PointForce> points;
  for (std::size_t i = 0; i < packed.size(); i += 3)
    points.push_back({ packed[i], packed[i + 1], packed[i + 2] });
  return rotated_by(std::move(points), axis_of(state.slip));
}

PressureMap SolidFoot::pressure_map(const ContactState &state) const
{
  const double axis = axis_of(state.slip);
  PressureMap map = law->pressure_map(state.solution);
  return axis == 0 ? map : map.rotated(axis);
}

std::optional<MeshError> SolidFoot::mesh_error(const ContactState &state, const ContactGoal &goal,
                                               bool with_cells) const
{
  const bool is_at_right_angle =
    !mesh.report && setup.profile.shape == GlassShape::step && setup.profile.crown_radius == 0;
  const bool is_narrow =
    !is_at_right_angle && state.outer_radius - state.inner_radius < 2 * body->contact_cell_size();
  if (has_multipliers() || (setup.table.interface->is_hard() && is_narrow))
    return std::nullopt;
  restore_displacement(state);
  const double axis = axis_of(state.slip);
  const Eigen::Rotation2Dd back(-axis);
  SolvedSolidContact contact = { *body,
                                 *interface,
                                 gap_of(mesh, setup.profile),
                                 sliding_at(state.slip),
                                 state,
                                 setup.options.straight_edges };
  contact.state.demand = state.demand.in_rotated_axes(axis);
  contact.state.solution = in_mesh_axes(state);
  contact.state.load =
    extract_load(*law, state.solution, kept_harmonics(state.demand.n_harmonics), goal.ring_radii);
  ContactGoal in_mesh_axes = goal;
  in_mesh_axes.of_load = goal.of_load.of_rotated(axis);
  in_mesh_axes.of_moment = back * goal.of_moment;
  in_mesh_axes.of_motion.tail<2>() = back * goal.of_motion.tail<2>();
  return estimate_mesh_error(contact, in_mesh_axes, with_cells);
}

std::vector<FieldFile> SolidFoot::fields(const ContactState &state) const
{
  const ContactSolution solution = in_mesh_axes(state);
  restore_displacement(state);
  return body->fields(solution.motion, law->nodal_pressure(solution));
}

} // namespace stemware::fem
