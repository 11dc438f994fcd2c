#include "fem/solid/axisymmetric_coarse_space.h"

#include "fem/solid/solid_contact_zone.h"

#include <deal.II/base/mpi.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>

namespace stemware::fem
{

using namespace dealii;

namespace
{

using Triplets = std::vector<Eigen::Triplet<double>>;

Eigen::SparseMatrix<double> matrix_of(const Triplets &entries, std::size_t n_rows, std::size_t n_columns)
{
  Eigen::SparseMatrix<double> matrix(static_cast<Eigen::Index>(n_rows), static_cast<Eigen::Index>(n_columns));
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

} // namespace

AxisymmetricCoarseSpace::AxisymmetricCoarseSpace(const SolidLevel &level, const ElasticMaterial &material,
                                                 const std::shared_ptr<const ContactNodes> &contact_nodes)
    : communicator(level.dof_handler.get_communicator())
    , grid(level)
    , contact_nodes(contact_nodes)
{
  describe_contact(level);
  const double clamped_height = describe_nodes(level);
  factorize(level, material, clamped_height);
}

void AxisymmetricCoarseSpace::describe_contact(const SolidLevel &level)
{
  const ContactSurface surface = describe_contact_zone(level.mapping, level.dof_handler, level.constraints,
                                                       contact_nodes, [](double, double) { return 0.; })
                                   .surface;
  n_max = std::clamp(surface.n_sectors / coarse_space_parameters.cells_per_wave, 2u,
                     coarse_space_parameters.max_harmonics);
  std::vector<std::vector<std::pair<unsigned int, double>>> functions; // of the grid, at each contact node
  std::vector<double> seen;                                            // nodes of the grid
  contact_cosines.resize(surface.n_nodes(), n_max + 1);
  contact_sines.resizeLike(contact_cosines);
  for (unsigned int i = 0; i < surface.n_nodes(); ++i)
  {
    const double x = surface.node_position(i, 0), y = surface.node_position(i, 1);
    functions.push_back(grid.functions_at({ std::hypot(x, y), surface.node_gap(i) }));
    for (const auto &function : functions.back())
      seen.push_back(function.first);
    for (unsigned int n = 0; n <= n_max; ++n)
    {
      contact_cosines(i, n) = std::cos(n * std::atan2(y, x));
      contact_sines(i, n) = std::sin(n * std::atan2(y, x));
    }
  }
  const auto make_unique_and_sorted = [](std::vector<double> &numbers)
  {
    std::sort(numbers.begin(), numbers.end());
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  };
  make_unique_and_sorted(seen);
  seen = surface.parts.all_gather(std::move(seen));
  make_unique_and_sorted(seen);
  contact_grid_nodes.assign(seen.begin(), seen.end());
  Triplets entries;
  for (std::size_t i = 0; i < functions.size(); ++i)
    for (const auto &[node, value] : functions[i])
      entries.emplace_back(static_cast<int>(i),
                           static_cast<int>(std::lower_bound(seen.begin(), seen.end(), node) - seen.begin()),
                           value);
  contact_interpolation = matrix_of(entries, surface.n_nodes(), seen.size());
}

/// Returns the height of the lowest clamped node [m].
double AxisymmetricCoarseSpace::describe_nodes(const SolidLevel &level)
{
  const IndexSet &owned = level.dof_handler.locally_owned_dofs();
  const Quadrature<3> unit_points(level.element.base_element(0).get_unit_support_points());
  FEValues<3> values(level.mapping, level.element, unit_points, update_quadrature_points);
  std::vector<types::global_dof_index> dofs(level.element.n_dofs_per_cell());
  std::vector<bool> seen(owned.n_elements(), false);
  std::vector<double> azimuths;
  Triplets entries;
  double clamped_height = std::numeric_limits<double>::max();
  for (const auto &cell : level.dof_handler.active_cell_iterators())
  {
    if (!cell->is_locally_owned())
      continue;
    cell->get_dof_indices(dofs);
    values.reinit(cell);
    for (const unsigned int k : values.quadrature_point_indices())
    {
      const Point<3> point = values.quadrature_point(k);
      const auto dof = [&](unsigned int c) { return dofs[level.element.component_to_system_index(c, k)]; };
      if (level.constraints.is_constrained(dof(0)))
      {
        clamped_height = std::min(clamped_height, point[2]);
        continue;
      }
      if (!owned.is_element(dof(0)) || seen[owned.index_within_set(dof(0))])
        continue;
      seen[owned.index_within_set(dof(0))] = true;
      for (const auto &[node, value] : grid.functions_at(place_of(point)))
        entries.emplace_back(static_cast<int>(nodes.size()), static_cast<int>(node), value);
      const double azimuth = std::atan2(point[1], point[0]);
      azimuths.push_back(azimuth);
      Node node{ {}, static_cast<float>(std::cos(azimuth)), static_cast<float>(std::sin(azimuth)) };
      for (unsigned int c = 0; c < 3; ++c)
        node.dofs[c] = static_cast<unsigned int>(owned.index_within_set(dof(c)));
      nodes.push_back(node);
    }
  }
  interpolation = matrix_of(entries, nodes.size(), grid.n_nodes()).cast<float>();
  cosines.resize(n_max + 1, static_cast<Eigen::Index>(nodes.size()));
  sines.resizeLike(cosines);
  for (Eigen::Index i = 0; i < cosines.cols(); ++i)
    for (unsigned int n = 0; n <= n_max; ++n)
    {
      const double angle = n * azimuths[static_cast<std::size_t>(i)];
      cosines(n, i) = static_cast<float>(std::cos(angle));
      // Of n = 0 the azimuthal displacement is torsion, the same all round.
      sines(n, i) = n == 0 ? 1 : static_cast<float>(std::sin(angle));
    }
  return Utilities::MPI::min(clamped_height, communicator);
}

/// Held are hanging nodes, those no lower than the clamp, and on the axis what would have many values there:
/// n = 0 moves along it, n = 1 across it (u_theta = -u_r), higher harmonics not at all.
Eigen::SparseMatrix<double> AxisymmetricCoarseSpace::free_amplitudes(unsigned int harmonic,
                                                                     double clamped_height) const
{
  Triplets entries;
  int n_free = 0;
  for (unsigned int i = 0; i < grid.n_nodes(); ++i)
  {
    const int row = static_cast<int>(3 * i);
    if (grid.is_hanging(i) || grid.node(i).height >= clamped_height)
      continue;
    if (grid.node(i).radius > 0)
      for (int c = 0; c < 3; ++c)
        entries.emplace_back(row + c, n_free++, 1);
    else if (harmonic == 0)
      entries.emplace_back(row + 2, n_free++, 1);
    else if (harmonic == 1)
    {
      entries.emplace_back(row, n_free, 1);
      entries.emplace_back(row + 1, n_free++, -1);
    }
  }
  return matrix_of(entries, 3 * grid.n_nodes(), static_cast<std::size_t>(n_free));
}

void AxisymmetricCoarseSpace::factorize(const SolidLevel &level, const ElasticMaterial &material,
                                        double clamped_height)
{
  const std::array<Eigen::SparseMatrix<double>, 3> parts = grid.stiffness(level, material);
  // The top line of the grid is where the clamp is, but for rounding.
  const double clamp = clamped_height - 1e-9 * std::abs(clamped_height);
  const std::size_t n_contact = contact_grid_nodes.size();
  Triplets unit_forces;
  for (std::size_t i = 0; i < n_contact; ++i)
    unit_forces.emplace_back(static_cast<int>(3 * contact_grid_nodes[i] + 2), static_cast<int>(i), 1);
  const Eigen::SparseMatrix<double> contact_forces = matrix_of(unit_forces, 3 * grid.n_nodes(), n_contact);
  for (unsigned int n = 0; n <= n_max; ++n)
  {
    Harmonic harmonic;
    harmonic.selection = free_amplitudes(n, clamp);
    const double mean_square = n == 0 ? 1 : 0.5; // of a wave
    const Eigen::SparseMatrix<double> stiffness =
      mean_square * (parts[0] + double(n) * parts[1] + double(n) * n * parts[2]);
    harmonic.factors = std::make_unique<Eigen::SimplicialLLT<Eigen::SparseMatrix<double>>>(
      Eigen::SparseMatrix<double>(harmonic.selection.transpose() * stiffness * harmonic.selection));
    if (harmonic.factors->info() != Eigen::Success)
      throw std::runtime_error(
        "the stiffness of the mesh's mean body of revolution is not positive definite.");
    harmonic.contact_response =
      harmonic.factors->solve(Eigen::MatrixXd(harmonic.selection.transpose() * contact_forces));
    const Eigen::MatrixXd compliance = at_contact(harmonic.selection * harmonic.contact_response);
    harmonic.contact_factor = compliance.selfadjointView<Eigen::Lower>().llt().matrixL();
    harmonics.push_back(std::move(harmonic));
  }
}

Eigen::Index AxisymmetricCoarseSpace::contact_block(unsigned int harmonic, unsigned int turn) const
{
  const Eigen::Index mode = harmonic == 0 ? 0 : 2 * harmonic - 1 + turn;
  return mode * static_cast<Eigen::Index>(contact_grid_nodes.size());
}

Eigen::MatrixXd AxisymmetricCoarseSpace::at_contact(const Eigen::MatrixXd &amplitudes) const
{
  Eigen::MatrixXd values(static_cast<Eigen::Index>(contact_grid_nodes.size()), amplitudes.cols());
  for (Eigen::Index i = 0; i < values.rows(); ++i)
    values.row(i) = amplitudes.row(3 * contact_grid_nodes[static_cast<std::size_t>(i)] + 2);
  return values;
}

void AxisymmetricCoarseSpace::set_contact(const Eigen::SparseMatrix<double> &tangent)
{
  const Eigen::Index n_all = contact_block(n_max, 1) + static_cast<Eigen::Index>(contact_grid_nodes.size());
  std::vector<Eigen::Index> loaded;
  const Eigen::VectorXd sums = tangent.cwiseAbs() * Eigen::VectorXd::Ones(tangent.cols());
  for (Eigen::Index i = 0; i < sums.size(); ++i)
    if (sums(i) > 0)
      loaded.push_back(i);
  // Vertical displacement of the loaded nodes, of amplitudes that are L times the unknowns.
  Eigen::MatrixXd shapes(static_cast<Eigen::Index>(loaded.size()), contact_interpolation.cols());
  Triplets picked;
  for (std::size_t i = 0; i < loaded.size(); ++i)
  {
    shapes.row(static_cast<Eigen::Index>(i)) = contact_interpolation.row(loaded[i]);
    picked.emplace_back(static_cast<int>(loaded[i]), static_cast<int>(i), 1);
  }
  const Eigen::SparseMatrix<double> pick =
    matrix_of(picked, static_cast<std::size_t>(sums.size()), loaded.size());
  Eigen::MatrixXd displacements(shapes.rows(), n_all);
  for (unsigned int n = 0; n <= n_max; ++n)
  {
    const Eigen::MatrixXd of_unknowns = shapes * harmonics[n].contact_factor;
    for (unsigned int turn = 0; turn < n_turns(n); ++turn)
    {
      const Eigen::VectorXd wave = pick.transpose() * (turn == 0 ? contact_cosines : contact_sines).col(n);
      displacements.middleCols(contact_block(n, turn), shapes.cols()) = wave.asDiagonal() * of_unknowns;
    }
  }
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n_all, n_all);
  if (!loaded.empty())
    matrix.noalias() = displacements.transpose() * (pick.transpose() * tangent * pick * displacements).eval();
  matrix = contact_nodes->parts().sum(matrix);
  matrix.diagonal().array() += 1;
  contact_factors.compute(matrix);
  if (contact_factors.info() != Eigen::Success)
    throw std::runtime_error("the contact stiffness of the mesh's mean body of revolution is not positive "
                             "definite.");
}

AxisymmetricCoarseSpace::Amplitudes<double> AxisymmetricCoarseSpace::restrict(const FloatVector &src) const
{
  Amplitudes<float> sums = Amplitudes<float>::Zero(6 * grid.n_nodes(), n_max + 1);
  for (Eigen::Index i = 0; i < interpolation.rows(); ++i)
  {
    const Node &node = nodes[static_cast<std::size_t>(i)];
    const float x = src.local_element(node.dofs[0]);
    const float y = src.local_element(node.dofs[1]);
    const float z = src.local_element(node.dofs[2]);
    const float radial = node.cosine * x + node.sine * y;
    const float azimuthal = node.cosine * y - node.sine * x;
    const auto cosine = cosines.col(i).transpose();
    const auto sine = sines.col(i).transpose();
    for (Eigen::SparseMatrix<float, Eigen::RowMajor>::InnerIterator entry(interpolation, i); entry; ++entry)
    {
      const Eigen::Index row = 6 * entry.col();
      sums.row(row) += entry.value() * radial * cosine;
      sums.row(row + 1) += entry.value() * azimuthal * sine;
      sums.row(row + 2) += entry.value() * z * cosine;
      sums.row(row + 3) += entry.value() * radial * sine;
      sums.row(row + 4) -= entry.value() * azimuthal * cosine;
      sums.row(row + 5) += entry.value() * z * sine;
    }
  }
  Amplitudes<double> result = sums.cast<double>();
  const ArrayView<double> numbers(result.data(), static_cast<std::size_t>(result.size()));
  Utilities::MPI::sum(ArrayView<const double>(numbers), communicator, numbers);
  return result;
}

void AxisymmetricCoarseSpace::prolongate_add(const Amplitudes<double> &amplitudes, FloatVector &dst) const
{
  const Amplitudes<float> values = amplitudes.cast<float>();
  for (Eigen::Index i = 0; i < interpolation.rows(); ++i)
  {
    const Node &node = nodes[static_cast<std::size_t>(i)];
    const auto cosine = cosines.col(i);
    const auto sine = sines.col(i);
    float radial = 0, azimuthal = 0, vertical = 0;
    for (Eigen::SparseMatrix<float, Eigen::RowMajor>::InnerIterator entry(interpolation, i); entry; ++entry)
    {
      const Eigen::Index row = 6 * entry.col();
      radial += entry.value() * (values.row(row).dot(cosine) + values.row(row + 3).dot(sine));
      azimuthal += entry.value() * (values.row(row + 1).dot(sine) - values.row(row + 4).dot(cosine));
      vertical += entry.value() * (values.row(row + 2).dot(cosine) + values.row(row + 5).dot(sine));
    }
    dst.local_element(node.dofs[0]) += node.cosine * radial - node.sine * azimuthal;
    dst.local_element(node.dofs[1]) += node.sine * radial + node.cosine * azimuthal;
    dst.local_element(node.dofs[2]) += vertical;
  }
}

void AxisymmetricCoarseSpace::add_correction(FloatVector &dst, const FloatVector &src) const
{
  // x = K^-1 g - K^-1 B' L'^-1 (1 - (1 + L' T L)^-1) L^-1 B K^-1 g, the compliance B K^-1 B' being L L'.
  Amplitudes<double> amplitudes = restrict(src);
  const auto n_contact = static_cast<Eigen::Index>(contact_grid_nodes.size());
  std::vector<Eigen::MatrixXd> free(n_max + 1); // amplitudes, a column for each turn
  Eigen::VectorXd table(contact_factors.rows());
  for (unsigned int n = 0; n <= n_max; ++n)
  {
    const Harmonic &harmonic = harmonics[n];
    Eigen::MatrixXd forces(3 * grid.n_nodes(), n_turns(n));
    for (unsigned int i = 0; i < grid.n_nodes(); ++i)
      for (unsigned int turn = 0; turn < n_turns(n); ++turn)
        forces.block<3, 1>(3 * i, turn) = amplitudes.block<3, 1>(6 * i + 3 * turn, n);
    free[n] = harmonic.factors->solve(Eigen::MatrixXd(harmonic.selection.transpose() * forces));
    Eigen::MatrixXd displacements = at_contact(harmonic.selection * free[n]);
    harmonic.contact_factor.triangularView<Eigen::Lower>().solveInPlace(displacements);
    for (unsigned int turn = 0; turn < n_turns(n); ++turn)
      table.segment(contact_block(n, turn), n_contact) = displacements.col(turn);
  }
  table -= contact_factors.solve(table).eval();
  amplitudes.setZero();
  for (unsigned int n = 0; n <= n_max; ++n)
  {
    const Harmonic &harmonic = harmonics[n];
    for (unsigned int turn = 0; turn < n_turns(n); ++turn)
    {
      Eigen::VectorXd forces = table.segment(contact_block(n, turn), n_contact);
      harmonic.contact_factor.triangularView<Eigen::Lower>().transpose().solveInPlace(forces);
      const Eigen::VectorXd all =
        harmonic.selection * (free[n].col(turn) - harmonic.contact_response * forces);
      for (unsigned int i = 0; i < grid.n_nodes(); ++i)
        amplitudes.block<3, 1>(6 * i + 3 * turn, n) = all.segment<3>(3 * i);
    }
  }
  prolongate_add(amplitudes, dst);
}

} // namespace stemware::fem
