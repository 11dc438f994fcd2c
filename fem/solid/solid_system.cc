#include "fem/solid/solid_system.h"

#include "fem/contact/contact_solution.h"
#include "fem/solid/binary_stream.h"
#include "fem/solid/conjugate_gradients.h"
#include "fem/solid/friction_corrections.h"

#include <deal.II/base/mpi.h>
#include <deal.II/dofs/dof_tools.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include <cmath>
#include <utility>

namespace stemware::fem
{

using namespace dealii;

namespace
{

/// Numbers of the Newton steps of a solid body that were tuned on feet with and without a hierarchy.
struct StepNumbers
{
  unsigned int most_iterations = 200; ///< of conjugate gradients, which take 20 to 75 on meshes of use

  /// Share of the forces that Newton's method may leave unbalanced: a fifth of what its stopping rule allows.
  double unbalanced_share = 2e-10;
  /// Largest share of the residual that a linear solve may leave: with a larger one, Newton's method takes
  /// more steps and no fewer iterations.
  double least_reduction = 1e-3;
  /// A Newton step that would come this close to the last target is solved as far as that: a few iterations
  /// more are less than another step.
  double nearly_last = 30;

  /// How well W has to solve its equations where it only helps to precondition, and where the conditions on
  /// the forces are closed with it.
  double loose_border = 0.02, tight_border = 1e-3;
  /// W is left out where the V-cycle sees at least this share of what the table's motions change.
  double small_border = 0.2;
  /// Whether it is to be left out is asked again where the table is stiffer by this factor.
  double much_stiffer = 4;
};
constexpr StepNumbers tuned = {};

/// K + B' T B.
struct TangentOperator
{
  const BodyStiffness &body;
  const ContactStiffness &contact;
  void vmult(BodyStiffness::Vector &dst, const BodyStiffness::Vector &src) const
  {
    body.vmult(dst, src);
    contact.vmult_add(dst, src);
  }
};

/// Approximate inverse of a TangentOperator.
struct TangentPreconditioner
{
  const BodyStiffness &body;
  void vmult(BodyStiffness::Vector &dst, const BodyStiffness::Vector &src) const
  {
    body.precondition(dst, src);
  }
};

/// NewtonIncrement::steadiness from what is set against motions, @p resistance, and the weight's part H of
/// it, @p leaning.
double steadiness_of(const Eigen::Matrix3d &resistance, const Eigen::Matrix3d &leaning)
{
  return leaning.isZero(0) ? 1 : resistance.determinant() / (resistance + leaning).determinant();
}

} // namespace

/// Border of the system of one Newton step: the columns and the corner of the table's motions.
struct SolidSystem::Border
{
  Eigen::MatrixX3d columns; ///< B G = T Q, this rank's part of it
  Eigen::Matrix3d corner;   ///< C = Q' T Q
  Eigen::Matrix3d inverse_corner;
  Eigen::Matrix3d inverse_schur; ///< of C - G' W, in the form that is positive definite whatever W is
};

/// K + B' T B - G C^-1 G'.
struct SolidSystem::ProjectedOperator
{
  const SolidSystem &system;
  const Border &border;

  void vmult(Vector &dst, const Vector &src) const
  {
    system.body->vmult(dst, src);
    const ContactNodes &nodes = system.contact.nodes();
    const Eigen::VectorXd nodal = nodes.gather(src);
    const Eigen::Vector3d motion =
      border.inverse_corner * nodes.parts().sum(border.columns.transpose() * nodal);
    nodes.scatter_add(system.contact.matrix() * nodal - border.columns * motion, dst);
  }
};

/// The inverse of K + B' T B plus W S^-1 W'.
struct SolidSystem::ProjectedPreconditioner
{
  const SolidSystem &system;
  const Border &border;

  void vmult(Vector &dst, const Vector &src) const
  {
    system.body->precondition(dst, src);
    if (!system.border_matters)
      return;
    const auto &w = system.eliminated_border;
    double products[3] = {};
    for (unsigned int i = 0; i < src.locally_owned_size(); ++i)
      for (unsigned int k = 0; k < 3; ++k)
        products[k] += double(w[k].local_element(i)) * src.local_element(i);
    Utilities::MPI::sum(products, src.get_mpi_communicator(), products);
    const Eigen::Vector3d motion =
      border.inverse_schur * Eigen::Vector3d(products[0], products[1], products[2]);
    for (unsigned int i = 0; i < dst.locally_owned_size(); ++i)
      for (unsigned int k = 0; k < 3; ++k)
        dst.local_element(i) += motion(k) * double(w[k].local_element(i));
  }
};

/// The linear system of one Newton step without what friction makes unsymmetric in it.
struct SolidSystem::SymmetricStep
{
  const SolidSystem &system;
  const LinearConditions *const closed; ///< conditions that are closed with W; nothing for resultants
  const ScaledMotions motions;
  const Border border;

  /// @p residual as conjugate gradients see it, when the motions give the conditions what is @p missing.
  Vector projected(Vector residual, const Eigen::Vector3d &missing) const
  {
    system.contact.nodes().scatter_add(-border.columns * (border.inverse_corner * missing), residual);
    return residual;
  }

  /// Contact forces that @p of takes away.
  Eigen::VectorXd forces_of(const SolidIncrement &of) const
  {
    return system.contact.matrix() * (of.displacement + motions.modes * of.motion);
  }

  /// The increment for a projected residual, down to one of @p target.
  SolidIncrement solve(const Vector &rhs, const Eigen::Vector3d &missing, double target) const
  {
    const ContactNodes &nodes = system.contact.nodes();
    SolidIncrement solution;
    system.body->initialize(solution.body);
    if (rhs.l2_norm() > target)
      solution.n_iterations =
        conjugate_gradients(ProjectedOperator{ system, border }, ProjectedPreconditioner{ system, border },
                            rhs, target, tuned.most_iterations, solution.body);
    solution.displacement = nodes.gather(solution.body);
    solution.motion = border.inverse_corner *
                      (missing - nodes.parts().sum(border.columns.transpose() * solution.displacement));
    if (closed)
      system.close_conditions(*closed, motions, missing, solution);
    system.body->initialize(solution.image);
    system.body->vmult(solution.image, solution.body);
    solution.image += system.contact_load(forces_of(solution));
    return solution;
  }
};

ScaledMotions::ScaledMotions(const ContactSurface &surface)
    : modes(surface.motion_modes())
{
  const double length = surface.parts.greatest(modes.rightCols<2>().rowwise().norm());
  scale = { 1, 1 / length, 1 / length };
  modes = (modes * scale.asDiagonal()).eval();
}

SolidSystem::SolidSystem(std::unique_ptr<BodyStiffness> stiffness, const ElasticMaterial &material,
                         const SolidBody::Gap &gap, double linear_tolerance)
    : body(std::move(stiffness))
    , material(material)
    , linear_tolerance(linear_tolerance)
    , contact(body->contact_nodes())
    , zone(describe_contact_zone(mesh().mapping, mesh().dof_handler, mesh().constraints,
                                 body->contact_nodes(), gap))
    , horizontal(horizontal_places(mesh().dof_handler, contact.nodes()))
{
  for (Vector *vector : { &displacement, &elastic_forces })
    body->initialize(*vector);
  for (FloatVector &column : eliminated_border)
    column.reinit(displacement);
}

SolidSystem::~SolidSystem() = default;

std::unique_ptr<SolidSystem> SolidSystem::coarser(const SolidBody::Gap &gap) const
{
  if (body->is_coarsest())
    return nullptr;
  return std::make_unique<SolidSystem>(body->coarser(), material, gap, linear_tolerance);
}

void SolidSystem::set_sliding(const SlidingTraction &traction)
{
  has_friction = traction.friction_coefficient != 0;
  if (!has_friction)
    return;
  friction.resize(zone.surface.n_nodes(), 2);
  for (Eigen::Index i = 0; i < friction.rows(); ++i)
  {
    const double x = zone.surface.node_position(i, 0), y = zone.surface.node_position(i, 1);
    const double azimuth = std::atan2(y, x);
    const Eigen::Vector2d direction = traction.direction(std::hypot(x, y), azimuth);
    friction.row(i) = Eigen::Rotation2Dd(azimuth) * direction;
  }
}

SolidSystem::Vector SolidSystem::contact_load(const Eigen::VectorXd &forces) const
{
  Vector load;
  body->initialize(load);
  const Eigen::VectorXd own = contact.nodes().summed(forces);
  for (unsigned int i = 0; i < own.size(); ++i)
    load.local_element(contact.nodes().own_places()[i]) = own(i);
  if (has_friction)
    for (const auto &[node, x, y] : horizontal)
    {
      load.local_element(x) += friction(node, 0) * own(node);
      load.local_element(y) += friction(node, 1) * own(node);
    }
  return load;
}

void SolidSystem::start_from(const SolidSystem &coarse)
{
  body->prolongate(displacement, coarse.displacement);
  body->vmult(elastic_forces, displacement);
  residual_before = 0;
  border_matters = coarse.border_matters;
  border_stiffness = coarse.border_stiffness;
  if (border_matters)
    for (unsigned int i = 0; i < 3; ++i)
      body->prolongate(eliminated_border[i], coarse.eliminated_border[i]);
}

void SolidSystem::set_displacement(const Vector &vector)
{
  displacement.copy_locally_owned_data_from(vector);
  body->vmult(elastic_forces, displacement);
  residual_before = 0;
}

SolidSystem::Vector SolidSystem::residual(const Eigen::VectorXd &forces) const
{
  Vector result = contact_load(forces);
  result -= elastic_forces;
  return result;
}

SolidSystem::Vector SolidSystem::solve_symmetric(const Eigen::SparseMatrix<double> &tangent,
                                                 const Eigen::VectorXd &nodal,
                                                 const Eigen::Vector3d &on_motions, double reduction)
{
  const SymmetricStep step = begin_step(tangent, nullptr);
  const Eigen::Vector3d missing = step.motions.scale.asDiagonal() * on_motions;
  Vector load;
  body->initialize(load);
  contact.nodes().scatter_add(nodal, load);
  const Vector rhs = step.projected(std::move(load), missing);
  return step.solve(rhs, missing, reduction * rhs.l2_norm()).body;
}

Eigen::VectorXd SolidSystem::contact_displacement() const
{
  return contact.nodes().gather(displacement);
}

SolidSystem::Border SolidSystem::make_border(const Eigen::MatrixX3d &modes, double tolerance)
{
  Border border;
  border.columns = contact.matrix() * modes;
  const SurfaceParts &parts = contact.nodes().parts();
  border.corner = parts.sum(modes.transpose() * border.columns);
  border.corner = ((border.corner + border.corner.transpose()) / 2).eval();
  border.inverse_corner = border.corner.inverse();
  const double stiffness = border.corner(0, 0);
  if (!border_matters && tolerance >= tuned.loose_border && stiffness < tuned.much_stiffer * border_stiffness)
    return border;

  const TangentOperator tangent{ *body, contact };
  const TangentPreconditioner preconditioner{ *body };
  Vector column, image, residual, correction;
  for (Vector *vector : { &column, &image, &residual, &correction })
    body->initialize(*vector);
  std::array<FloatVector, 3> images; // A W
  Eigen::Matrix3d overlap;           // W' G
  for (unsigned int i = 0; i < 3; ++i)
  {
    column.copy_locally_owned_data_from(eliminated_border[i]);
    tangent.vmult(image, column);
    residual = 0;
    contact.nodes().scatter_add(border.columns.col(i), residual);
    const double target = tolerance * residual.l2_norm();
    residual -= image;
    if (residual.l2_norm() > target)
    {
      correction = 0;
      conjugate_gradients(tangent, preconditioner, residual, target, tuned.most_iterations, correction);
      column += correction;
      eliminated_border[i].copy_locally_owned_data_from(column);
      tangent.vmult(image, column);
    }
    images[i].reinit(image, true);
    images[i].copy_locally_owned_data_from(image);
    overlap.row(i) = parts.sum(contact.nodes().gather(column).transpose() * border.columns);
  }
  Eigen::Matrix3d schur = border.corner - overlap - overlap.transpose();
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 3; ++j)
      schur(i, j) += eliminated_border[i] * images[j];
  schur = ((schur + schur.transpose()) / 2).eval();
  border.inverse_schur = schur.inverse();
  const double share =
    Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::Matrix3d>(schur, border.corner).eigenvalues().minCoeff();
  border_matters = share < tuned.small_border;
  border_stiffness = stiffness;
  return border;
}

double SolidSystem::target_residual(double residual, double force)
{
  if (linear_tolerance > 0)
    return linear_tolerance * residual;
  // As exact as the step before was good: what a Newton step cannot keep is not worth solving for.
  const double ratio = residual_before > 0 ? residual / residual_before : 0.1;
  residual_before = residual;
  const double target = std::min(tuned.least_reduction, ratio * ratio) * residual;
  const double last_target = tuned.unbalanced_share * force;
  return target < tuned.nearly_last * last_target ? last_target : target;
}

SolidSystem::SymmetricStep SolidSystem::begin_step(const Eigen::SparseMatrix<double> &tangent,
                                                   const LinearConditions *closed)
{
  forget_increment();
  contact.set(tangent);
  body->set_contact(tangent);
  const ScaledMotions motions(zone.surface);
  return { *this, closed, motions,
           make_border(motions.modes, closed ? tuned.tight_border : tuned.loose_border) };
}

NewtonIncrement SolidSystem::solve(const Eigen::SparseMatrix<double> &tangent, const Eigen::VectorXd &forces,
                                   const LinearConditions &conditions, const Eigen::Vector3d &motion)
{
  const SymmetricStep step = begin_step(tangent, conditions.are_resultants() ? nullptr : &conditions);

  // 1. The symmetric part, for the whole residual. Vectors of the whole body are most of the memory: none
  // stays that is not needed in the next line.
  const Eigen::Vector3d missing = step.motions.scale.asDiagonal() * conditions.residual(forces, motion);
  double target = 0;
  SolidIncrement solution = [&]
  {
    const Vector rhs = step.projected(residual(forces), missing);
    target = target_residual(rhs.l2_norm(), contact.nodes().norm(forces));
    return step.solve(rhs, missing, target);
  }();

  // 2. What friction leaves.
  if (has_friction)
  {
    Vector left = residual(forces);
    left -= solution.image;
    correct_for_friction(solution, std::move(left), 2 * target,
                         [&](const Vector &of, double to)
                         { return step.solve(of, Eigen::Vector3d::Zero(), to); });
  }
  body->learn(solution.n_iterations);

  // 3. What Newton's method is told of the increment. The work of friction, which changes with the forces,
  // belongs to the body's.
  const Eigen::VectorXd change = step.forces_of(solution);
  const SurfaceParts &parts = contact.nodes().parts();
  NewtonIncrement result;
  result.linear_iterations = solution.n_iterations;
  result.steadiness = solution.steadiness;
  result.displacement = solution.displacement;
  result.motion = step.motions.scale.asDiagonal() * solution.motion;
  result.energy_curvature = solution.image * solution.body - parts.sum(change.dot(result.displacement));
  result.energy_slope = parts.sum(forces.dot(result.displacement)) - residual(forces) * solution.body;

  // 4. The increment itself stays here, for update().
  increment.swap(solution.body);
  increment_forces.swap(solution.image);
  increment_forces -= contact_load(change);
  return result;
}

void SolidSystem::forget_increment()
{
  increment.reinit(0);
  increment_forces.reinit(0);
}

void SolidSystem::close_conditions(const LinearConditions &conditions, const ScaledMotions &motions,
                                   const Eigen::Vector3d &missing, SolidIncrement &solution) const
{
  // Of all the solutions that the body can have, (u - W q, q) more, the one whose forces fulfil L.
  Eigen::MatrixX3d response(motions.modes);
  for (unsigned int i = 0; i < 3; ++i)
    response.col(i) -= contact.nodes().gather(eliminated_border[i]);
  const Eigen::MatrixX3d weights = conditions.weights() * motions.scale.asDiagonal();
  const Eigen::Matrix3d leaning =
    motions.scale.asDiagonal() * conditions.motion_weights() * motions.scale.asDiagonal();
  const SurfaceParts &parts = contact.nodes().parts();
  const Eigen::Matrix3d matrix = parts.sum(weights.transpose() * (contact.matrix() * response)) - leaning;
  const Eigen::Vector3d left =
    missing -
    parts.sum(weights.transpose() *
              (contact.matrix() * (solution.displacement + motions.modes * solution.motion))) +
    leaning * solution.motion;
  const Eigen::FullPivLU<Eigen::Matrix3d> factors(matrix);
  if (!factors.isInvertible())
    throw ContactFailure(ContactOutcome::linear_solver_failed,
                         "the conditions on the contact forces do not determine the table's motions.");
  const Eigen::Vector3d further = factors.solve(left);
  solution.steadiness = steadiness_of(matrix, leaning);
  solution.motion += further;
  solution.displacement += (response - motions.modes) * further;
  for (unsigned int i = 0; i < solution.body.locally_owned_size(); ++i)
    for (unsigned int k = 0; k < 3; ++k)
      solution.body.local_element(i) -= further(k) * double(eliminated_border[k].local_element(i));
}

void SolidSystem::update(double step_length)
{
  displacement.add(step_length, increment);
  elastic_forces.add(step_length, increment_forces);
}

void SolidSystem::reset()
{
  displacement = 0;
  elastic_forces = 0;
  residual_before = 0;
}

double SolidSystem::equilibrium_residual(const Eigen::VectorXd &forces) const
{
  return residual(forces).l2_norm() / contact.nodes().norm(forces);
}

void SolidSystem::write_state(std::ostream &stream) const
{
  for (const Vector *vector : { &displacement, &elastic_forces })
    write_binary(stream, vector->begin(), vector->locally_owned_size());
  for (const FloatVector &column : eliminated_border)
    write_binary(stream, column.begin(), column.locally_owned_size());
  write_binary(stream, &residual_before, 1);
  write_binary(stream, &border_matters, 1);
  write_binary(stream, &border_stiffness, 1);
}

void SolidSystem::read_state(std::istream &stream)
{
  for (Vector *vector : { &displacement, &elastic_forces })
    read_binary(stream, vector->begin(), vector->locally_owned_size());
  for (FloatVector &column : eliminated_border)
    read_binary(stream, column.begin(), column.locally_owned_size());
  read_binary(stream, &residual_before, 1);
  read_binary(stream, &border_matters, 1);
  read_binary(stream, &border_stiffness, 1);
}

LinearAlgebra::distributed::Vector<double> SolidSystem::displacement_for_output() const
{
  const IndexSet relevant = DoFTools::extract_locally_relevant_dofs(mesh().dof_handler);
  Vector result(mesh().dof_handler.locally_owned_dofs(), relevant, mesh().dof_handler.get_communicator());
  result.copy_locally_owned_data_from(displacement);
  mesh().constraints.distribute(result);
  result.update_ghost_values();
  return result;
}

} // namespace stemware::fem
