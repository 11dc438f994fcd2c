#include "fem/solid/solid_foot.h"

#include "fem/contact/winkler_interface.h"
#include "fem/solid/nested_contact.h"

#include <deal.II/distributed/tria.h>

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

SolidMesh read_solid_mesh(const std::string &file, unsigned int refinements)
{
  const auto mesh = std::make_shared<dealii::parallel::distributed::Triangulation<3>>(MPI_COMM_WORLD);
  const MeshReport report = read_foot_mesh(file, *mesh);
  mesh->refine_global(refinements);
  return { mesh, report };
}

SolidFoot::SolidFoot(const SolidMesh &mesh, const SolidSetup &setup)
    : contact_radius(setup.profile.contact_radius)
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
  return capabilities;
}

ContactState SolidFoot::solve(const ContactDemand &demand, const Slip &slip,
                              const std::function<void(const ContactIteration &)> &progress)
{
  ContactState state;
  state.slip = slip;
  ContactControl control;
  control.progress = [&](const ContactIteration &iteration)
  {
    state.history.push_back(iteration);
    if (progress)
      progress(iteration);
  };
  if (!before)
    before = start_from_coarser_mesh(body, *interface, softening_of_coarser, demand, contact_radius);
  state.solution = solve_contact(body, *law, conditions_of(body.contact_surface(), demand), contact_radius,
                                 control, before ? &*before : nullptr);
  before = { state.solution.motion, state.solution.normal_displacement };
  state.load = gather(state, demand.ring_radii, demand.n_harmonics);
  std::tie(state.inner_radius, state.outer_radius) = loaded_band(law->load(state.solution).points);
  return state;
}

unsigned int SolidFoot::n_resolved_harmonics() const
{
  // Half the cells round the rim resolve that many; more than 24 matter nowhere.
  return std::clamp(body.contact_surface().n_sectors / 2, 1u, 24u);
}

LoadHarmonics SolidFoot::gather(const ContactState &state, const std::vector<double> &ring_radii,
                                unsigned int n_harmonics)
{
  return extract_load(*law, state.solution, kept_harmonics(n_harmonics), ring_radii);
}

std::vector<PointForce> SolidFoot::point_forces(const ContactState &state)
{
  return law->load(state.solution).points;
}

PressureMap SolidFoot::pressure_map(const ContactState &state)
{
  return law->pressure_map(state.solution);
}

std::vector<FieldFile> SolidFoot::fields(const ContactState &state)
{
  require_latest(body, state);
  std::string text = body.vtu_file(state.solution.motion, law->nodal_pressure(state.solution));
  if (text.empty()) // not on the first rank
    return {};
  return { { "contact.vtu", std::move(text) } };
}

} // namespace stemware::fem
