#pragma once

#include "fem/contact/elastic_body.h"
#include "fem/contact/sliding_traction.h"
#include "fem/solid/solid_body.h"
#include "fem/solid/solid_contact_zone.h"

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/mapping.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <Eigen/LU>

#include <iosfwd>

namespace stemware::fem
{

/// The finite-element equations of a SolidBody and their solution: deal.II's side of it, kept out of its
/// header. The virtual functions are those of ElasticBody.
class SolidSystem
{
public:
  virtual ~SolidSystem() = default;

  virtual const dealii::DoFHandler<3> &dofs() const = 0;
  virtual const dealii::Mapping<3> &mapping() const = 0;

  virtual Eigen::VectorXd contact_displacement() const = 0;
  virtual NewtonIncrement solve(const Eigen::SparseMatrix<double> &tangent, const Eigen::VectorXd &forces,
                                const LinearConditions &conditions, const Eigen::Vector3d &motion) = 0;
  virtual void update(double step_length) = 0;
  virtual void reset() = 0;
  virtual double equilibrium_residual(const Eigen::VectorXd &forces) const = 0;

  /// SolidOptions::linear_tolerance from now on; without effect on a factorisation.
  virtual void set_linear_tolerance(double /*tolerance*/) {}

  /// All that the next solve depends on, of this rank, in binary.
  virtual void write_state(std::ostream &stream) const = 0;
  virtual void read_state(std::istream &stream) = 0;

  /// The displacement with the values of all cells that this rank owns or sees.
  virtual dealii::LinearAlgebra::distributed::Vector<double> displacement_for_output() const = 0;

  /// Friction along @p traction deforms the body from now on.
  void set_sliding(const SlidingTraction &traction);

  const SolidContactZone &contact_zone() const { return zone; }
  const ElasticMaterial &glass() const { return material; }

protected:
  SolidSystem(const ElasticMaterial &material)
      : material(material)
  {
  }

  const ElasticMaterial material;
  SolidContactZone zone;
  bool has_friction = false;
  /// Friction (x, y) at the contact nodes per normal force there, where there is any: a force on the foot,
  /// shape [n_nodes, 2].
  Eigen::MatrixX2d friction;
};

/// Table motions counted so that all unknowns are lengths and all residuals forces: tilts as heights at the
/// rim.
struct ScaledMotions
{
  explicit ScaledMotions(const ContactSurface &surface);
  Eigen::Vector3d scale;  ///< of q0, q1, q2: 1, 1/m, 1/m
  Eigen::MatrixX3d modes; ///< Q, its columns scaled
};

/// NewtonIncrement::steadiness from what is set against motions, @p resistance, and the weight's part H of
/// it, @p leaning.
inline double steadiness_of(const Eigen::Matrix3d &resistance, const Eigen::Matrix3d &leaning)
{
  return leaning.isZero(0) ? 1 : resistance.determinant() / (resistance + leaning).determinant();
}

} // namespace stemware::fem
