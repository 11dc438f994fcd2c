#pragma once

#include "fem/contact/elastic_body.h"
#include "fem/contact/sliding_traction.h"
#include "fem/solid/mesh_hierarchy.h"
#include "fem/solid/solid_contact_zone.h"
#include "fem/solid/solid_options.h"

#include <array>
#include <string>

namespace stemware::fem
{

struct FieldFile;
struct ScaledMotions;
struct SolidIncrement;

/// Three-dimensional elastic foot: hexahedra of degree 1 or 2, distributed over MPI ranks.
///
/// The table motions are eliminated: with G = B' T Q and C = Q' T Q, conjugate gradients act on K + B' T B -
/// G C^-1 G', so that every iterate fulfils prescribed resultants to rounding. The preconditioner is the
/// approximate inverse of BodyStiffness, corrected by W ~ (K + B' T B)^-1 G for the last term. Other
/// conditions are fulfilled at the end by a table motion and its response W.
class SolidBody : public ElasticBody
{
public:
  using Vector = BodyStiffness::Vector;

  /// Sets up a body clamped at FootBoundary::stem_cut, @p gap above the table. @p triangulation, serial or
  /// distributed, must outlive the body. Throws std::invalid_argument without a stem cut or contact zone. @p
  /// similar: body of equal triangulation, material and elements, solved alternately with this one, with
  /// which it shares multigrid data.
  SolidBody(const dealii::Triangulation<3> &triangulation, const ElasticMaterial &material,
            const SolidGap &gap, const SolidOptions &options = {}, const SolidBody *similar = nullptr);
  /// Creates a body with the given stiffness; @p line_factor as in SolidOptions.
  SolidBody(std::unique_ptr<BodyStiffness> stiffness, const SolidGap &gap, unsigned int line_factor = 1);

  const ContactSurface &contact_surface() const override { return zone.surface; }
  Eigen::VectorXd contact_displacement() const override { return contact.nodes().gather(displacement); }
  NewtonIncrement solve(const Eigen::SparseMatrix<double> &tangent, const Eigen::VectorXd &forces,
                        const LinearConditions &conditions, const Eigen::Vector3d &motion) override;
  void update(double step_length) override;
  void reset() override;
  double equilibrium_residual(const Eigen::VectorXd &forces) const override;
  unsigned int n_unknowns() const { return static_cast<unsigned int>(dofs().n_dofs()); }

  const dealii::DoFHandler<3> &dofs() const { return mesh().dof_handler; }
  const SolidLevel &mesh() const { return stiffness->mesh(); }
  const ContactNodes &contact_nodes() const { return contact.nodes(); }
  const ElasticMaterial &glass() const { return stiffness->material; }
  /// Returns the smallest extent h of a contact cell [m]; E / h is the natural penalty of a rigid table.
  double contact_cell_size() const { return zone.smallest_cell; }

  /// Sets the friction that deforms the body, in the mesh's axes. Throws as SlidingTraction::validate().
  void set_sliding(const SlidingTraction &traction);
  /// Returns the friction force (x, y) per normal force, shape [n_nodes, 2]; empty without friction.
  Eigen::MatrixX2d friction_per_force() const { return has_friction() ? friction : Eigen::MatrixX2d(); }
  /// Sets the reduction of the residual by one linear solve; 0, the default: chosen for each Newton step.
  void set_linear_tolerance(double tolerance) { linear_tolerance = tolerance; }

  /// Returns whether multigrid has a coarser mesh.
  bool has_coarser_mesh() const { return stiffness->has_coarser_mesh(); }
  /// Returns this foot on the next coarser mesh, for cheap initial guesses; nullptr if there is none.
  std::unique_ptr<SolidBody> coarser() const;
  /// Interpolates the displacement of coarser() to this body.
  void interpolate_from(const SolidBody &coarse);

  /// Returns this rank's binary state, for set_state() on the same mesh and number of ranks.
  std::string state() const;
  void set_state(const std::string &bytes);

  void set_displacement(const Vector &vector);
  /// Sets the displacement under nodal @p forces [N] and their friction. Throws as solve().
  void set_forces(const Eigen::VectorXd &forces);
  /// Returns the displacement with ghost values.
  Vector displacement_for_output() const { return mesh().distributed(displacement); }
  /// Returns the load of nodal @p forces with their friction, minus K u.
  Vector residual(const Eigen::VectorXd &forces) const;
  /// Returns x of [K + B'TB, B'TQ; Q'TB, Q'TQ] [x; q] = [B' @p nodal; @p on_motions], T the @p tangent, with
  /// the residual reduced by @p reduction. Overwrites the increment of the last solve(). Throws as solve().
  Vector solve_symmetric(const Eigen::SparseMatrix<double> &tangent, const Eigen::VectorXd &nodal,
                         const Eigen::Vector3d &on_motions, double reduction);

  /// Returns this rank's VTU files: displacement [m] in the slip frame with the table at rest (@p motion is
  /// transferred to the glass), stress [Pa], contact pressure [Pa] of @p nodal_pressure.
  std::vector<FieldFile> fields(const Eigen::Vector3d &motion, const Eigen::VectorXd &nodal_pressure) const;

private:
  struct Border;
  struct SymmetricStep;

  bool has_friction() const { return sliding.friction_coefficient != 0; }
  /// Returns B' @p forces with the friction of these forces.
  Vector contact_load(const Eigen::VectorXd &forces) const;
  /// Sets @p tangent and starts a step. @p moment_conditions: nullptr under prescribed resultants.
  SymmetricStep begin_step(const Eigen::SparseMatrix<double> &tangent,
                           const LinearConditions *moment_conditions);
  /// Returns the border of the present contact stiffness with W solved to @p tolerance.
  Border make_border(const Eigen::MatrixX3d &modes, double tolerance);
  /// Returns the target residual [N] for the initial @p residual under contact forces of norm @p force.
  double target_residual(double residual, double force);
  /// Converts a solution under prescribed resultants to @p conditions.
  void close_conditions(const LinearConditions &conditions, const ScaledMotions &motions,
                        const Eigen::Vector3d &missing, SolidIncrement &solution) const;
  /// Calls @p use(data, size) for each array on which the next solve depends.
  template <typename Body, typename Use>
  static void for_each_state(Body &body, const Use &use);

  const std::unique_ptr<BodyStiffness> stiffness;
  const SolidGap gap;
  double linear_tolerance = 0;
  const unsigned int line_factor;
  ContactStiffness contact;
  const SolidContactZone zone;
  const std::vector<HorizontalPlaces> horizontal;
  SlidingTraction sliding;
  /// friction_per_force()
  Eigen::MatrixX2d friction;

  Vector displacement;
  Vector elastic_forces;                        ///< K u
  Vector increment;                             ///< increment of the last solve
  Vector increment_forces;                      ///< K du
  std::array<FloatVector, 3> eliminated_border; ///< W of the last solve that needed it
  bool border_matters = true;                   ///< whether W improves on the inverse of K + B' T B
  double border_stiffness = 0; ///< stiffness of the table when border_matters was determined [N/m]
  double residual_before = 0;  ///< residual before the last solve [N]; 0: none
};

} // namespace stemware::fem
