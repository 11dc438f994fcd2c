#pragma once

#include "fem/contact/elastic_body.h"

#include <Eigen/LU>

#include <utility>

namespace stemware::fem
{

/// Elastic body given by its compliance: the state is the nodal forces whose response is the displacement.
class CompliantBody : public ElasticBody
{
public:
  /// Sets the state to the displacement under nodal @p forces [N].
  void set_forces(const Eigen::VectorXd &forces)
  {
    state = forces;
    displacement = response_to(state);
  }

  Eigen::VectorXd contact_displacement() const override { return displacement; }
  void update(double step_length) override
  {
    state += step_length * increment;
    displacement += step_length * moved;
  }
  void reset() override { state = displacement = Eigen::VectorXd::Zero(contact_surface().n_nodes()); }
  Eigen::VectorXd elastic_forces(const Eigen::VectorXd &) const override { return state; }
  double equilibrium_residual(const Eigen::VectorXd &forces) const override
  {
    return (forces - state).norm() / forces.norm();
  }
  unsigned int n_unknowns() const { return static_cast<unsigned int>(state.size()) + 3; }

protected:
  /// Returns the displacement [m] under nodal @p forces [N].
  virtual Eigen::VectorXd response_to(const Eigen::VectorXd &forces) const = 0;

  /// Returns the step of the state by @p forces [N] and of the table by @p motion. @p resistance: derivative
  /// of @p conditions by the motions, without LinearConditions::motion_weights().
  NewtonIncrement step_by(Eigen::VectorXd forces, const Eigen::Vector3d &motion,
                          const Eigen::Matrix3d &resistance, const LinearConditions &conditions)
  {
    increment = std::move(forces);
    moved = response_to(increment);
    NewtonIncrement step;
    step.displacement = moved;
    step.motion = motion;
    step.energy_slope = moved.dot(state);
    step.energy_curvature = moved.dot(increment);
    step.stability_margin =
      (resistance - conditions.motion_weights()).determinant() / resistance.determinant();
    return step;
  }

  Eigen::VectorXd state;        ///< nodal forces [N]
  Eigen::VectorXd displacement; ///< their response [m]

private:
  Eigen::VectorXd increment, moved; ///< increments of state and displacement in the last solve()
};

} // namespace stemware::fem
