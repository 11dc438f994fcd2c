#pragma once

#include "fem/solid/level_matrix.h"
#include "fem/solid/section_grid.h"

#include <Eigen/Cholesky>
#include <Eigen/SparseCholesky>

#include <array>
#include <memory>
#include <vector>

namespace stemware::fem
{

/// Coarse space of a mesh: displacement harmonics of its azimuthal average, a body of revolution.
///
/// Functions: u_r cos(n theta), u_theta sin(n theta), u_z cos(n theta) and the same rotated by a quarter
/// wave, n = 0 ... n_max, with u from a SectionGrid. K_n is integrated over the mesh itself: the Galerkin
/// matrix without coupling of harmonics and without the difference between sine and cosine. The table couples
/// all harmonics; it is added through the compliances between the grid's nodes in the contact.
class AxisymmetricCoarseSpace
{
public:
  /// @p contact_nodes: contact nodes of the level.
  AxisymmetricCoarseSpace(const SolidLevel &level, const ElasticMaterial &material,
                          const std::shared_ptr<const ContactNodes> &contact_nodes);

  /// Sets @p tangent T of the level's contact nodes, this rank's part.
  void set_contact(const Eigen::SparseMatrix<double> &tangent);

  /// Adds P A^-1 P' @p src to @p dst: P interpolates at the mesh's nodes, A is the stiffness of body and
  /// table in the space. Symmetric.
  void add_correction(FloatVector &dst, const FloatVector &src) const;

private:
  /// Amplitudes: row 6 i + component (u_r, u_theta, u_z, then the rotated ones) of node i of the grid; one
  /// column per harmonic.
  template <typename Number>
  using Amplitudes = Eigen::Matrix<Number, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  /// Node of the mesh that this rank owns.
  struct Node
  {
    std::array<unsigned int, 3> dofs; ///< x, y, z among the rank's
    float cosine, sine;               ///< of the azimuth
  };

  /// One harmonic of the body without the table.
  struct Harmonic
  {
    Eigen::SparseMatrix<double> selection; ///< maps free amplitudes to amplitudes at all nodes of the grid
    std::unique_ptr<Eigen::SimplicialLLT<Eigen::SparseMatrix<double>>> factors; ///< of K_n
    Eigen::MatrixXd contact_response; ///< free amplitudes under unit forces on the grid's contact nodes
    Eigen::MatrixXd contact_factor;   ///< L of the compliance L L' between these
  };

  double describe_nodes(const SolidLevel &level);
  void describe_contact(const SolidLevel &level);
  void factorize(const SolidLevel &level, const ElasticMaterial &material, double clamped_height);
  Eigen::SparseMatrix<double> free_amplitudes(unsigned int harmonic, double clamped_height) const;
  Amplitudes<double> restrict(const FloatVector &src) const;
  void prolongate_add(const Amplitudes<double> &amplitudes, FloatVector &dst) const;

  /// Returns 1 (cosine) for n = 0, else 2 (cosine and sine).
  static unsigned int n_turns(unsigned int harmonic) { return harmonic == 0 ? 1 : 2; }
  /// Returns the offset of a harmonic in the contact unknowns.
  Eigen::Index contact_block(unsigned int harmonic, unsigned int turn) const;
  /// Returns the vertical amplitudes at the grid's contact nodes.
  Eigen::MatrixXd at_contact(const Eigen::MatrixXd &amplitudes) const;

  const MPI_Comm communicator;
  const SectionGrid grid;
  const std::shared_ptr<const ContactNodes> contact_nodes;
  unsigned int n_max = 0;

  std::vector<Node> nodes;
  Eigen::SparseMatrix<float, Eigen::RowMajor> interpolation; ///< shape [nodes.size(), grid.n_nodes()]
  Eigen::MatrixXf cosines, sines; ///< of n theta of the nodes, shape [n_max + 1, nodes.size()]

  std::vector<unsigned int> contact_grid_nodes; ///< grid nodes that influence contact nodes
  Eigen::SparseMatrix<double, Eigen::RowMajor> contact_interpolation; ///< from these to the contact nodes
  Eigen::MatrixXd contact_cosines, contact_sines; ///< of n theta, shape [contact nodes, n_max + 1]

  std::vector<Harmonic> harmonics;
  Eigen::LLT<Eigen::MatrixXd> contact_factors; ///< of 1 + L' T L over all harmonics
};

} // namespace stemware::fem
