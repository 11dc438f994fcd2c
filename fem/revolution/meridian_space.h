#pragma once

#include "fem/geometry/elastic_material.h"
#include "fem/revolution/block_inverse.h"
#include "fem/revolution/contact_compliance.h"
#include "fem/revolution/meridian_stiffness.h"

#include <deal.II/base/point.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/vector.h>

#include <Eigen/SparseCholesky>

#include <array>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

namespace stemware::fem
{

/// Finite elements on one meridian: displacement amplitudes u_r, u_theta, u_z of any harmonic. Includes
/// deal.II: not for headers of the library's users.
class MeridianSpace
{
public:
  using Dof = dealii::types::global_dof_index;
  using NodeDofs = std::array<Dof, 3>; ///< dofs of one node, in the order r, theta, z

  /// Keeps a reference to @p triangulation, with boundary id 2 of the contact zone and 1 of the clamp. Throws
  /// std::invalid_argument without a contact zone.
  MeridianSpace(const dealii::Triangulation<2> &triangulation, const ElasticMaterial &material,
                unsigned int degree);

  unsigned int n_dofs() const { return dofs.n_dofs(); }
  unsigned int n_contact_nodes() const { return static_cast<unsigned int>(contact_nodes.size()); }
  /// Returns the radius of contact node @p i [m]; the nodes ascend.
  double contact_radius(unsigned int i) const;
  const NodeDofs &contact_dofs(unsigned int i) const { return contact_nodes[i]; }
  const dealii::DoFHandler<2> &dof_handler() const { return dofs; }
  /// Returns the mapping of the elements' degree: curved cells follow the profile.
  const dealii::Mapping<2> &mapping() const { return curves; }

  /// K_n of one harmonic, factorised under the clamp and its own conditions on the axis.
  class Factors
  {
  public:
    Factors(const MeridianSpace &space, unsigned int harmonic);
    /// Overwrites @p forces on the free dofs [N/rad] with displacements times int (mode)^2 dtheta [m rad].
    void solve(dealii::Vector<double> &forces) const;

  private:
    const dealii::AffineConstraints<double> constraints;
    Eigen::SimplicialLLT<LowerTriangle> factors;
  };

  /// Returns the factors of a harmonic, computed once. Thread-safe.
  const Factors &factors(unsigned int harmonic) const;

  /// Contact compliances of the harmonics with equal conditions on the axis and therefore an equal order of
  /// elimination: n = 0, n = 1, or n >= 2. Thread-safe.
  class Compliances
  {
  public:
    /// Prepares harmonics with the axis conditions of @p harmonic; nodes @p first ... @p first + @p size - 1.
    Compliances(const MeridianSpace &space, unsigned int harmonic, Eigen::Index first, Eigen::Index size);
    /// Returns the displacements of the contact nodes under vertical unit forces per radian, by reciprocity
    /// also the vertical displacements under radial and azimuthal forces.
    HarmonicCompliance operator()(unsigned int harmonic) const;

  private:
    const dealii::AffineConstraints<double> constraints;
    const Eigen::Index n_nodes;
    std::vector<unsigned int> of_contact; ///< dofs: u_z of the contact nodes, then u_r, then u_theta
    /// Entries of K_0, K_1 and K_2; for n = 0 or 1 the entries of that K_n only.
    std::vector<Eigen::VectorXd> parts;
    std::unique_ptr<const BlockInverse> inverse;
  };

private:
  /// Finds the contact nodes and the nodes at r = 0; an annular section has no nodes at r = 0.
  void find_nodes();
  /// Returns the constraints of the clamp, of hanging nodes, and of a single-valued displacement on the axis:
  /// along the axis for n = 0, across the axis for n = 1 (u_theta = -u_r), zero for higher harmonics.
  dealii::AffineConstraints<double> make_constraints(unsigned int harmonic) const;
  /// Returns a sum of K_0, K_1 and K_2 for each list of factors in @p sums, with @p constraints eliminated.
  std::vector<LowerTriangle> assembled(const std::vector<std::array<double, 3>> &sums,
                                       const dealii::AffineConstraints<double> &constraints) const;

  const dealii::MappingQ<2> curves;
  const dealii::FESystem<2> element;
  dealii::DoFHandler<2> dofs;
  std::unique_ptr<MeridianStiffness> stiffness;
  std::vector<dealii::Point<2>> points; ///< support points of all dofs
  std::vector<NodeDofs> contact_nodes;  ///< ascending radius
  std::vector<NodeDofs> axis_nodes;
  mutable std::mutex mutex;
  mutable std::map<unsigned int, std::unique_ptr<const Factors>> by_harmonic; ///< cache of factors()
};

} // namespace stemware::fem
