#include "fem/solid/section_grid.h"

#include "fem/elasticity/harmonic_stiffness.h"

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/grid/grid_generator.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace stemware::fem
{

using namespace dealii;

namespace
{

/// Where a cell of the mesh lies and how large it is in the half plane [m].
using CellInSection = std::array<double, 3>; // radius, height, size

/// The extent of a mesh in the half plane, and its cells there, of all ranks.
struct Section
{
  explicit Section(const SolidLevel &level)
  {
    std::vector<CellInSection> mine;
    for (const auto &cell : level.dof_handler.active_cell_iterators())
    {
      if (!cell->is_locally_owned())
        continue;
      const Point<3> centre = cell->center();
      const MeridianPoint middle = place_of(centre);
      const Tensor<1, 3> outwards =
        middle.radius > 0 ? Tensor<1, 3>({ centre[0] / middle.radius, centre[1] / middle.radius, 0 })
                          : Tensor<1, 3>({ 1, 0, 0 });
      double inner = std::numeric_limits<double>::max(), outer = -inner, low = inner, high = -inner;
      for (const unsigned int v : cell->vertex_indices())
      {
        const Point<3> &vertex = cell->vertex(v);
        inner = std::min(inner, vertex * outwards);
        outer = std::max(outer, vertex * outwards);
        low = std::min(low, vertex[2]);
        high = std::max(high, vertex[2]);
        radius = std::max(radius, place_of(vertex).radius);
      }
      mine.push_back({ middle.radius, middle.height, std::sqrt((outer - inner) * (high - low)) });
      bottom = std::min(bottom, low);
      top = std::max(top, high);
    }
    const MPI_Comm communicator = level.dof_handler.get_communicator();
    for (const auto &part : Utilities::MPI::all_gather(communicator, mine))
      cells.insert(cells.end(), part.begin(), part.end());
    radius = Utilities::MPI::max(radius, communicator);
    bottom = Utilities::MPI::min(bottom, communicator);
    top = Utilities::MPI::max(top, communicator);
  }

  double radius = 0;
  double bottom = std::numeric_limits<double>::max();
  double top = std::numeric_limits<double>::lowest();
  std::vector<CellInSection> cells;
};

} // namespace

MeridianPoint place_of(const Point<3> &point)
{
  return { std::hypot(point[0], point[1]), point[2] };
}

SectionGrid::SectionGrid(const SolidLevel &level)
    : element(1)
{
  dof_handler.reinit(squares);
  make_squares(level);
  dof_handler.distribute_dofs(element);
  DoFTools::make_hanging_node_constraints(dof_handler, hanging);
  hanging.close();
  points.resize(dof_handler.n_dofs());
  for (const auto &square : dof_handler.active_cell_iterators())
    for (unsigned int v = 0; v < 4; ++v)
      points[square->vertex_dof_index(v, 0)] = { square->vertex(v)[0], square->vertex(v)[1] };
}

void SectionGrid::make_squares(const SolidLevel &level)
{
  const Section section(level);
  bottom = section.bottom;
  n_rows = 2;
  root_size = (section.top - bottom) / n_rows;
  n_columns = static_cast<unsigned int>(std::ceil(section.radius / root_size));
  GridGenerator::subdivided_hyper_rectangle(squares, { n_columns, n_rows }, Point<2>(0, bottom),
                                            Point<2>(n_columns * root_size, section.top));
  roots.resize(n_columns * n_rows);
  for (const auto &square : squares.cell_iterators_on_level(0))
    roots[root_index({ square->center()[0], square->center()[1] })] = square->index();
  for (bool is_fine = false; !is_fine;)
  {
    is_fine = true;
    for (const auto &[radius, height, size] : section.cells)
    {
      const Square square = square_at({ radius, height });
      if (square->extent_in_direction(0) <= coarse_space_parameters.relative_size * size)
        continue;
      square->set_refine_flag();
      is_fine = false;
    }
    squares.execute_coarsening_and_refinement();
  }
}

unsigned int SectionGrid::root_index(const MeridianPoint &place) const
{
  const auto index = [&](double distance, unsigned int n)
  { return static_cast<unsigned int>(std::clamp(std::floor(distance / root_size), 0., n - 1.)); };
  return index(place.height - bottom, n_rows) * n_columns + index(place.radius, n_columns);
}

SectionGrid::Square SectionGrid::square_at(const MeridianPoint &place) const
{
  Square square(&squares, 0, roots[root_index(place)], &dof_handler);
  while (square->has_children())
  {
    const Point<2> middle = square->center();
    square = square->child((place.radius > middle[0] ? 1 : 0) + (place.height > middle[1] ? 2 : 0));
  }
  return square;
}

Point<2> SectionGrid::place_in(const Square &square, const MeridianPoint &place)
{
  const Point<2> corner = square->vertex(0);
  const double width = square->extent_in_direction(0);
  return { std::clamp((place.radius - corner[0]) / width, 0., 1.),
           std::clamp((place.height - corner[1]) / width, 0., 1.) };
}

template <typename Use>
void SectionGrid::resolve(types::global_dof_index dof, double factor, const Use &use) const
{
  if (!hanging.is_constrained(dof))
    use(static_cast<unsigned int>(dof), factor);
  else
    for (const auto &[master, weight] : *hanging.get_constraint_entries(dof))
      use(static_cast<unsigned int>(master), factor * weight);
}

std::vector<std::pair<unsigned int, double>> SectionGrid::functions_at(const MeridianPoint &place) const
{
  constexpr double negligible = 1e-9;
  const Square square = square_at(place);
  const Point<2> inside = place_in(square, place);
  std::vector<std::pair<unsigned int, double>> functions;
  for (unsigned int v = 0; v < 4; ++v)
    if (const double shape = GeometryInfo<2>::d_linear_shape_function(inside, v); shape > negligible)
      resolve(square->vertex_dof_index(v, 0), shape,
              [&](unsigned int node, double value) { functions.emplace_back(node, value); });
  return functions;
}

void SectionGrid::add_point(const Square &square, const MeridianPoint &place, double weight,
                            Products &products)
{
  const Point<2> inside = place_in(square, place);
  Eigen::Matrix<double, 12, 1> fields;
  for (unsigned int i = 0; i < 4; ++i)
  {
    const Tensor<1, 2> gradient =
      GeometryInfo<2>::d_linear_shape_function_gradient(inside, i) / square->extent_in_direction(0);
    fields(i) = gradient[0];
    fields(4 + i) = gradient[1];
    fields(8 + i) = GeometryInfo<2>::d_linear_shape_function(inside, i) / place.radius;
  }
  products += weight * fields * fields.transpose();
}

std::vector<SectionGrid::Products> SectionGrid::integrate(const SolidLevel &level) const
{
  std::vector<Products> sums(squares.n_active_cells(), Products::Zero());
  std::vector<double> is_touched(sums.size(), 0);
  FEValues<3> values(level.mapping, level.element, QGauss<3>(2),
                     update_quadrature_points | update_JxW_values);
  for (const auto &cell : level.dof_handler.active_cell_iterators())
  {
    if (!cell->is_locally_owned())
      continue;
    values.reinit(cell);
    for (const unsigned int q : values.quadrature_point_indices())
    {
      const MeridianPoint place = place_of(values.quadrature_point(q));
      const Square square = square_at(place);
      is_touched[square->active_cell_index()] = 1;
      add_point(square, place, values.JxW(q), sums[square->active_cell_index()]);
    }
    constexpr double little = 1e-3;
    for (const unsigned int v : cell->vertex_indices())
    {
      const Point<3> inside = cell->vertex(v) + little * (cell->center() - cell->vertex(v));
      is_touched[square_at(place_of(inside))->active_cell_index()] = 1;
    }
  }
  const MPI_Comm communicator = level.dof_handler.get_communicator();
  const ArrayView<double> numbers(sums.front().data(), sums.size() * sizeof(Products) / sizeof(double));
  Utilities::MPI::sum(ArrayView<const double>(numbers), communicator, numbers);
  Utilities::MPI::max(is_touched, communicator, is_touched);
  const QGauss<2> quadrature(2);
  for (const auto &square : dof_handler.active_cell_iterators())
    for (unsigned int q = 0; q < quadrature.size(); ++q)
    {
      const double width = square->extent_in_direction(0);
      const Point<2> point = square->vertex(0) + width * quadrature.point(q);
      const double share = is_touched[square->active_cell_index()] > 0
                             ? coarse_space_parameters.stiffness_of_touched_square
                             : coarse_space_parameters.stiffness_of_empty_square;
      const double volume = 2 * numbers::PI * point[0] * width * width * quadrature.weight(q);
      add_point(square, { point[0], point[1] }, share * volume, sums[square->active_cell_index()]);
    }
  return sums;
}

std::array<Eigen::SparseMatrix<double>, 3> SectionGrid::stiffness(const SolidLevel &level,
                                                                  const ElasticMaterial &material) const
{
  const HarmonicStiffness stiffness(material);
  std::vector<std::array<Eigen::MatrixXd, 3>> of_squares;
  for (const Products &products : integrate(level))
    of_squares.push_back(stiffness.parts(products));
  std::array<Eigen::SparseMatrix<double>, 3> parts;
  for (unsigned int p = 0; p < 3; ++p)
  {
    std::vector<Eigen::Triplet<double>> entries;
    for (const auto &square : dof_handler.active_cell_iterators())
    {
      const auto &matrix = of_squares[square->active_cell_index()][p];
      const auto add_block =
        [&](unsigned int i, unsigned int j, unsigned int row, unsigned int column, double weight)
      {
        for (unsigned int c = 0; c < 3; ++c)
          for (unsigned int d = 0; d < 3; ++d)
            entries.emplace_back(static_cast<int>(3 * row + c), static_cast<int>(3 * column + d),
                                 weight * matrix(3 * i + c, 3 * j + d));
      };
      for (unsigned int i = 0; i < 4; ++i)
        for (unsigned int j = 0; j < 4; ++j)
          resolve(square->vertex_dof_index(i, 0), 1,
                  [&](unsigned int row, double factor)
                  {
                    resolve(square->vertex_dof_index(j, 0), factor,
                            [&](unsigned int column, double weight)
                            { add_block(i, j, row, column, weight); });
                  });
    }
    parts[p].resize(3 * static_cast<int>(n_nodes()), 3 * static_cast<int>(n_nodes()));
    parts[p].setFromTriplets(entries.begin(), entries.end());
  }
  return parts;
}

} // namespace stemware::fem
