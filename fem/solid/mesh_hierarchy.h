#pragma once

#include "fem/solid/coarse_solver.h"

#include <deal.II/multigrid/mg_matrix.h>
#include <deal.II/multigrid/mg_smoother.h>
#include <deal.II/multigrid/mg_transfer_global_coarsening.h>
#include <deal.II/multigrid/multigrid.h>

#include <memory>
#include <vector>

namespace stemware::fem
{

/// Mesh and degree of its elements.
struct LevelElements
{
  std::shared_ptr<const dealii::Triangulation<3>> mesh;
  unsigned int degree;
};

/// Returns the levels of a hierarchy on @p triangulation, which must outlive them: linear elements on the
/// coarsest mesh, then elements of @p degree on all meshes from the coarsest to the finest.
std::vector<LevelElements> levels_of(const dealii::Triangulation<3> &triangulation, unsigned int degree);

/// Geometric multigrid for an elastic foot: V-cycles in single precision over the refinement history of a
/// triangulation, each level with the table's stiffness (docs/method/solid_at_scale.md). Level 0 has linear
/// elements and a CoarseSolver. From one level to the next, cells are kept or halved, or the degree rises.
/// Matrix-free; smoothed by Chebyshev polynomials of the Jacobi-scaled operator.
class MeshHierarchy
{
public:
  /// @p elements from the coarsest level up.
  MeshHierarchy(const std::vector<LevelElements> &elements, unsigned int mapping_degree,
                const ElasticMaterial &material);
  MeshHierarchy(const MeshHierarchy &) = delete;

  using Vector = dealii::LinearAlgebra::distributed::Vector<double>;

  unsigned int n_levels() const { return static_cast<unsigned int>(levels.size()); }
  /// Returns the lowest level with the elements of the finest.
  unsigned int coarsest_mesh() const
  {
    return levels.front()->element.degree < levels.back()->element.degree ? 1 : 0;
  }
  const SolidLevel &level(unsigned int l) const { return *levels[l]; }
  /// Returns the contact nodes of level @p l, of this rank's cells and for interpolation to the level above.
  const std::shared_ptr<const ContactNodes> &contact_nodes(unsigned int l) const { return nodes[l]; }

  /// Prepares V-cycles for K + B' T B from level @p l down; @p tangent: this rank's part of T on level @p l.
  void set_contact(unsigned int l, const Eigen::SparseMatrix<double> &tangent);

  /// Applies one V-cycle from level @p l down: @p dst approximates the solution of (K + B' T B) dst = @p src.
  void v_cycle(unsigned int l, Vector &dst, const Vector &src) const;

  /// Interpolates @p coarse of the level below to @p fine of level @p l in single precision; constrained: 0.
  template <typename Number>
  void prolongate(unsigned int l, dealii::LinearAlgebra::distributed::Vector<Number> &fine,
                  const dealii::LinearAlgebra::distributed::Vector<Number> &coarse) const
  {
    FloatVector from, to;
    matrices[l - 1].initialize_dof_vector(from);
    matrices[l].initialize_dof_vector(to);
    from.copy_locally_owned_data_from(coarse);
    transfer->prolongate(l, to, from);
    fine.copy_locally_owned_data_from(to);
    levels[l]->constraints.set_zero(fine); // distribute() interpolates hanging nodes later
  }

private:
  using Transfer = dealii::MGTransferGlobalCoarsening<3, FloatVector>;

  /// V-cycle from one level down.
  struct Cycle
  {
    Cycle(const MeshHierarchy &hierarchy, unsigned int l);

    dealii::Multigrid<FloatVector> multigrid;
    dealii::PreconditionMG<3, FloatVector, Transfer> preconditioner;
  };

  void find_contact_nodes();
  void make_transfer();
  void make_smoothers();

  std::vector<std::unique_ptr<SolidLevel>> levels;
  std::vector<std::shared_ptr<const ContactNodes>> nodes;
  /// Interpolation to the contact nodes of each level from the next coarser level.
  std::vector<Eigen::SparseMatrix<double>> interpolations;
  dealii::MGLevelObject<LevelMatrix> matrices;
  dealii::MGLevelObject<dealii::MGTwoLevelTransfer<3, FloatVector>> transfers;
  std::unique_ptr<Transfer> transfer; ///< refers to `transfers`
  dealii::mg::SmootherRelaxation<LevelSmoother, FloatVector> smoother;
  std::unique_ptr<CoarseSolver> coarse_solver;
  dealii::mg::Matrix<FloatVector> matrix;
  mutable std::vector<std::unique_ptr<Cycle>> cycles; ///< each created on first use
};

/// Stiffness K of a SolidBody on one level of a MeshHierarchy, without a matrix, and an approximate inverse
/// of K + B' T B with the table's tangent T: V-cycles in single precision. Copies share memory; each system
/// sets its T before it is solved.
class BodyStiffness
{
public:
  using Vector = MeshHierarchy::Vector;

  BodyStiffness(const std::shared_ptr<MeshHierarchy> &meshes, unsigned int level,
                const ElasticMaterial &material)
      : material(material)
      , hierarchy(meshes)
      , level(level)
      , elastic(
          make_elastic_operator<double>(mesh().mapping, mesh().dof_handler, mesh().constraints, material))
  {
  }
  virtual ~BodyStiffness() = default;

  const SolidLevel &mesh() const { return hierarchy->level(level); }
  std::shared_ptr<const ContactNodes> contact_nodes() const { return hierarchy->contact_nodes(level); }
  /// Returns a zero vector of this rank's unknowns.
  void initialize(Vector &vector) const { elastic->initialize_dof_vector(vector); }

  /// Computes @p dst = K @p src.
  virtual void vmult(Vector &dst, const Vector &src) const { elastic->vmult(dst, src); }
  /// Sets T (this rank's part of it) for precondition().
  virtual void set_contact(const Eigen::SparseMatrix<double> &tangent)
  {
    hierarchy->set_contact(level, tangent);
  }
  /// Computes an approximate solution @p dst of (K + B' T B) dst = @p src; symmetric and positive definite.
  virtual void precondition(Vector &dst, const Vector &src) const { hierarchy->v_cycle(level, dst, src); }

  /// Returns whether the mesh was refined from a coarser mesh.
  bool has_coarser_mesh() const { return level > hierarchy->coarsest_mesh(); }
  /// Returns the stiffness of this body on the next coarser mesh, which must exist.
  std::unique_ptr<BodyStiffness> coarser() const
  {
    return std::make_unique<BodyStiffness>(hierarchy, level - 1, material);
  }
  /// Interpolates @p coarse on the mesh of coarser() to @p fine, in single precision.
  template <typename Number>
  void prolongate(dealii::LinearAlgebra::distributed::Vector<Number> &fine,
                  const dealii::LinearAlgebra::distributed::Vector<Number> &coarse) const
  {
    hierarchy->prolongate(level, fine, coarse);
  }

  const ElasticMaterial material;

private:
  const std::shared_ptr<MeshHierarchy> hierarchy;
  const unsigned int level;
  const std::shared_ptr<const ElasticOperator<double>> elastic;
};

} // namespace stemware::fem
