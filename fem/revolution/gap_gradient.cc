#include "fem/revolution/gap_gradient.h"

#include "fem/contact/contact_solution.h"
#include "fem/revolution/line_newton.h"

#include <deal.II/lac/solver_control.h>
#include <deal.II/lac/solver_gmres.h>
#include <deal.II/lac/vector.h>

#include <algorithm>
#include <stdexcept>

namespace stemware::fem
{

namespace
{

using DualVector = dealii::Vector<double>;

/// The dual system in (s, nu), nu in units that make it as large as s.
class DualSystem
{
public:
  DualSystem(const BodyOfRevolution &body, const Eigen::SparseMatrix<double> &tangent,
             const LinearConditions &conditions, const Eigen::Vector3d &unit)
      : response(body.elastic_response())
      , tangent(tangent)
      , conditions(conditions)
      , motions(body.contact_surface().motion_modes())
      , unit(unit)
      , lengths(1, 1 / response.compliance().radii.tail<1>()(0), 1 / response.compliance().radii.tail<1>()(0))
  {
  }

  void vmult(DualVector &result, const DualVector &x) const
  {
    const Eigen::Map<const Eigen::VectorXd> s(x.begin(), n_forces());
    const Eigen::Vector3d nu = motions_of(x).cwiseProduct(unit);
    const Eigen::MatrixXd answer =
      response.transposed_displacement(s.reshaped(response.n_radii(), response.n_lines()));
    Eigen::Map<Eigen::VectorXd>(result.begin(), n_forces()) =
      s + tangent * (answer.reshaped() + conditions.weights() * nu);
    set_motions(result, motions.transpose() * s + conditions.motion_weights().transpose() * nu);
  }

  /// The right-hand side of the rows Q's + H'nu = @p values.
  void set_motions(DualVector &x, const Eigen::Vector3d &values) const
  {
    Eigen::Map<Eigen::Vector3d>(x.begin() + n_forces()) = values.cwiseProduct(lengths);
  }
  Eigen::Vector3d row_values(const DualVector &x) const { return motions_of(x).cwiseQuotient(lengths); }
  Eigen::Vector3d dual_motion(const DualVector &x) const { return motions_of(x).cwiseProduct(unit); }
  Eigen::Index n_forces() const { return tangent.rows(); }

private:
  Eigen::Vector3d motions_of(const DualVector &x) const
  {
    return Eigen::Map<const Eigen::Vector3d>(x.begin() + n_forces());
  }

  const ElasticResponse &response;
  const Eigen::SparseMatrix<double> &tangent;
  const LinearConditions &conditions;
  const Eigen::MatrixX3d motions;
  const Eigen::Vector3d unit;
  const Eigen::Vector3d lengths;
};

/// The symmetric system: no friction in the foot, and resultants for conditions.
class FrictionlessStep
{
public:
  FrictionlessStep(const BodyOfRevolution &body, const Eigen::SparseMatrix<double> &tangent,
                   const DualSystem &system, const Eigen::Vector3d &unit)
      : response(body.contact_compliance(), body.elastic_response().n_lines())
      , resultants(prescribed_resultants(body.contact_surface(), { 1, 0, 0 }))
      , tangent(tangent)
      , system(system)
      , unit(unit)
  {
  }

  void vmult(DualVector &result, const DualVector &x) const
  {
    const Eigen::Index n = system.n_forces();
    const Eigen::MatrixXd rhs =
      Eigen::Map<const Eigen::MatrixXd>(x.begin(), response.n_radii(), response.n_lines());
    LineNewton::Functions functions;
    const LineNewton newton(response, tangent, rhs, functions);
    const LineNewton::Increment found = newton.solve(resultants, -system.row_values(x));
    Eigen::Map<Eigen::VectorXd>(result.begin(), n) = found.forces.reshaped();
    Eigen::Map<Eigen::Vector3d>(result.begin() + n) = found.motion.cwiseQuotient(unit);
  }

private:
  const ElasticResponse response;
  const LinearConditions resultants;
  const Eigen::SparseMatrix<double> &tangent;
  const DualSystem &system;
  const Eigen::Vector3d unit;
};

} // namespace

GapGradient gap_gradient(const BodyOfRevolution &body, const Eigen::SparseMatrix<double> &tangent,
                         const LinearConditions &conditions, const ForceFunction &function)
{
  constexpr double tolerance = 1e-10;
  constexpr unsigned int most_steps = 200;
  const double largest = std::max(function.of_forces.cwiseAbs().maxCoeff(), 1e-300);
  const double radius = body.contact_compliance().radii.tail<1>()(0);
  const Eigen::VectorXd pressed = tangent * function.of_forces;
  const Eigen::Vector3d unit =
    Eigen::Vector3d(1, 1 / radius, 1 / radius) * largest / std::max(pressed.norm(), 1e-300);
  const DualSystem system(body, tangent, conditions, unit);
  const FrictionlessStep step(body, tangent, system, unit);

  DualVector rhs(static_cast<unsigned int>(pressed.size() + 3)), solution(rhs.size()), first(rhs.size());
  Eigen::Map<Eigen::VectorXd>(rhs.begin(), pressed.size()) = pressed;
  system.set_motions(rhs, function.of_motion);
  step.vmult(first, rhs);
  dealii::SolverControl control(most_steps, tolerance * first.l2_norm());
  dealii::SolverGMRES<DualVector>::AdditionalData options;
  options.max_n_tmp_vectors = most_steps + 2;
  try
  {
    dealii::SolverGMRES<DualVector>(control, options).solve(system, solution, rhs, step);
  }
  catch (const dealii::SolverControl::NoConvergence &)
  {
    throw ContactFailure(ContactOutcome::linear_solver_failed,
                         "The dual problem of the contact does not converge.");
  }
  GapGradient gradient;
  gradient.of_gap = -Eigen::Map<const Eigen::MatrixXd>(solution.begin(), body.elastic_response().n_radii(),
                                                       body.elastic_response().n_lines());
  gradient.of_conditions = system.dual_motion(solution);
  return gradient;
}

} // namespace stemware::fem
