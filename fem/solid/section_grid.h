#pragma once

#include "fem/solid/mesh_hierarchy.h"

#include <deal.II/fe/fe_q.h>
#include <deal.II/grid/tria.h>

#include <Eigen/SparseCore>

#include <array>
#include <vector>

namespace stemware::fem
{

/// Point in the half plane of cylindrical coordinates [m].
struct MeridianPoint
{
  double radius = 0;
  double height = 0;
};

/// Parameters of AxisymmetricCoarseSpace, tuned on round feet and tested on chipped, lobed and oval feet
/// (docs/method/solid_measurements.md).
struct CoarseSpaceParameters
{
  /// Cells per wave length of the highest harmonic; shorter waves are left to the smoother.
  unsigned int cells_per_wave = 4;
  unsigned int max_harmonics = 32; ///< keeps the dense matrix of the table at some hundred rows
  /// Upper bound of the size of a square over the local cell size: smaller squares do not reduce the
  /// iterations.
  double relative_size = 2.8;
  /// Additional stiffness of squares with and without glass, as a share of the glass's stiffness.
  double stiffness_of_touched_square = 0.1, stiffness_of_empty_square = 1e-6;
};
/// Values in use.
inline constexpr CoarseSpaceParameters coarse_space_parameters = {};

/// Returns radius and height of @p point.
MeridianPoint place_of(const dealii::Point<3> &point);

/// Adaptive grid of squares in the half plane (r, z) covering the mesh rotated round its axis, about twice as
/// coarse as the mesh, with bilinear functions. Identical on all ranks.
class SectionGrid
{
public:
  explicit SectionGrid(const SolidLevel &level);

  unsigned int n_nodes() const { return static_cast<unsigned int>(points.size()); }
  const MeridianPoint &node(unsigned int i) const { return points[i]; }
  /// Returns whether a node is hanging (has no function of its own).
  bool is_hanging(unsigned int i) const { return hanging.is_constrained(i); }

  /// Returns the functions that are nonzero at @p place, with their values.
  std::vector<std::pair<unsigned int, double>> functions_at(const MeridianPoint &place) const;

  /// Returns K_0, K_1, K_2 of K_n = K_0 + n K_1 + n^2 K_2, shape [3 n_nodes, 3 n_nodes], unknown 3 i +
  /// component (r, theta, z) of node i: 2 pi times the energy of a body of revolution, integrated over the
  /// cells of @p level. Squares with glass get a tenth of the glass's stiffness in addition, so that all
  /// nodes seen by the mesh have energy; empty squares get a millionth.
  std::array<Eigen::SparseMatrix<double>, 3> stiffness(const SolidLevel &level,
                                                       const ElasticMaterial &material) const;

private:
  using Square = dealii::DoFHandler<2>::cell_iterator;
  /// Integrals over one square, argument of HarmonicStiffness::parts().
  using Products = Eigen::Matrix<double, 12, 12>;

  void make_squares(const SolidLevel &level);
  unsigned int root_index(const MeridianPoint &place) const;
  Square square_at(const MeridianPoint &place) const;
  /// Returns the coordinates in @p square, from 0 to 1.
  static dealii::Point<2> place_in(const Square &square, const MeridianPoint &place);
  static void add_point(const Square &square, const MeridianPoint &place, double weight, Products &products);
  std::vector<Products> integrate(const SolidLevel &level) const;
  /// Calls @p use(free node, weight) for each free node that determines node @p dof.
  template <typename Use>
  void resolve(dealii::types::global_dof_index dof, double factor, const Use &use) const;

  double bottom = 0;
  double root_size = 0; ///< size of the unrefined squares [m]
  unsigned int n_rows = 0, n_columns = 0;
  std::vector<int> roots; ///< index of the square on level 0, row by row
  dealii::Triangulation<2> squares;
  const dealii::FE_Q<2> element;
  dealii::DoFHandler<2> dof_handler;
  dealii::AffineConstraints<double> hanging;
  std::vector<MeridianPoint> points;
};

} // namespace stemware::fem
