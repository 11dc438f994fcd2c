#include "fem/revolution/revolution_output.h"

#include "fem/geometry/boundary_ids.h"
#include "ring_model/load/constants.h"

#include <deal.II/base/data_out_base.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <sstream>
#include <tuple>
#include <utility>

namespace stemware::fem
{

using namespace dealii;

namespace
{

using Interpretation = DataComponentInterpretation::DataComponentInterpretation;

Eigen::Matrix3d strain_of(const Eigen::Matrix3d &stress, const ElasticMaterial &material)
{
  const double nu = material.poisson_ratio;
  return ((1 + nu) * stress - nu * stress.trace() * Eigen::Matrix3d::Identity()) / material.young_modulus;
}

/// Returns the stress tensor in the axes e_r, e_theta, e_z from the components of MeridianField::Amplitudes.
Eigen::Matrix3d cylindrical_stress(const Eigen::Matrix<double, 6, 1> &in_phase,
                                   const Eigen::Vector3d &conjugate)
{
  Eigen::Matrix3d stress;
  stress << in_phase(2), conjugate(1), in_phase(5), //
    conjugate(1), in_phase(3), conjugate(2),        //
    in_phase(5), conjugate(2), in_phase(4);
  return stress;
}

double von_mises(const Eigen::Matrix3d &stress)
{
  const Eigen::Matrix3d deviator = stress - stress.trace() / 3 * Eigen::Matrix3d::Identity();
  return std::sqrt(1.5) * deviator.norm();
}

/// Contact pressure of a body of revolution: by the table law on the azimuth lines, linear between the lines.
class PressureField
{
public:
  PressureField(const BodyOfRevolution &body, const TableLaw &law, const ContactSolution &solution,
                BodyOfRevolution::Gap gap_given)
      : law(law)
      , compliance(body.contact_compliance())
      , gap(std::move(gap_given))
      , displacement(
          solution.normal_displacement.reshaped(compliance.n_nodes(), body.fourier_basis().n_lines()))
      , normal_force(solution.forces.sum())
  {
  }

  /// Returns the normal force [N].
  double force() const { return normal_force; }

  /// Returns the pressure [Pa] at @p radius [m] and the azimuths of @p azimuths.
  Eigen::VectorXd on_circle(double radius, const FourierBasis &azimuths) const
  {
    const Eigen::VectorXd &radii = compliance.radii;
    if (radius < radii(0) || radius > radii(radii.size() - 1))
      return Eigen::VectorXd::Zero(azimuths.n_lines()); // outside the contact zone
    const Eigen::VectorXd shape = compliance.shape_at(radius);
    const Eigen::Index n_lines = displacement.cols();
    Eigen::VectorXd on_lines = displacement.transpose() * shape;
    for (Eigen::Index j = 0; j < n_lines; ++j)
    {
      const double theta = FourierBasis::norm(0) * static_cast<double>(j) / static_cast<double>(n_lines);
      on_lines(j) = *law.pressure_at(-gap(radius, theta) - on_lines(j));
    }
    Eigen::VectorXd pressure(azimuths.n_lines());
    for (unsigned int k = 0; k < azimuths.n_lines(); ++k)
    {
      const double place = static_cast<double>(k) * static_cast<double>(n_lines) / azimuths.n_lines();
      const auto before = static_cast<Eigen::Index>(place);
      const double share = place - static_cast<double>(before);
      pressure(k) = (1 - share) * on_lines(before % n_lines) + share * on_lines((before + 1) % n_lines);
    }
    return pressure;
  }

private:
  const TableLaw &law;
  const ContactCompliance &compliance;
  const BodyOfRevolution::Gap gap;
  const Eigen::MatrixXd displacement; ///< relative to the table [m], shape [n_radii, n_lines]
  const double normal_force;
};

/// Output nodes of one meridional cell: a grid of pieces, each with the nodes of a Lagrange cell.
struct CellGrid
{
  std::array<unsigned int, 2> extent() const
  {
    return { n_pieces[0] * degree + 1, n_pieces[1] * degree + 1 };
  }
  unsigned int index(unsigned int i, unsigned int j) const { return j * extent()[0] + i; }

  Quadrature<2> points() const
  {
    std::vector<Point<2>> points;
    const auto [columns, rows] = extent();
    for (unsigned int j = 0; j < rows; ++j)
      for (unsigned int i = 0; i < columns; ++i)
        points.emplace_back(static_cast<double>(i) / (columns - 1), static_cast<double>(j) / (rows - 1));
    return Quadrature<2>(points);
  }

  bool is_on_face(unsigned int node, unsigned int face) const
  {
    const auto [columns, rows] = extent();
    const unsigned int place = face < 2 ? node % columns : node / columns;
    return place == (face % 2 == 0 ? 0 : (face < 2 ? columns : rows) - 1);
  }

  unsigned int degree;
  std::array<unsigned int, 2> n_pieces;
};

/// Output node of the meridian. The stress at the node is the average over the cells that share the node.
struct MeridianNode
{
  Point<2> at;               ///< (r, z) [m]
  Eigen::MatrixXd in_phase;  ///< sum over the cells; rows as in MeridianField::Amplitudes
  Eigen::MatrixXd conjugate; ///< sum over the cells; rows as in MeridianField::Amplitudes
  unsigned int n_cells = 0;
  bool is_contact = false;
};

class FootPicture
{
public:
  FootPicture(const MeridianField &field, const PressureField &pressure, const Eigen::Vector3d &motion,
              double axis)
      : field(field)
      , pressure(pressure)
      , motion(motion)
      , axis(axis)
      , degree(field.space().dof_handler().get_fe().degree)
      , span(degree % 2 == 0 ? 2 : 1)
      , basis((field.n_modes() - 1) / 2, n_azimuths())
  {
    find_nodes();
  }

  std::string text() const
  {
    std::vector<std::string> names;
    std::vector<std::tuple<unsigned int, unsigned int, std::string, Interpretation>> ranges;
    const auto add = [&](const std::string &name, unsigned int n_components, Interpretation interpretation)
    {
      if (n_components > 1)
        ranges.emplace_back(names.size(), names.size() + n_components - 1, name, interpretation);
      names.insert(names.end(), n_components, name);
    };
    add("displacement", 3, DataComponentInterpretation::component_is_part_of_vector);
    add("rigid_motion", 3, DataComponentInterpretation::component_is_part_of_vector);
    add("stress", 9, DataComponentInterpretation::component_is_part_of_tensor);
    add("strain", 9, DataComponentInterpretation::component_is_part_of_tensor);
    add("von_mises_stress", 1, DataComponentInterpretation::component_is_scalar);
    add("contact_pressure", 1, DataComponentInterpretation::component_is_scalar);

    DataOutBase::VtkFlags flags;
    flags.print_date_and_time = false; // for reproducible files
    flags.compression_level = decltype(flags.compression_level)::best_speed;
    flags.write_higher_order_cells = span > 1;
    std::ostringstream text;
    DataOutBase::write_vtu(patches(values_at_points()), names, ranges, flags, text);
    return text.str();
  }

private:
  using Cell = DoFHandler<2>::active_cell_iterator;

  static unsigned int contact_face(const Cell &cell)
  {
    for (const unsigned int face : cell->face_indices())
      if (is_on(cell->face(face), FootBoundary::contact_zone))
        return face;
    return numbers::invalid_unsigned_int;
  }

  /// Returns the number of azimuths, a multiple of `span`: at least four per wavelength of the highest
  /// harmonic.
  unsigned int n_azimuths() const { return std::max(4 * (field.n_modes() - 1) / 2, 48u) / span * span; }

  /// Returns the load [N] of a contact cell by the trapezoidal rule over the nodes of @p n_pieces pieces.
  double drawn_force(const Cell &cell, unsigned int n_pieces) const
  {
    const auto face = cell->face(contact_face(cell));
    const unsigned int n_intervals = degree * n_pieces;
    const double begin = face->vertex(0)[0], step = (face->vertex(1)[0] - begin) / n_intervals;
    const double width = FourierBasis::norm(0) / basis.n_lines();
    double force = 0;
    for (unsigned int i = 0; i <= n_intervals; ++i)
      force += (i % n_intervals == 0 ? 0.5 : 1) * std::abs(step) * width * (begin + i * step) *
               pressure.on_circle(begin + i * step, basis).sum();
    return force;
  }

  /// Returns the output nodes of @p cell. Contact cells are divided until the load is accurate to 0.5 %.
  CellGrid grid_of(const Cell &cell, unsigned int n_contact_cells) const
  {
    const unsigned int face = contact_face(cell);
    if (face == numbers::invalid_unsigned_int)
      return { degree, { 1, 1 } };
    constexpr unsigned int max_pieces = 32;
    const double force = drawn_force(cell, max_pieces), allowed = 0.005 * pressure.force() / n_contact_cells;
    unsigned int n = 1;
    while (n < max_pieces && std::abs(drawn_force(cell, n) - force) > allowed)
      n *= 2;
    return face < 2 ? CellGrid{ degree, { 1, n } } : CellGrid{ degree, { n, 1 } };
  }

  void find_nodes()
  {
    const FE_Q<2> scalar(degree);
    const std::vector<unsigned int> of_lattice = scalar.get_poly_space_numbering_inverse();
    const auto &element = field.space().dof_handler().get_fe();
    std::map<MeridianSpace::Dof, unsigned int> places; // output node of each degree of freedom
    std::vector<MeridianSpace::Dof> dofs(element.n_dofs_per_cell());
    for (const Cell &cell : field.space().dof_handler().active_cell_iterators())
    {
      const unsigned int face = contact_face(cell);
      CellGrid grid = grid_of(cell, field.space().n_contact_nodes() / degree);
      const MeridianField::Amplitudes amplitudes = field.amplitudes(cell, grid.points());
      cell->get_dof_indices(dofs);
      std::vector<unsigned int> of_grid;
      const auto [columns, rows] = grid.extent();
      for (unsigned int j = 0; j < rows; ++j)
        for (unsigned int i = 0; i < columns; ++i)
        {
          unsigned int place = static_cast<unsigned int>(nodes.size());
          if (i % grid.n_pieces[0] == 0 && j % grid.n_pieces[1] == 0)
          {
            const unsigned int lattice = j / grid.n_pieces[1] * (degree + 1) + i / grid.n_pieces[0];
            place = places.emplace(dofs[element.component_to_system_index(2, of_lattice[lattice])], place)
                      .first->second;
          }
          if (place == nodes.size())
            nodes.push_back({ amplitudes.points[grid.index(i, j)], Eigen::MatrixXd::Zero(6, field.n_modes()),
                              Eigen::MatrixXd::Zero(3, field.n_modes()) });
          MeridianNode &node = nodes[place];
          node.in_phase += amplitudes.in_phase.middleRows<6>(6 * grid.index(i, j));
          node.conjugate += amplitudes.conjugate.middleRows<3>(3 * grid.index(i, j));
          ++node.n_cells;
          node.is_contact |= face != numbers::invalid_unsigned_int && grid.is_on_face(grid.index(i, j), face);
          of_grid.push_back(place);
        }
      grids.emplace_back(grid, std::move(of_grid));
    }
  }

  /// Values per point: the fields in the order of text(), then the coordinates.
  static constexpr unsigned int n_values = 29;
  using PointValues = std::array<float, n_values>;

  /// Returns the values at all points. Node n on line l has the index n * n_lines + l.
  std::vector<PointValues> values_at_points() const
  {
    std::vector<PointValues> points(nodes.size() * basis.n_lines());
    for (std::size_t n = 0; n < nodes.size(); ++n)
    {
      const MeridianNode &node = nodes[n];
      const Eigen::MatrixXd in_phase = basis.evaluate(node.in_phase / node.n_cells);
      const Eigen::MatrixXd conjugate = basis.evaluate_conjugates(node.conjugate / node.n_cells);
      const Eigen::VectorXd on_circle =
        node.is_contact ? pressure.on_circle(node.at[0], basis) : Eigen::VectorXd::Zero(basis.n_lines());
      for (unsigned int line = 0; line < basis.n_lines(); ++line)
      {
        Eigen::Map<Eigen::Matrix<float, n_values, 1>>(points[n * basis.n_lines() + line].data()) =
          values_in_slip_frame(node.at, basis.azimuth(line) + axis, in_phase.col(line), conjugate.col(line),
                               on_circle(line))
            .cast<float>();
      }
    }
    return points;
  }

  /// Returns the output cells: pieces of meridional cells swept over one sector, in right-handed coordinates.
  std::vector<DataOutBase::Patch<3>> patches(const std::vector<PointValues> &points) const
  {
    const unsigned int n = span + 1;
    std::vector<DataOutBase::Patch<3>> patches;
    for (const auto &[grid, of_grid] : grids)
      for (unsigned int line = 0; line < basis.n_lines(); line += span)
        for (unsigned int row = 0; row + 1 < grid.extent()[1]; row += span)
          for (unsigned int column = 0; column + 1 < grid.extent()[0]; column += span)
          {
            DataOutBase::Patch<3> &patch = patches.emplace_back();
            patch.patch_index = static_cast<unsigned int>(patches.size() - 1);
            patch.n_subdivisions = span;
            patch.reference_cell = ReferenceCells::Hexahedron;
            patch.points_are_available = true;
            patch.data.reinit(n_values, n * n * n);
            for (unsigned int j = 0; j < n; ++j)
              for (unsigned int k = 0; k < n; ++k)
                for (unsigned int i = 0; i < n; ++i)
                {
                  const PointValues &values =
                    points[of_grid[grid.index(column + i, row + j)] * basis.n_lines() +
                           (line + k) % basis.n_lines()];
                  for (unsigned int d = 0; d < n_values; ++d)
                    patch.data(d, (j * n + k) * n + i) = values[d];
                }
          }
    return patches;
  }

  /// Returns the values of a point, transformed from cylindrical components into the slip frame.
  Eigen::Matrix<double, n_values, 1> values_in_slip_frame(const Point<2> &at, double azimuth,
                                                          const Eigen::Matrix<double, 6, 1> &in_phase,
                                                          const Eigen::Vector3d &conjugate,
                                                          double contact_pressure) const
  {
    Eigen::Matrix3d axes = Eigen::Matrix3d::Identity(); // columns e_r, e_theta, e_z
    axes.topLeftCorner<2, 2>() = Eigen::Rotation2Dd(azimuth).toRotationMatrix();
    const Eigen::Vector3d point = axes * Eigen::Vector3d(at[0], 0, at[1]);
    const Eigen::Vector2d tilt = motion.tail<2>();
    const Eigen::Matrix3d stress = axes * cylindrical_stress(in_phase, conjugate) * axes.transpose();
    Eigen::Matrix<double, n_values, 1> values;
    values << axes * Eigen::Vector3d(in_phase(0), conjugate(0), in_phase(1)), -tilt * point(2),
      motion(0) + tilt.dot(point.head<2>()), stress.reshaped(),
      strain_of(stress, field.material()).reshaped(), von_mises(stress), contact_pressure, point;
    return values;
  }

  const MeridianField &field;
  const PressureField &pressure;
  const Eigen::Vector3d motion;
  const double axis;
  const unsigned int degree;
  const unsigned int span; ///< intervals of an output cell in each direction: 2 (27 nodes) or 1 (8 nodes)
  const FourierBasis basis;
  std::vector<MeridianNode> nodes;
  std::vector<std::pair<CellGrid, std::vector<unsigned int>>> grids;
};

} // namespace

std::string revolution_fields(const MeridianField &field, const BodyOfRevolution &body, const TableLaw &law,
                              const ContactSolution &solution, const BodyOfRevolution::Gap &gap, double axis)
{
  return FootPicture(field, PressureField(body, law, solution, gap), solution.motion, axis).text();
}

std::vector<StressedPatch> revolution_section(const MeridianField &field, double azimuth)
{
  constexpr unsigned int n_points = 2;
  const Quadrature<2> corners = QTrapezoid<2>();
  std::vector<StressedPatch> patches;
  for (const auto &cell : field.space().dof_handler().active_cell_iterators())
  {
    const MeridianField::Amplitudes amplitudes = field.amplitudes(cell, corners);
    for (const int side : { 1, -1 })
    {
      Eigen::VectorXd modes(field.n_modes()), conjugates(field.n_modes());
      for (unsigned int mode = 0; mode < field.n_modes(); ++mode)
      {
        const double angle = FourierBasis::harmonic(mode) * (azimuth + (side < 0 ? ring::pi : 0));
        modes(mode) = FourierBasis::is_sine(mode) ? std::sin(angle) : std::cos(angle);
        conjugates(mode) = mode == 0 ? 0 : FourierBasis::is_sine(mode) ? -std::cos(angle) : std::sin(angle);
      }
      const Eigen::VectorXd in_phase = amplitudes.in_phase * modes,
                            conjugate = amplitudes.conjugate * conjugates;
      StressedPatch patch(n_points);
      for (unsigned int p = 0; p < corners.size(); ++p)
      {
        const auto at = in_phase.segment<6>(6 * p);
        const auto across = conjugate.segment<3>(3 * p);
        patch[p / n_points].push_back({ side * amplitudes.points[p][0], amplitudes.points[p][1], side * at(0),
                                        at(1), von_mises(cylindrical_stress(at, across)) });
      }
      patches.push_back(std::move(patch));
    }
  }
  return patches;
}

} // namespace stemware::fem
