// Linear solve of one Newton step of a solid body (docs/method/solid_at_scale.md). K: stiffness of the body.
// B: maps displacements to the contact nodes. T: tangent of the contact forces. Q: table motions at the
// contact nodes. G: column block of the table motions in the bordered system. W: response of the body to G.
#include "fem/contact/contact_solution.h"
#include "fem/solid/solid_body.h"

#include <deal.II/base/mpi.h>
#include <deal.II/lac/solver_cg.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <sstream>
#include <utility>

namespace stemware::fem
{

using namespace dealii;

/// Table motions with tilts scaled to heights at the rim, so that all unknowns are lengths and all residuals
/// are forces.
struct ScaledMotions
{
  explicit ScaledMotions(const ContactSurface &surface)
      : modes(surface.motion_modes())
  {
    const double length = surface.parts.max_entry(modes.rightCols<2>().rowwise().norm());
    scale = { 1, 1 / length, 1 / length };
    modes = (modes * scale.asDiagonal()).eval();
  }

  Eigen::Vector3d scale;  ///< scale factors of q0, q1, q2
  Eigen::MatrixX3d modes; ///< Q with scaled columns
};

struct SolidIncrement
{
  using Vector = BodyStiffness::Vector;

  Vector body;                  ///< displacement increment du
  Vector image;                 ///< K du + B' T (B du + Q dq), friction included
  Eigen::VectorXd displacement; ///< B du: increment of the vertical displacements of the contact nodes
  Eigen::Vector3d motion;       ///< scaled table motions dq
  unsigned int n_iterations = 0;
  double stability_margin = 1; ///< NewtonIncrement::stability_margin, from the system without friction

  void add(double factor, const SolidIncrement &other)
  {
    body.add(factor, other.body);
    image.add(factor, other.image);
    displacement += factor * other.displacement;
    motion += factor * other.motion;
  }
};

namespace
{

/// Parameters of the Newton steps, tuned on feet with and without a mesh hierarchy.
struct StepNumbers
{
  /// Maximum number of conjugate-gradient iterations; usual meshes need 20 to 75.
  unsigned int max_iterations = 200;
  /// Maximum number of iterations of a solve with given forces. It is larger, because no later Newton step
  /// corrects the error. Distorted cells need about 250 iterations.
  unsigned int max_iterations_of_forces = 2000;

  /// Target residual relative to the forces: a fifth of the tolerance of Newton's method.
  double unbalanced_share = 2e-10;
  /// Largest allowed ratio of final to initial residual of a linear solve. A larger ratio needs more Newton
  /// steps and saves no linear iterations in total.
  double least_reduction = 1e-3;
  /// A step whose target is within this factor of the final target is solved to the final target, because a
  /// few iterations cost less than another step.
  double nearly_last = 30;

  /// Tolerances of W = (K + B' T B)^-1 G: loose in the preconditioner, tight in close_conditions().
  double loose_border = 0.02, tight_border = 1e-3;
  /// W is omitted if the Schur complement is at least this fraction of C = Q' T Q for every table motion.
  double small_border = 0.2;
  /// Growth factor of the table's stiffness above which the decision to omit W is made again.
  double much_stiffer = 4;
};
constexpr StepNumbers tuned = {};

using BodyVector = BodyStiffness::Vector;

/// Matrix of deal.II's solvers whose product with a vector is @p function(dst, src).
template <typename Function>
struct Multiplying
{
  const Function &function;
  void vmult(BodyVector &dst, const BodyVector &src) const { function(dst, src); }
};

/// Solves by conjugate gradients from the initial guess @p solution until the residual is at most @p target.
/// Operators are functions (dst, src). Returns the number of iterations. Throws ContactFailure after @p
/// max_iterations. Collective.
template <typename Operator, typename Preconditioner>
unsigned int conjugate_gradients(const Operator &multiply, const Preconditioner &precondition,
                                 const BodyVector &rhs, double target, BodyVector &solution,
                                 unsigned int max_iterations = tuned.max_iterations)
{
  SolverControl control(max_iterations, target, false, false);
  try
  {
    SolverCG<BodyVector>(control).solve(Multiplying<Operator>{ multiply }, solution, rhs,
                                        Multiplying<Preconditioner>{ precondition });
  }
  catch (const SolverControl::NoConvergence &failure)
  {
    std::ostringstream message;
    message << "conjugate gradients left a residual of " << failure.last_residual << " after "
            << failure.last_step << " iterations (wanted " << target << ", of " << rhs.l2_norm()
            << "); use a mesh with less distorted cells.";
    throw ContactFailure(ContactOutcome::linear_solver_failed, message.str());
  }
  return control.last_step();
}

} // namespace

/// Columns and corner that the table motions add to the system of one Newton step.
struct SolidBody::Border
{
  Eigen::MatrixX3d columns; ///< B G = T Q, with G = B' T Q; only the part of this rank
  Eigen::Matrix3d corner;   ///< C = Q' T Q
  Eigen::Matrix3d inverse_corner;
  /// Inverse of the Schur complement C - G' W - W' G + W' (K + B' T B) W, where W approximates
  /// (K + B' T B)^-1 G. The Schur complement is positive definite for any W.
  Eigen::Matrix3d inverse_schur;
};

/// Linear system of one Newton step without the unsymmetric terms of friction.
struct SolidBody::SymmetricStep
{
  const SolidBody &body;
  /// Conditions that close_conditions() fulfils after the solve; nullptr for prescribed resultants, which the
  /// projection fulfils.
  const LinearConditions *const moment_conditions;
  const ScaledMotions motions;
  const Border border;

  /// Returns the right-hand side for @p residual and for @p missing, the residual of the conditions.
  Vector projected(Vector residual, const Eigen::Vector3d &missing) const
  {
    body.contact.nodes().scatter_add(-border.columns * (border.inverse_corner * missing), residual);
    return residual;
  }

  /// Returns the decrease of the contact forces due to @p increment.
  Eigen::VectorXd forces_of(const SolidIncrement &increment) const
  {
    return body.contact.matrix() * (increment.displacement + motions.modes * increment.motion);
  }

  /// Multiplies by K + B' T B - G C^-1 G', from which the table motions are eliminated.
  void multiply(Vector &dst, const Vector &src) const
  {
    body.stiffness->vmult(dst, src);
    const ContactNodes &nodes = body.contact.nodes();
    const Eigen::VectorXd nodal = nodes.gather(src);
    const Eigen::Vector3d motion =
      border.inverse_corner * nodes.parts().sum(border.columns.transpose() * nodal);
    nodes.scatter_add(body.contact.matrix() * nodal - border.columns * motion, dst);
  }

  /// Multiplies by an approximate inverse of K + B' T B, plus W S^-1 W' with the Schur complement S of
  /// Border::inverse_schur.
  void precondition(Vector &dst, const Vector &src) const
  {
    body.stiffness->precondition(dst, src);
    if (!body.border_matters)
      return;
    const auto &w = body.eliminated_border;
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

  /// Returns the increment for the projected residual @p rhs, solved to the residual @p target.
  SolidIncrement solve(const Vector &rhs, const Eigen::Vector3d &missing, double target) const
  {
    const ContactNodes &nodes = body.contact.nodes();
    SolidIncrement solution;
    body.stiffness->initialize(solution.body);
    if (rhs.l2_norm() > target)
      solution.n_iterations = conjugate_gradients(
        [this](Vector &dst, const Vector &src) { multiply(dst, src); },
        [this](Vector &dst, const Vector &src) { precondition(dst, src); }, rhs, target, solution.body);
    solution.displacement = nodes.gather(solution.body);
    solution.motion = border.inverse_corner *
                      (missing - nodes.parts().sum(border.columns.transpose() * solution.displacement));
    if (moment_conditions)
      body.close_conditions(*moment_conditions, motions, missing, solution);
    body.stiffness->initialize(solution.image);
    body.stiffness->vmult(solution.image, solution.body);
    solution.image += body.contact_load(forces_of(solution));
    return solution;
  }

  /// Corrects @p increment for friction, which makes Newton's matrix unsymmetric. On entry, @p increment
  /// solves the system with the symmetric part of the matrix. Generalised conjugate residuals (Eisenstat,
  /// Elman, Schultz, SIAM J. Numer. Anal. 20 (1983) 345) reduce @p residual to @p target. The resultants
  /// stay.
  void correct_for_friction(SolidIncrement &increment, Vector residual, double target) const
  {
    constexpr unsigned int max_corrections = 12;
    // Residual reduction per correction; friction is a small part of the matrix.
    constexpr double reduction = 0.05;
    std::vector<SolidIncrement> before;
    for (double norm = residual.l2_norm(); norm > target && before.size() < max_corrections;
         norm = residual.l2_norm())
    {
      SolidIncrement next = solve(residual, Eigen::Vector3d::Zero(), std::max(reduction * norm, target / 2));
      increment.n_iterations += next.n_iterations;
      for (const auto &other : before)
        next.add(-(next.image * other.image) / other.image.norm_sqr(), other);
      const double share = (residual * next.image) / next.image.norm_sqr();
      increment.add(share, next);
      residual.add(-share, next.image);
      before.push_back(std::move(next));
    }
  }
};

SolidBody::Vector SolidBody::solve_symmetric(const Eigen::SparseMatrix<double> &tangent,
                                             const Eigen::VectorXd &nodal, const Eigen::Vector3d &on_motions,
                                             double reduction)
{
  const SymmetricStep step = begin_step(tangent, nullptr);
  const Eigen::Vector3d missing = step.motions.scale.asDiagonal() * on_motions;
  Vector load;
  stiffness->initialize(load);
  contact.nodes().scatter_add(nodal, load);
  const Vector rhs = step.projected(std::move(load), missing);
  return step.solve(rhs, missing, reduction * rhs.l2_norm()).body;
}

void SolidBody::set_forces(const Eigen::VectorXd &forces)
{
  stiffness->set_contact(Eigen::SparseMatrix<double>(zone.surface.n_nodes(), zone.surface.n_nodes()));
  const Vector load = contact_load(forces);
  Vector found;
  stiffness->initialize(found);
  conjugate_gradients([this](Vector &dst, const Vector &src) { stiffness->vmult(dst, src); },
                      [this](Vector &dst, const Vector &src) { stiffness->precondition(dst, src); }, load,
                      tuned.unbalanced_share * load.l2_norm(), found, tuned.max_iterations_of_forces);
  set_displacement(found);
}

SolidBody::Border SolidBody::make_border(const Eigen::MatrixX3d &modes, double tolerance)
{
  Border border;
  border.columns = contact.matrix() * modes;
  const SurfaceParts &parts = contact.nodes().parts();
  border.corner = parts.sum(modes.transpose() * border.columns);
  border.corner = ((border.corner + border.corner.transpose()) / 2).eval();
  border.inverse_corner = border.corner.inverse();
  const double table_stiffness = border.corner(0, 0);
  if (!border_matters && tolerance >= tuned.loose_border &&
      table_stiffness < tuned.much_stiffer * border_stiffness)
    return border;

  const auto multiply = [this](Vector &dst, const Vector &src) // by K + B' T B
  {
    stiffness->vmult(dst, src);
    contact.vmult_add(dst, src);
  };
  const auto precondition = [this](Vector &dst, const Vector &src) { stiffness->precondition(dst, src); };
  Vector column, image, residual, correction;
  for (Vector *vector : { &column, &image, &residual, &correction })
    stiffness->initialize(*vector);
  std::array<FloatVector, 3> images; // (K + B' T B) W
  Eigen::Matrix3d overlap;           // W' G
  for (unsigned int i = 0; i < 3; ++i)
  {
    column.copy_locally_owned_data_from(eliminated_border[i]);
    multiply(image, column);
    residual = 0;
    contact.nodes().scatter_add(border.columns.col(i), residual);
    const double target = tolerance * residual.l2_norm();
    residual -= image;
    if (residual.l2_norm() > target)
    {
      correction = 0;
      conjugate_gradients(multiply, precondition, residual, target, correction);
      column += correction;
      eliminated_border[i].copy_locally_owned_data_from(column);
      multiply(image, column);
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
  border_stiffness = table_stiffness;
  return border;
}

double SolidBody::target_residual(double residual, double force)
{
  if (linear_tolerance > 0)
    return linear_tolerance * residual;
  // Newton's method converges quadratically, so the target reduction is the square of the last reduction.
  const double ratio = residual_before > 0 ? residual / residual_before : 0.1;
  residual_before = residual;
  const double target = std::min(tuned.least_reduction, ratio * ratio) * residual;
  const double last_target = tuned.unbalanced_share * force;
  return target < tuned.nearly_last * last_target ? last_target : target;
}

SolidBody::SymmetricStep SolidBody::begin_step(const Eigen::SparseMatrix<double> &tangent,
                                               const LinearConditions *moment_conditions)
{
  increment.reinit(0);
  increment_forces.reinit(0);
  contact.set(tangent);
  stiffness->set_contact(tangent);
  const ScaledMotions motions(zone.surface);
  return { *this, moment_conditions, motions,
           make_border(motions.modes, moment_conditions ? tuned.tight_border : tuned.loose_border) };
}

NewtonIncrement SolidBody::solve(const Eigen::SparseMatrix<double> &tangent, const Eigen::VectorXd &forces,
                                 const LinearConditions &conditions, const Eigen::Vector3d &motion)
{
  const SymmetricStep step = begin_step(tangent, conditions.are_resultants() ? nullptr : &conditions);

  // Vectors of the whole body dominate the memory, so each vector is released right after its last use.
  const Eigen::Vector3d missing = step.motions.scale.asDiagonal() * conditions.residual(forces, motion);
  double target = 0;
  SolidIncrement solution = [&]
  {
    const Vector rhs = step.projected(residual(forces), missing);
    target = target_residual(rhs.l2_norm(), contact.nodes().norm(forces));
    return step.solve(rhs, missing, target);
  }();

  if (has_friction())
  {
    Vector left = residual(forces);
    left -= solution.image;
    step.correct_for_friction(solution, std::move(left), 2 * target);
  }

  // The slope of the energy below includes the work of friction, because residual() includes friction.
  const Eigen::VectorXd change = step.forces_of(solution);
  const SurfaceParts &parts = contact.nodes().parts();
  NewtonIncrement result;
  result.linear_iterations = solution.n_iterations;
  result.stability_margin = solution.stability_margin;
  result.displacement = solution.displacement;
  result.motion = step.motions.scale.asDiagonal() * solution.motion;
  result.energy_curvature = solution.image * solution.body - parts.sum(change.dot(result.displacement));
  result.energy_slope = parts.sum(forces.dot(result.displacement)) - residual(forces) * solution.body;

  increment.swap(solution.body);
  increment_forces.swap(solution.image);
  increment_forces -= contact_load(change);
  return result;
}

void SolidBody::close_conditions(const LinearConditions &conditions, const ScaledMotions &motions,
                                 const Eigen::Vector3d &missing, SolidIncrement &solution) const
{
  // Adding (-W q, q) preserves the equilibrium of the body for any table motion q. With q = `further`, the
  // forces fulfil the conditions.
  Eigen::MatrixX3d response(motions.modes);
  for (unsigned int i = 0; i < 3; ++i)
    response.col(i) -= contact.nodes().gather(eliminated_border[i]);
  const Eigen::MatrixX3d weights = conditions.weights() * motions.scale.asDiagonal();
  const Eigen::Matrix3d leaning =
    motions.scale.asDiagonal() * conditions.motion_weights() * motions.scale.asDiagonal();
  const SurfaceParts &parts = contact.nodes().parts();
  const Eigen::Matrix3d matrix = parts.sum(weights.transpose() * (contact.matrix() * response)) - leaning;
  const Eigen::Vector3d remaining =
    missing -
    parts.sum(weights.transpose() *
              (contact.matrix() * (solution.displacement + motions.modes * solution.motion))) +
    leaning * solution.motion;
  const Eigen::FullPivLU<Eigen::Matrix3d> factors(matrix);
  if (!factors.isInvertible())
    throw ContactFailure(ContactOutcome::linear_solver_failed,
                         "the conditions on the contact forces do not determine the table's motions.");
  const Eigen::Vector3d further = factors.solve(remaining);
  if (!leaning.isZero(0))
    solution.stability_margin = matrix.determinant() / (matrix + leaning).determinant();
  solution.motion += further;
  solution.displacement += (response - motions.modes) * further;
  for (unsigned int i = 0; i < solution.body.locally_owned_size(); ++i)
    for (unsigned int k = 0; k < 3; ++k)
      solution.body.local_element(i) -= further(k) * double(eliminated_border[k].local_element(i));
}

} // namespace stemware::fem
