#include "fem/solid/solid_body.h"

#include "fem/solid/factorized_stiffness.h"
#include "fem/solid/multigrid_stiffness.h"
#include "fem/solid/solid_system.h"

#include <cmath>
#include <stdexcept>

namespace stemware::fem
{

using namespace dealii;

namespace
{

void require_degree(unsigned int degree)
{
  if (degree != 1 && degree != 2)
    throw std::invalid_argument("Degree = " + std::to_string(degree) +
                                " is not allowed for a solid body; give 1 or 2.");
}

/// Whether a body is solved by multigrid, without a matrix.
bool is_matrix_free(const Triangulation<3> &triangulation, const SolidOptions &options)
{
  if (options.linear_solver != LinearSolver::automatic)
    return options.linear_solver == LinearSolver::multigrid;
  // A cell of degree p has p^3 nodes of its own in the middle of a mesh.
  const double n_unknowns = 3. * std::pow(options.degree, 3) * double(triangulation.n_global_active_cells());
  return triangulation.n_global_levels() > 1 || n_unknowns > largest_direct_system;
}

std::unique_ptr<BodyStiffness> stiffness_of(const Triangulation<3> &triangulation,
                                            const ElasticMaterial &material, const SolidOptions &options)
{
  require_degree(options.degree);
  material.validate();
  const unsigned int mapping_degree = options.straight_edges ? 1 : options.degree;
  if (!is_matrix_free(triangulation, options))
    return std::make_unique<FactorizedStiffness>(triangulation, options.degree, mapping_degree, material);
  const auto hierarchy =
    std::make_shared<MeshHierarchy>(levels_of(triangulation, options.degree), mapping_degree, material);
  return std::make_unique<MultigridStiffness>(hierarchy, hierarchy->n_levels() - 1, material);
}

} // namespace

SolidBody::SolidBody(Triangulation<3> &triangulation, const ElasticMaterial &material, const Gap &gap,
                     const SolidOptions &options, const SolidBody *similar)
    : gap(gap)
{
  std::unique_ptr<BodyStiffness> stiffness = similar ? similar->system->shared_stiffness() : nullptr;
  if (!stiffness)
    stiffness = stiffness_of(triangulation, material, options);
  system = std::make_unique<SolidSystem>(std::move(stiffness), material, gap, options.linear_tolerance);
}

SolidBody::SolidBody(std::unique_ptr<SolidSystem> equations, Gap gap)
    : system(std::move(equations))
    , gap(std::move(gap))
{
}

SolidBody::~SolidBody() = default;

bool SolidBody::has_hierarchy() const
{
  return system->has_coarser_meshes();
}

bool SolidBody::is_coarsest() const
{
  return !has_hierarchy() || system->is_coarsest();
}

std::unique_ptr<SolidBody> SolidBody::coarser() const
{
  if (is_coarsest())
    return nullptr;
  auto body = std::make_unique<SolidBody>(system->coarser(gap), gap);
  body->set_sliding(sliding);
  return body;
}

void SolidBody::start_from(const SolidBody &coarse)
{
  system->start_from(*coarse.system);
}

void SolidBody::set_sliding(const SlidingTraction &traction)
{
  traction.validate();
  sliding = traction;
  system->set_sliding(traction);
}

void SolidBody::set_linear_tolerance(double tolerance)
{
  system->set_linear_tolerance(tolerance);
}

void SolidBody::write_state(std::ostream &stream) const
{
  system->write_state(stream);
}

void SolidBody::read_state(std::istream &stream)
{
  system->read_state(stream);
}

const ContactSurface &SolidBody::contact_surface() const
{
  return system->contact_zone().surface;
}

Eigen::VectorXd SolidBody::contact_displacement() const
{
  return system->contact_displacement();
}

NewtonIncrement SolidBody::solve(const Eigen::SparseMatrix<double> &tangent, const Eigen::VectorXd &forces,
                                 const LinearConditions &conditions, const Eigen::Vector3d &motion)
{
  return system->solve(tangent, forces, conditions, motion);
}

void SolidBody::update(double step_length)
{
  system->update(step_length);
}

void SolidBody::reset()
{
  system->reset();
}

double SolidBody::equilibrium_residual(const Eigen::VectorXd &forces) const
{
  return system->equilibrium_residual(forces);
}

unsigned int SolidBody::n_unknowns() const
{
  return static_cast<unsigned int>(system->dofs().n_dofs());
}

double SolidBody::contact_cell_size() const
{
  return system->contact_zone().smallest_cell;
}

} // namespace stemware::fem
