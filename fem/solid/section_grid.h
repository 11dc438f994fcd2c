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

/// Numbers of the coarse space of a mesh's mean body of revolution, tuned on round feet and tried on chipped,
/// lobed and oval ones (docs/method/solid_measurements.md).
struct CoarseSpaceParameters
{
  /// Wave has at least four cells round the rim; shorter ones are left to the smoother.
  unsigned int cells_per_wave = 4;
  unsigned int max_harmonics = 32; ///< so that the dense matrix of the table has some hundred rows
  /// Size of a square over that of the cells there, at most: smaller ones take no iterations away.
  double relative_size = 2.8;
  /// Shares of the glass's stiffness that squares with glass and without have besides.
  double stiffness_of_touched_square = 0.1, stiffness_of_empty_square = 1e-6;
};
inline constexpr CoarseSpaceParameters coarse_space_parameters = {};

/// Returns radius and height of @p point.
MeridianPoint place_of(const dealii::Point<3> &point);

/// Squares of the half plane (r, z) over all that a mesh sweeps round its axis, halved until they are about
/// twice as large as the mesh's cells there, with bilinear functions on them. The same on all ranks.
class SectionGrid
{
public:
  explicit SectionGrid(const SolidLevel &level);

  unsigned int n_nodes() const { return static_cast<unsigned int>(points.size()); }
  const MeridianPoint &node(unsigned int i) const { return points[i]; }
  /// Hanging node is no function of its own.
  bool is_hanging(unsigned int i) const { return hanging.is_constrained(i); }

  /// Functions that are not zero at @p place, with their values.
  std::vector<std::pair<unsigned int, double>> functions_at(const MeridianPoint &place) const;

  /// K_0, K_1, K_2 of K_n = K_0 + n K_1 + n^2 K_2, shape [3 n_nodes, 3 n_nodes], unknown 3 i + component (r,
  /// theta, z) of node i: the energy of a body of revolution times 2 pi, integrated over the cells of @p
  /// level. A square with glass in it has a tenth of the glass's stiffness besides, so that what nodes of the
  /// mesh see of it costs energy, an empty one a millionth.
  std::array<Eigen::SparseMatrix<double>, 3> stiffness(const SolidLevel &level,
                                                       const ElasticMaterial &material) const;

private:
  using Square = dealii::DoFHandler<2>::cell_iterator;
  /// Integrals over one square, as HarmonicStiffness::parts() takes them.
  using Products = Eigen::Matrix<double, 12, 12>;

  void make_squares(const SolidLevel &level);
  unsigned int root_index(const MeridianPoint &place) const;
  Square square_at(const MeridianPoint &place) const;
  /// Coordinates in @p square, from 0 to 1.
  static dealii::Point<2> place_in(const Square &square, const MeridianPoint &place);
  static void add_point(const Square &square, const MeridianPoint &place, double weight, Products &products);
  std::vector<Products> integrate(const SolidLevel &level) const;
  /// Calls @p use(free node, weight) for what makes up node @p dof.
  template <typename Use>
  void resolve(dealii::types::global_dof_index dof, double factor, const Use &use) const;

  double bottom = 0;
  double root_size = 0; ///< of the squares that the others are parts of [m]
  unsigned int n_rows = 0, n_columns = 0;
  std::vector<int> roots; ///< index of the square on level 0, row by row
  dealii::Triangulation<2> squares;
  const dealii::FE_Q<2> element;
  dealii::DoFHandler<2> dof_handler;
  dealii::AffineConstraints<double> hanging;
  std::vector<MeridianPoint> points;
};

} // namespace stemware::fem
