#include "fem/revolution/goal_estimate.h"

#include "fem/contact/contact_demand.h"
#include "fem/revolution/gap_gradient.h"
#include "fem/revolution/meridian_field.h"
#include "fem/revolution/meridian_meshes.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

namespace stemware::fem
{

namespace
{

constexpr unsigned int n_corner_halvings = 3;

/// Marks the active cells by their number plus one, which their children can find.
void number_cells(dealii::Triangulation<2> &triangulation)
{
  if (triangulation.n_levels() == 0)
    return;
  triangulation.clear_user_data();
  for (const auto &cell : triangulation.active_cell_iterators())
    cell->set_user_index(cell->active_cell_index() + 1);
}

double size_of_mode(const ForceModes &forces, Eigen::Index mode)
{
  double square = forces.normal.col(mode).squaredNorm();
  for (const Eigen::MatrixXd *kind : { &forces.radial, &forces.azimuthal })
    if (kind->size() > 0)
      square += kind->col(mode).squaredNorm();
  return std::sqrt(square);
}

/// The modes that tell the shares of cells in the products of @p forces and @p dual_forces: the others, each
/// of which would take a factorisation, have no more than a hundredth of all products together.
std::vector<bool> telling_modes(const ForceModes &forces, const ForceModes &dual_forces)
{
  constexpr double negligible = 1e-2;
  std::vector<std::pair<double, std::size_t>> products;
  double sum = 0;
  for (Eigen::Index mode = 0; mode < forces.normal.cols(); ++mode)
  {
    products.emplace_back(size_of_mode(forces, mode) * size_of_mode(dual_forces, mode), mode);
    sum += products.back().first;
  }
  std::sort(products.begin(), products.end());
  std::vector<bool> tells(products.size());
  double left_out = 0;
  for (const auto &[product, mode] : products)
    tells[mode] = (left_out += product) > negligible * sum;
  return tells;
}

ForceModes only(const std::vector<bool> &modes, ForceModes forces)
{
  for (Eigen::MatrixXd *kind : { &forces.normal, &forces.radial, &forces.azimuthal })
    for (Eigen::Index mode = 0; mode < kind->cols(); ++mode)
      if (!modes[static_cast<std::size_t>(mode)])
        kind->col(mode).setZero();
  return forces;
}

/// Sizes of the energy products, on each cell that has been numbered, of the details of the displacements
/// under @p forces and @p dual_forces.
std::vector<double> detail_products(const dealii::Triangulation<2> &triangulation,
                                    const ElasticMaterial &material, unsigned int degree,
                                    const ForceModes &forces, const ForceModes &dual_forces)
{
  const MeridianSpace space(triangulation, material, degree);
  const std::vector<bool> modes = telling_modes(forces, dual_forces);
  const MeridianField primal(space, material, only(modes, forces)),
    dual(space, material, only(modes, dual_forces));
  std::vector<double> shares;
  for (const auto &cell : space.dof_handler().cell_iterators())
  {
    if (cell->user_index() == 0)
      continue;
    double product = 0;
    for (unsigned int mode = 0; mode < primal.n_modes(); ++mode)
      if (primal.displacement(mode).size() > 0 && dual.displacement(mode).size() > 0)
        product +=
          FourierBasis::norm(mode) * space.detail_product(FourierBasis::harmonic(mode), cell,
                                                          primal.displacement(mode), dual.displacement(mode));
    shares.resize(std::max<std::size_t>(shares.size(), cell->user_index()));
    shares[cell->user_index() - 1] = std::abs(product);
  }
  return shares;
}

} // namespace

MeshError estimate_mesh_error(const SolvedContact &contact, const ContactGoal &goal, bool with_cells)
{
  const RevolutionSetup &setup = contact.setup;
  const ContactState &state = *contact.state;
  const ContactCompliance &circles = contact.body.contact_compliance();
  const unsigned int n_lines = setup.n_lines;
  MeridianOptions options = setup.meridian;
  if (++options.degree > 4)
    throw std::invalid_argument("The error of the mesh is estimated with elements of one degree more, of "
                                "which 4 is the highest; give Contact/Degree = 3 or less.");

  // The body on finer elements, with the contact zone of the coarse one.
  MeridianMeshes meshes(setup);
  number_cells(meshes.foot);
  number_cells(meshes.disc);
  meshes.refine_where_singular(state.inner_radius, state.outer_radius, n_corner_halvings);
  const double margin = 1e-9 * circles.radii.tail<1>()(0);
  options.inner_radius = circles.radii(0) - margin;
  options.outer_radius = circles.radii.tail<1>()(0) + margin;
  const std::shared_ptr<const ContactCompliance> land = compliance_of(setup, meshes, options, *contact.cache);
  const auto n_below = [&](double radius) -> Eigen::Index { return (land->radii.array() < radius).count(); };
  const Eigen::Index first = n_below(circles.radii(0) - margin);
  const Eigen::Index size = n_below(circles.radii.tail<1>()(0) + margin) - first;
  BodyOfRevolution body(land->part(first, size), contact.gap, n_lines);
  body.set_sliding(contact.sliding);
  const ContactSurface &surface = body.contact_surface();

  // What it answers to the forces at the coarse displacement.
  const Eigen::MatrixXd coarse = state.solution.normal_displacement.reshaped(circles.n_nodes(), n_lines);
  Eigen::MatrixXd displacement(size, n_lines);
  for (Eigen::Index i = 0; i < size; ++i)
    displacement.row(i) = circles.shape_at(body.contact_compliance().radii(i)).transpose() * coarse;
  const std::unique_ptr<TableLaw> law = contact.interface.make(surface, 0);
  ContactForces pressed;
  law->evaluate(displacement.reshaped(), pressed);
  body.set_forces(pressed.forces);
  const Eigen::VectorXd missed =
    body.contact_displacement() + surface.motion_modes() * state.solution.motion - displacement.reshaped();

  // The weights of that.
  const LinearConditions conditions = conditions_of(surface, state.demand);
  ForceFunction function;
  function.of_forces = node_values(surface, goal.ring_radii, goal.of_load) +
                       goal.of_moment(0) * surface.node_position.col(1) -
                       goal.of_moment(1) * surface.node_position.col(0);
  function.of_motion = goal.of_motion;
  const GapGradient gradient = gap_gradient(body, pressed.tangent, conditions, function);
  MeshError error;
  error.correction = gradient.of_gap.reshaped().dot(missed) -
                     gradient.of_conditions.dot(conditions.residual(pressed.forces, state.solution.motion));
  if (!with_cells)
    return error;

  const auto on_land = [&](const Eigen::MatrixXd &modes) { return body.contact_compliance().on_land(modes); };
  const ForceModes modes = body.elastic_response().force_modes(body.forces());
  const ForceModes dual = { on_land(body.fourier_basis().project(gradient.of_gap)), {}, {} };
  const auto forces_on = [&](bool with_friction) -> ForceModes
  {
    if (!with_friction)
      return { on_land(modes.normal), {}, {} };
    return { on_land(modes.normal), on_land(modes.radial), on_land(modes.azimuthal) };
  };
  if (!setup.foot_is_rigid)
    error.foot_cells =
      detail_products(meshes.foot, setup.material, options.degree, forces_on(setup.friction_in_foot), dual);
  if (setup.table.substrate)
    error.disc_cells = detail_products(meshes.disc, setup.table.substrate->material, options.degree,
                                       forces_on(setup.friction_in_substrate), dual);
  return error;
}

} // namespace stemware::fem
