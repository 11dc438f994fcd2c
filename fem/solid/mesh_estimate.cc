#include "fem/solid/mesh_estimate.h"

#include "fem/geometry/boundary_ids.h"
#include "fem/solid/cell_numbers.h"
#include "ring_model/load/constants.h"

#include <deal.II/base/mpi.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/fe/fe_tools.h>
#include <deal.II/grid/tria.h>
#include <deal.II/multigrid/mg_transfer_global_coarsening.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <set>
#include <utility>
#include <vector>

namespace stemware::fem
{

using namespace dealii;

namespace
{

using DistributedMesh = parallel::distributed::Triangulation<3>;
using Cell = Triangulation<3>::active_cell_iterator;

/// Number of halvings of the cells at re-entrant edges, where a higher degree alone hardly reduces the error.
constexpr unsigned int n_edge_halvings = 2;

bool touches_contact(const Cell &cell, double inner, double outer)
{
  for (const auto &face : cell->face_iterators())
  {
    if (!is_on(face, FootBoundary::contact_zone))
      continue;
    double face_inner = std::numeric_limits<double>::max(), face_outer = 0;
    for (const unsigned int v : face->vertex_indices())
    {
      const double radius = std::hypot(face->vertex(v)[0], face->vertex(v)[1]);
      face_inner = std::min(face_inner, radius);
      face_outer = std::max(face_outer, radius);
    }
    if (face_inner < outer && face_outer > inner)
      return true;
  }
  return false;
}

/// Returns the angle between the two faces of @p cell at the edge @p line, assumed to be straight.
double angle_at(const Cell &cell, unsigned int line)
{
  const Point<3> begin = cell->line(line)->vertex(0), end = cell->line(line)->vertex(1);
  const Tensor<1, 3> along = (end - begin) / (end - begin).norm();
  std::vector<Tensor<1, 3>> across;
  for (const unsigned int f : cell->face_indices())
  {
    bool has_edge = false;
    for (unsigned int l = 0; l < GeometryInfo<2>::lines_per_cell; ++l)
      has_edge = has_edge || cell->face(f)->line_index(l) == cell->line_index(line);
    if (!has_edge)
      continue;
    Tensor<1, 3> direction = cell->face(f)->center() - begin;
    direction -= (direction * along) * along;
    across.push_back(direction / direction.norm());
  }
  return std::acos(std::clamp(across.at(0) * across.at(1), -1., 1.));
}

std::set<unsigned int> reentrant_edges(const DistributedMesh &mesh)
{
  std::map<unsigned int, double> angles;
  std::set<unsigned int> on_boundary;
  for (const auto &cell : mesh.active_cell_iterators())
  {
    if (cell->is_artificial())
      continue;
    for (const unsigned int l : cell->line_indices())
    {
      const double angle = angle_at(cell, l);
      angles[cell->line_index(l)] += angle;
      // A finer neighbour contains the two halves of the edge.
      if (cell->line(l)->has_children())
        for (unsigned int child = 0; child < 2; ++child)
          angles[static_cast<unsigned int>(cell->line(l)->child_index(child))] += angle;
    }
    for (const auto &face : cell->face_iterators())
      if (face->at_boundary())
        for (unsigned int l = 0; l < GeometryInfo<2>::lines_per_cell; ++l)
          on_boundary.insert(face->line_index(l));
  }
  // The margin above pi excludes the edges of curved boundaries.
  std::set<unsigned int> edges;
  for (const unsigned int line : on_boundary)
    if (angles[line] > 1.2 * ring::pi)
      edges.insert(line);
  return edges;
}

bool touches(const Cell &cell, const std::set<unsigned int> &edges)
{
  for (const unsigned int l : cell->line_indices())
    if (edges.count(cell->line_index(l)) > 0)
      return true;
  return false;
}

/// Returns copies of @p mesh, each finer than the previous copy: every copy halves the cells along re-entrant
/// edges, the first copy also the cells in contact between the radii @p inner and @p outer [m]. Collective.
std::vector<std::shared_ptr<const Triangulation<3>>> enriched_meshes(const Triangulation<3> &mesh,
                                                                     double inner, double outer)
{
  std::vector<std::shared_ptr<const Triangulation<3>>> meshes;
  const Triangulation<3> *before = &mesh;
  for (unsigned int n = 0; n < n_edge_halvings; ++n)
  {
    auto next = std::make_shared<DistributedMesh>(mesh.get_communicator());
    next->copy_triangulation(*before);
    const std::set<unsigned int> edges = reentrant_edges(*next);
    unsigned int n_marked = 0;
    for (const auto &cell : next->active_cell_iterators())
      if (cell->is_locally_owned() &&
          (touches(cell, edges) || (n == 0 && touches_contact(cell, inner, outer))))
      {
        cell->set_refine_flag();
        ++n_marked;
      }
    if (Utilities::MPI::sum(n_marked, mesh.get_communicator()) == 0)
      break;
    next->execute_coarsening_and_refinement();
    before = next.get();
    meshes.push_back(std::move(next));
  }
  return meshes;
}

using DofVector = MeshHierarchy::Vector;

/// The dual solution serves only as refinement indicator, so a loose tolerance suffices.
constexpr double dual_tolerance = 1e-4;

/// Stopping rule on the finer elements: maximum change of MeshError::correction in the last Newton step,
/// relative to the correction, and maximum relative residual of the forces.
constexpr double last_change = 0.1;
constexpr double left_unbalanced = 1e-3;

/// Transfer of displacements, in double precision, between the level of the mesh and the finer levels.
class Embedding
{
public:
  Embedding(const MeshHierarchy &hierarchy, unsigned int own)
      : hierarchy(hierarchy)
      , own(own)
      , transfers(hierarchy.n_levels() - own - 1)
  {
    for (unsigned int l = own + 1; l < hierarchy.n_levels(); ++l)
    {
      const SolidLevel &fine = hierarchy.level(l), &coarse = hierarchy.level(l - 1);
      transfers[l - own - 1].reinit(fine.dof_handler, coarse.dof_handler, fine.constraints,
                                    coarse.constraints);
    }
  }

  /// Returns @p vector on the finest level, with 0 at constrained unknowns.
  DofVector embedded(const DofVector &vector) const
  {
    DofVector coarse = hierarchy.level(own).ghosted();
    coarse.copy_locally_owned_data_from(vector);
    for (unsigned int l = own + 1; l < hierarchy.n_levels(); ++l)
    {
      hierarchy.level(l - 1).constraints.set_zero(coarse);
      DofVector fine = hierarchy.level(l).ghosted();
      transfers[l - own - 1].prolongate_and_add(fine, coarse);
      hierarchy.level(l).constraints.set_zero(fine);
      coarse.swap(fine);
    }
    return coarse;
  }

  /// Returns the interpolant of @p vector in the elements of the mesh, as a vector on the finest level.
  DofVector interpolated(const DofVector &vector) const
  {
    const unsigned int finest = hierarchy.n_levels() - 1;
    DofVector fine = hierarchy.level(finest).distributed(vector);
    for (unsigned int l = finest; l > own; --l)
    {
      const SolidLevel &above = hierarchy.level(l), &below = hierarchy.level(l - 1);
      DofVector coarse = below.ghosted();
      if (above.element.degree > below.element.degree)
        // deal.II's transfer would project here, and the result would depend on the order of the cells.
        FETools::interpolate(above.dof_handler, fine, below.dof_handler, below.constraints, coarse);
      else
        transfers[l - own - 1].interpolate(coarse, fine);
      fine = below.distributed(coarse);
    }
    return embedded(fine);
  }

private:
  const MeshHierarchy &hierarchy;
  const unsigned int own;
  std::vector<MGTwoLevelTransfer<3, DofVector>> transfers;
};

/// Returns the sums of @p products over cells. The product of an unknown is divided equally among its cells.
std::vector<double> sums_over_cells(const SolidLevel &level, const DofVector &products,
                                    const CellNumbers &numbers)
{
  const MPI_Comm &communicator = level.dof_handler.get_communicator();
  std::vector<types::global_dof_index> dofs(level.element.n_dofs_per_cell());
  DofVector multiplicity = level.ghosted(), values = level.ghosted();
  const auto for_each_cell = [&](const auto &visit)
  {
    for (const auto &cell : level.dof_handler.active_cell_iterators())
      if (cell->is_locally_owned())
      {
        cell->get_dof_indices(dofs);
        visit(cell);
      }
  };
  for_each_cell(
    [&](const auto &)
    {
      for (const auto dof : dofs)
        multiplicity(dof) += 1;
    });
  multiplicity.compress(VectorOperation::add);
  multiplicity.update_ghost_values();
  values.copy_locally_owned_data_from(products);
  values.update_ghost_values();
  std::vector<double> sums(numbers.size(), 0);
  for_each_cell(
    [&](const auto &cell)
    {
      double &sum = sums[numbers(cell->id())];
      for (const auto dof : dofs)
        sum += values(dof) / multiplicity(dof);
    });
  Utilities::MPI::sum(sums, communicator, sums);
  return sums;
}

/// Replaces the @p values of the cells of a ring by the absolute value of their mean. Equal error indicators
/// on each ring keep an axisymmetric mesh axisymmetric.
void average_over_rings(const CellNumbers &numbers, std::vector<double> &values)
{
  for (const std::vector<std::size_t> &ring : numbers.rings())
  {
    double sum = 0;
    for (const std::size_t cell : ring)
      sum += values[cell];
    for (const std::size_t cell : ring)
      values[cell] = std::abs(sum) / static_cast<double>(ring.size());
  }
}

double change_of_goal(const SolvedSolidContact &contact, const ContactGoal &goal, const TableLaw &law,
                      const ContactSolution &solution)
{
  const ContactLoad load = extract_load(law, solution, contact.state.load.n_harmonics(), goal.ring_radii);
  return goal.of_load(load) - goal.of_load(contact.state.load) +
         goal.of_moment.dot(load.moment() - contact.state.load.moment()) +
         goal.of_motion.dot(solution.motion - contact.state.solution.motion);
}

/// Returns the derivative of @p goal with respect to the nodal forces.
Eigen::VectorXd force_weights(const ContactGoal &goal, const ContactSurface &surface)
{
  return node_values(surface, goal.ring_radii, goal.of_load) +
         goal.of_moment(0) * surface.node_position.col(1) - goal.of_moment(1) * surface.node_position.col(0);
}

} // namespace

MeshError estimate_mesh_error(const SolvedSolidContact &contact, const ContactGoal &goal, bool with_cells)
{
  const DoFHandler<3> &dofs = contact.body.dofs();
  const unsigned int degree = dofs.get_fe().degree;
  std::vector<LevelElements> elements = levels_of(dofs.get_triangulation(), degree);
  const auto own = static_cast<unsigned int>(elements.size() - 1);
  for (const auto &mesh :
       enriched_meshes(dofs.get_triangulation(), contact.state.inner_radius, contact.state.outer_radius))
    elements.push_back({ mesh, degree });
  elements.push_back({ elements.back().mesh, degree + 1 });
  const ElasticMaterial &glass = contact.body.glass();
  const auto hierarchy =
    std::make_shared<MeshHierarchy>(elements, contact.straight_edges ? 1 : degree + 1, glass);
  const unsigned int finest = hierarchy->n_levels() - 1;
  SolidBody body(std::make_unique<BodyStiffness>(hierarchy, finest, glass), contact.gap);
  body.set_sliding(contact.sliding);
  const ContactSurface &surface = body.contact_surface();
  const Embedding embedding(*hierarchy, own);
  const DofVector embedded = embedding.embedded(contact.body.displacement_for_output());
  body.set_displacement(embedded);

  const std::unique_ptr<TableLaw> law = contact.interface.make(surface, 0);
  MeshError error;
  ContactControl control;
  control.requires_unchanged_set = false;
  control.resultant_tolerance = left_unbalanced;
  control.accepts_iterate = [&](const ContactSolution &found)
  {
    const double before = std::exchange(error.correction, change_of_goal(contact, goal, *law, found));
    return found.equilibrium_residual <= left_unbalanced &&
           std::abs(error.correction - before) <= last_change * std::abs(error.correction);
  };
  const ContactStart start = { contact.state.solution.motion,
                               body.contact_displacement() +
                                 surface.motion_modes() * contact.state.solution.motion };
  const double radius = surface.parts.max_entry(surface.node_position.rowwise().norm());
  const ContactSolution solution =
    solve_contact(body, *law, conditions_of(surface, contact.state.demand), radius, control, &start);
  if (!with_cells)
    return error;

  ContactForces pressed;
  law->evaluate(solution.normal_displacement, pressed);
  const Eigen::VectorXd pressed_goal = pressed.tangent * force_weights(goal, surface);
  const DofVector dual = body.solve_symmetric(
    pressed.tangent, pressed_goal,
    surface.parts.sum(surface.motion_modes().transpose() * pressed_goal) - goal.of_motion, dual_tolerance);
  // The law's forces at the interpolated displacement would be wrong, because the stiff spring amplifies the
  // interpolation error. The residual therefore uses the forces of the new solution.
  body.set_displacement(embedded);
  DofVector products = dual;
  products -= embedding.interpolated(dual);
  products.scale(body.residual(pressed.forces));
  hierarchy->level(finest).constraints.set_zero(products);
  const CellNumbers numbers(dofs.get_triangulation());
  error.cells = sums_over_cells(hierarchy->level(finest), products, numbers);
  average_over_rings(numbers, error.cells);
  return error;
}

} // namespace stemware::fem
