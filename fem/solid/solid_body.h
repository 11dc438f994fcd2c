#pragma once

#include "fem/contact/elastic_body.h"
#include "fem/contact/sliding_traction.h"
#include "fem/elasticity/elastic_material.h"
#include "fem/elasticity/linear_solver.h"

#include <functional>
#include <iosfwd>
#include <memory>
#include <vector>

namespace dealii
{
template <int dim, int spacedim>
class Triangulation;
}

namespace stemware::fem
{

/// Numerical parameters of a SolidBody.
struct SolidOptions
{
  unsigned int degree = 2; ///< polynomial degree of elements and of their geometry: 1 or 2
  LinearSolver linear_solver = LinearSolver::automatic;
  bool straight_edges = false; ///< geometry of degree 1 whatever the element (meshes without a round rim)
  /// Reduction of the residual by one linear solve; 0: as far as Newton's next step can use it.
  double linear_tolerance = 0;
};

class SolidSystem;
struct FieldFile;

/// Three-dimensional elastic foot: hexahedra of degree 1 or 2, distributed over MPI ranks.
class SolidBody : public ElasticBody
{
public:
  /// Distance of the undeformed contact zone from a plane table at (x, y), on top of what the mesh's own z
  /// says [m].
  using Gap = std::function<double(double x, double y)>;

  /// Sets up dofs, clamps FootBoundary::stem_cut, prepares K and describes the contact zone. The
  /// triangulation must be one that deal.II distributes over its communicator or a serial one, and must
  /// outlive the body. Throws std::invalid_argument when the mesh has no stem cut or no contact zone.
  ///
  /// @p similar is a body of the same triangulation, material and options, solved in turn with this one: they
  /// share the elements of a multigrid method.
  SolidBody(dealii::Triangulation<3, 3> &triangulation, const ElasticMaterial &material, const Gap &gap,
            const SolidOptions &options = {}, const SolidBody *similar = nullptr);
  /// A body with the equations @p system, whose contact zone lies @p gap above the table.
  SolidBody(std::unique_ptr<SolidSystem> system, Gap gap);
  ~SolidBody() override;

  const ContactSurface &contact_surface() const override;
  Eigen::VectorXd contact_displacement() const override;
  NewtonIncrement solve(const Eigen::SparseMatrix<double> &tangent, const Eigen::VectorXd &forces,
                        const LinearConditions &conditions, const Eigen::Vector3d &motion) override;
  void update(double step_length) override;
  void reset() override;
  double equilibrium_residual(const Eigen::VectorXd &forces) const override;
  unsigned int n_unknowns() const override;

  /// Friction of the contact forces along @p traction, in the axes of the mesh, deforms the body from now on.
  /// Throws as SlidingTraction::validate().
  void set_sliding(const SlidingTraction &traction);

  /// Smallest extent of a contact cell [m]: E over it is the natural penalty of a rigid table.
  double contact_cell_size() const;

  /// The fields in files that this rank has to write: displacement [m] in the slip frame with the table at
  /// rest (the rigid motion @p motion is put back on the glass), stress [Pa], contact pressure [Pa] of
  /// @p nodal_pressure. On one rank contact.vtu; on several contact_<rank>.vtu with the cells of that rank,
  /// of each that has some, and on the first contact.pvtu, which names them.
  std::vector<FieldFile> fields(const Eigen::Vector3d &motion, const Eigen::VectorXd &nodal_pressure) const;

  /// SolidOptions::linear_tolerance from now on.
  void set_linear_tolerance(double tolerance);

  /// Whether it works on the meshes that its own was refined from, which coarser() gives.
  bool has_hierarchy() const;
  /// Whether coarser() gives nothing.
  bool is_coarsest() const;
  /// This foot on the next coarser mesh of the hierarchy that its multigrid works on: where a contact is
  /// cheap to find. Nothing for the coarsest mesh, and for bodies without a hierarchy.
  std::unique_ptr<SolidBody> coarser() const;
  /// Takes over the displacement of coarser().
  void start_from(const SolidBody &coarse);

  /// All that the next solve depends on, of this rank, in binary; read by a body on the same mesh and as many
  /// ranks.
  void write_state(std::ostream &stream) const;
  void read_state(std::istream &stream);

  /// The equations that it solves.
  const SolidSystem &equations() const { return *system; }

private:
  std::unique_ptr<SolidSystem> system;
  Gap gap;
  SlidingTraction sliding;
};

} // namespace stemware::fem
