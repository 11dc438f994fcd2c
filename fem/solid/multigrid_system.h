#pragma once

#include "fem/solid/friction_corrections.h"
#include "fem/solid/mesh_hierarchy.h"
#include "fem/solid/solid_system.h"

#include <array>

namespace stemware::fem
{

/// The equations on one level of a MeshHierarchy, without a matrix: conjugate gradients in double precision,
/// preconditioned by V-cycles in single precision.
///
/// The table motions are eliminated before, so that every iterate fulfils the conditions on the forces to
/// rounding: with G = B' T Q and C = Q' T Q, conjugate gradients see K + B' T B - G C^-1 G'. The V-cycle does
/// not know the second part; W ~ (K + B' T B)^-1 G brings it in.
class MultigridSystem : public SolidSystem
{
public:
  MultigridSystem(std::shared_ptr<MeshHierarchy> hierarchy, unsigned int level,
                  const ElasticMaterial &material, const SolidBody::Gap &gap, double linear_tolerance);

  const dealii::DoFHandler<3> &dofs() const override { return mesh().dof_handler; }
  const dealii::Mapping<3> &mapping() const override { return mesh().mapping; }
  Eigen::VectorXd contact_displacement() const override;
  NewtonIncrement solve(const Eigen::SparseMatrix<double> &tangent, const Eigen::VectorXd &forces,
                        const LinearConditions &conditions, const Eigen::Vector3d &motion) override;
  void update(double step_length) override;
  void reset() override;
  double equilibrium_residual(const Eigen::VectorXd &forces) const override;
  void set_linear_tolerance(double tolerance) override { linear_tolerance = tolerance; }
  void write_state(std::ostream &stream) const override;
  void read_state(std::istream &stream) override;
  dealii::LinearAlgebra::distributed::Vector<double> displacement_for_output() const override;

  bool has_several_meshes() const { return hierarchy->coarsest_mesh() + 1 < hierarchy->n_levels(); }
  bool is_coarsest() const { return level == hierarchy->coarsest_mesh(); }
  /// The same foot on the next coarser mesh of the hierarchy; not to be asked of the coarsest.
  std::unique_ptr<MultigridSystem> coarser(const SolidBody::Gap &gap) const;
  /// Takes over the displacement of coarser().
  void start_from(const MultigridSystem &coarse);

  void set_displacement(const dealii::LinearAlgebra::distributed::Vector<double> &vector);
  /// The load of nodal @p forces, with the friction that they bring along, less K u.
  dealii::LinearAlgebra::distributed::Vector<double> residual(const Eigen::VectorXd &forces) const;
  /// x of [K + B'TB, B'TQ; Q'TB, Q'TQ] [x; q] = [B' @p nodal; @p on_motions], T the @p tangent, to @p
  /// reduction of the residual. The increment of the last solve() is gone then. Throws as solve().
  dealii::LinearAlgebra::distributed::Vector<double>
  solve_symmetric(const Eigen::SparseMatrix<double> &tangent, const Eigen::VectorXd &nodal,
                  const Eigen::Vector3d &on_motions, double reduction);

private:
  using Vector = MeshHierarchy::Vector;
  using FloatVector = dealii::LinearAlgebra::distributed::Vector<float>;
  struct Border;
  class ProjectedOperator;
  class ProjectedPreconditioner;

  const SolidLevel &mesh() const { return hierarchy->level(level); }
  /// B' @p forces with the friction that they bring along.
  Vector contact_load(const Eigen::VectorXd &forces) const;
  /// The border of the present contact stiffness; W solves its equations to @p tolerance.
  Border make_border(const Eigen::MatrixX3d &modes, double tolerance);
  /// The residual [N] down to which a system that starts from @p residual is worth solving under contact
  /// forces of norm @p force.
  double target_residual(double residual, double force);
  /// Gives the memory of the last increment back.
  void forget_increment();
  /// Changes a solution under prescribed resultants into one under @p conditions.
  void close_conditions(const LinearConditions &conditions, const ScaledMotions &motions,
                        const Eigen::Vector3d &missing, SolidIncrement<Vector> &solution) const;

  const std::shared_ptr<MeshHierarchy> hierarchy;
  const unsigned int level;
  double linear_tolerance;
  const std::unique_ptr<ElasticOperator<double>> elastic;
  ContactStiffness contact;
  const std::vector<HorizontalPlaces> horizontal;

  Vector displacement;
  Vector elastic_forces;                        ///< K u
  Vector increment;                             ///< of the last solve
  Vector increment_forces;                      ///< K du
  std::array<FloatVector, 3> eliminated_border; ///< W of the last solve that needed it
  bool border_matters = true;                   ///< whether W improves on the V-cycle
  double border_stiffness = 0;                  ///< of the table when that was found [N/m]
  double residual_before = 0;                   ///< of the last solve [N]; 0: none
};

} // namespace stemware::fem
