#pragma once

#include "fem/solid/contact_stiffness.h"
#include "fem/solid/simd/elastic_operator.h"

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/lac/affine_constraints.h>

#include <memory>
#include <vector>

namespace stemware::fem
{

/// Clamps FootBoundary::stem_cut and ties hanging nodes. Throws std::invalid_argument without a stem cut.
dealii::AffineConstraints<double> clamp_stem_cut(const dealii::DoFHandler<3> &dof_handler);

/// Mesh with finite elements on it.
struct SolidLevel
{
  SolidLevel(std::shared_ptr<const dealii::Triangulation<3>> triangulation, unsigned int degree,
             unsigned int mapping_degree);

  const std::shared_ptr<const dealii::Triangulation<3>> triangulation;
  const std::unique_ptr<const dealii::MappingQ<3>> geometry; ///< conforming_mapping()
  const dealii::MappingQ<3> &mapping;
  const dealii::FESystem<3> element;
  dealii::DoFHandler<3> dof_handler;
  dealii::AffineConstraints<double> constraints;
};

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
  ~MeshHierarchy();

  using Vector = dealii::LinearAlgebra::distributed::Vector<double>;

  unsigned int n_levels() const;
  /// Returns the lowest level with the elements of the finest.
  unsigned int coarsest_mesh() const;
  const SolidLevel &level(unsigned int l) const;
  /// Returns the contact nodes of level @p l, of this rank's cells and for interpolation to the level above.
  const std::shared_ptr<const ContactNodes> &contact_nodes(unsigned int l) const;

  /// Prepares V-cycles for K + B' T B from level @p l down; @p tangent: this rank's part of T on level @p l.
  void set_contact(unsigned int l, const Eigen::SparseMatrix<double> &tangent);

  /// Applies one V-cycle from level @p l down: @p dst approximates the solution of (K + B' T B) dst = @p src.
  void v_cycle(unsigned int l, Vector &dst, const Vector &src) const;

  /// Interpolates @p coarse of the level below to @p fine of level @p l in single precision; constrained: 0.
  template <typename Number>
  void prolongate(unsigned int l, dealii::LinearAlgebra::distributed::Vector<Number> &fine,
                  const dealii::LinearAlgebra::distributed::Vector<Number> &coarse) const;

private:
  struct Cycle;
  std::unique_ptr<Cycle> cycle;
};

} // namespace stemware::fem
