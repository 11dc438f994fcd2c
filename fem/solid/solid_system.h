#pragma once

#include "fem/contact/elastic_body.h"
#include "fem/contact/sliding_traction.h"
#include "fem/solid/body_stiffness.h"
#include "fem/solid/solid_body.h"
#include "fem/solid/solid_contact_zone.h"

#include <array>
#include <iosfwd>

namespace stemware::fem
{

struct SolidIncrement;

/// Table motions counted so that all unknowns are lengths and all residuals forces: tilts as heights at the
/// rim.
struct ScaledMotions
{
  explicit ScaledMotions(const ContactSurface &surface);
  Eigen::Vector3d scale;  ///< of q0, q1, q2: 1, 1/m, 1/m
  Eigen::MatrixX3d modes; ///< Q, its columns scaled
};

/// The finite-element equations of a SolidBody under three conditions on its contact forces, and their
/// solution: deal.II's side of it, kept out of its header. Functions that ElasticBody has too are explained
/// there.
///
/// The border of the equations, the table's motions, is eliminated before: with G = B' T Q and C = Q' T Q,
/// conjugate gradients see K + B' T B - G C^-1 G', so that every iterate fulfils the conditions on the forces
/// to rounding. The BodyStiffness inverts K + B' T B only, approximately; W ~ (K + B' T B)^-1 G brings in the
/// rest. Other conditions than resultants are fulfilled in the end, by a motion W that the body answers.
class SolidSystem
{
public:
  using Vector = BodyStiffness::Vector;

  /// @p linear_tolerance is SolidOptions::linear_tolerance.
  SolidSystem(std::unique_ptr<BodyStiffness> stiffness, const ElasticMaterial &material,
              const SolidBody::Gap &gap, double linear_tolerance);
  ~SolidSystem();

  const dealii::DoFHandler<3> &dofs() const { return mesh().dof_handler; }
  const dealii::Mapping<3> &mapping() const { return mesh().mapping; }
  const SolidContactZone &contact_zone() const { return zone; }
  const ElasticMaterial &glass() const { return material; }

  Eigen::VectorXd contact_displacement() const;
  NewtonIncrement solve(const Eigen::SparseMatrix<double> &tangent, const Eigen::VectorXd &forces,
                        const LinearConditions &conditions, const Eigen::Vector3d &motion);
  void update(double step_length);
  void reset();
  double equilibrium_residual(const Eigen::VectorXd &forces) const;

  /// SolidOptions::linear_tolerance from now on.
  void set_linear_tolerance(double tolerance) { linear_tolerance = tolerance; }
  /// Friction along @p traction deforms the body from now on.
  void set_sliding(const SlidingTraction &traction);

  /// BodyStiffness::shared() of this body.
  std::unique_ptr<BodyStiffness> shared_stiffness() const { return body->shared(); }
  bool has_coarser_meshes() const { return body->has_coarser_meshes(); }
  bool is_coarsest() const { return body->is_coarsest(); }
  /// The system on the next coarser of the meshes that its own was refined from; nothing on the coarsest.
  std::unique_ptr<SolidSystem> coarser(const SolidBody::Gap &gap) const;
  /// Takes over the displacement of coarser().
  void start_from(const SolidSystem &coarse);

  /// All that the next solve depends on, of this rank, in binary.
  void write_state(std::ostream &stream) const;
  void read_state(std::istream &stream);

  void set_displacement(const Vector &vector);
  /// The displacement with the values of all cells that this rank owns or sees.
  Vector displacement_for_output() const;
  /// The load of nodal @p forces, with the friction that they bring along, less K u.
  Vector residual(const Eigen::VectorXd &forces) const;
  /// x of [K + B'TB, B'TQ; Q'TB, Q'TQ] [x; q] = [B' @p nodal; @p on_motions], T the @p tangent, to @p
  /// reduction of the residual. The increment of the last solve() is gone then. Throws as solve().
  Vector solve_symmetric(const Eigen::SparseMatrix<double> &tangent, const Eigen::VectorXd &nodal,
                         const Eigen::Vector3d &on_motions, double reduction);

private:
  using FloatVector = BodyStiffness::FloatVector;
  struct Border;
  struct ProjectedOperator;
  struct ProjectedPreconditioner;
  struct SymmetricStep;

  const SolidLevel &mesh() const { return body->mesh(); }
  /// B' @p forces with the friction that they bring along.
  Vector contact_load(const Eigen::VectorXd &forces) const;
  /// Takes over @p tangent; @p closed: conditions other than resultants.
  SymmetricStep begin_step(const Eigen::SparseMatrix<double> &tangent, const LinearConditions *closed);
  /// The border of the present contact stiffness; W solves its equations to @p tolerance.
  Border make_border(const Eigen::MatrixX3d &modes, double tolerance);
  /// The residual [N] down to which a system that starts from @p residual is worth solving under contact
  /// forces of norm @p force.
  double target_residual(double residual, double force);
  /// Gives the memory of the last increment back.
  void forget_increment();
  /// Changes a solution under prescribed resultants into one under @p conditions.
  void close_conditions(const LinearConditions &conditions, const ScaledMotions &motions,
                        const Eigen::Vector3d &missing, SolidIncrement &solution) const;

  const std::unique_ptr<BodyStiffness> body;
  const ElasticMaterial material;
  double linear_tolerance;
  ContactStiffness contact;
  const SolidContactZone zone;
  const std::vector<HorizontalPlaces> horizontal;
  bool has_friction = false;
  /// Friction (x, y) at the contact nodes per normal force there, where there is any: a force on the foot,
  /// shape [n_nodes, 2].
  Eigen::MatrixX2d friction;

  Vector displacement;
  Vector elastic_forces;                        ///< K u
  Vector increment;                             ///< of the last solve
  Vector increment_forces;                      ///< K du
  std::array<FloatVector, 3> eliminated_border; ///< W of the last solve that needed it
  bool border_matters = true;                   ///< whether W improves on the inverse of K + B' T B
  double border_stiffness = 0;                  ///< of the table when that was found [N/m]
  double residual_before = 0;                   ///< of the last solve [N]; 0: none
};

} // namespace stemware::fem
