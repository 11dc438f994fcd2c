// Fields of a foot of revolution for ParaView.
#include "fem/revolution/revolution_output.h"

#include "fem/geometry/boundary_ids.h"

#include <deal.II/base/data_out_base.h>
#include <deal.II/grid/reference_cell.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>

namespace stemware::fem
{

using namespace dealii;

namespace
{

using Patch = DataOutBase::Patch<3, 3>;

/// Rows of a patch's data.
constexpr unsigned int displacement_row = 0;
constexpr unsigned int stress_row = 3;
constexpr unsigned int strain_row = 12;
constexpr unsigned int von_mises_row = 21;
constexpr unsigned int pressure_row = 22;
constexpr unsigned int point_row = 23;
constexpr unsigned int n_rows = 26;

/// Strain of isotropic elasticity under a stress.
Eigen::Matrix3d strain_of(const Eigen::Matrix3d &stress, const ElasticMaterial &material)
{
  const double nu = material.poisson_ratio;
  return ((1 + nu) * stress - nu * stress.trace() * Eigen::Matrix3d::Identity()) / material.young_modulus;
}

double von_mises(const Eigen::Matrix3d &stress)
{
  const Eigen::Matrix3d deviator = stress - stress.trace() / 3 * Eigen::Matrix3d::Identity();
  return std::sqrt(1.5) * deviator.norm();
}

/// deal.II's writers on patches that no mesh has made.
class PatchWriter : public DataOutInterface<3, 3>
{
public:
  explicit PatchWriter(std::vector<Patch> patches)
      : patches(std::move(patches))
  {
  }

private:
  const std::vector<Patch> &get_patches() const override { return patches; }

  std::vector<std::string> get_dataset_names() const override
  {
    std::vector<std::string> names(3, "displacement");
    names.insert(names.end(), 9, "stress");
    names.insert(names.end(), 9, "strain");
    names.insert(names.end(), { "von_mises_stress", "contact_pressure" });
    return names;
  }

  std::vector<std::tuple<unsigned int, unsigned int, std::string,
                         DataComponentInterpretation::DataComponentInterpretation>>
  get_nonscalar_data_ranges() const override
  {
    return {
      { displacement_row, stress_row - 1, "displacement",
        DataComponentInterpretation::component_is_part_of_vector },
      { stress_row, strain_row - 1, "stress", DataComponentInterpretation::component_is_part_of_tensor },
      { strain_row, von_mises_row - 1, "strain", DataComponentInterpretation::component_is_part_of_tensor }
    };
  }

  const std::vector<Patch> patches;
};

/// Nodes of one meridional cell's picture: a grid of pieces, each with the nodes of a Lagrange cell.
class CellGrid
{
public:
  CellGrid(unsigned int degree, std::array<unsigned int, 2> n_pieces)
      : degree(degree)
      , n_pieces(n_pieces)
  {
  }

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

  /// Whether a node lies on a face of the unit square.
  bool is_on_face(unsigned int node, unsigned int face) const
  {
    const auto [columns, rows] = extent();
    const unsigned int place = face < 2 ? node % columns : node / columns;
    return place == (face % 2 == 0 ? 0 : (face < 2 ? columns : rows) - 1);
  }

  const unsigned int degree;
  const std::array<unsigned int, 2> n_pieces;
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
      , n_sectors(sectors_round_the_rim())
      , basis(n_harmonics(), degree * n_sectors)
      , n_contact_pieces(find_contact_pieces())
  {
  }

  std::vector<Patch> patches() const
  {
    std::vector<Patch> result;
    for (const auto &cell : field.space().dof_handler().active_cell_iterators())
      append(cell, result);
    for (unsigned int i = 0; i < result.size(); ++i)
      result[i].patch_index = i;
    return result;
  }

private:
  using Cell = DoFHandler<2>::active_cell_iterator;
  /// All rows of a patch's data at the nodes of a cell's grid, [azimuth](row, node).
  using CellData = std::vector<Eigen::Matrix<double, n_rows, Eigen::Dynamic>>;

  static unsigned int contact_face(const Cell &cell)
  {
    for (const unsigned int face : cell->face_indices())
      if (cell->face(face)->boundary_id() == static_cast<types::boundary_id>(FootBoundary::contact_zone))
        return face;
    return numbers::invalid_unsigned_int;
  }

  static bool is_contact(const Cell &cell) { return contact_face(cell) != numbers::invalid_unsigned_int; }

  unsigned int n_harmonics() const { return (field.n_modes() - 1) / 2; }

  /// Six nodes to the wave of the highest harmonic.
  unsigned int sectors_round_the_rim() const { return std::max(6 * n_harmonics(), 96u) / degree; }

  /// Halves the contact cells until the trapezoidal rule on the drawn nodes finds the normal force.
  unsigned int find_contact_pieces() const
  {
    constexpr unsigned int most = 32;
    unsigned int n_pieces = 1;
    while (n_pieces < most && std::abs(drawn_force(n_pieces) / pressure.force() - 1) > 0.005)
      n_pieces *= 2;
    return n_pieces;
  }

  double drawn_force(unsigned int n_pieces) const
  {
    double force = 0;
    const double width = FourierBasis::norm(0) / basis.n_lines();
    const unsigned int n_intervals = degree * n_pieces;
    for (const Cell &cell : field.space().dof_handler().active_cell_iterators())
    {
      const unsigned int face = contact_face(cell);
      if (face == numbers::invalid_unsigned_int)
        continue;
      const double begin = cell->face(face)->vertex(0)[0];
      const double step = (cell->face(face)->vertex(1)[0] - begin) / n_intervals;
      for (unsigned int i = 0; i <= n_intervals; ++i)
        force += (i % n_intervals == 0 ? 0.5 : 1) * std::abs(step) * width * (begin + i * step) *
                 pressure.on_circle(begin + i * step, basis).sum();
    }
    return force;
  }

  /// A contact cell is cut along its face where it carries load.
  CellGrid grid_of(const Cell &cell) const
  {
    const unsigned int face = contact_face(cell);
    if (face == numbers::invalid_unsigned_int)
      return { degree, { 1, 1 } };
    return face < 2 ? CellGrid(degree, { 1, n_contact_pieces }) : CellGrid(degree, { n_contact_pieces, 1 });
  }

  void append(const Cell &cell, std::vector<Patch> &patches) const
  {
    const CellGrid grid = grid_of(cell);
    const CellData data = evaluate(cell, grid);
    for (unsigned int sector = 0; sector < n_sectors; ++sector)
      for (unsigned int j = 0; j < grid.n_pieces[1]; ++j)
        for (unsigned int i = 0; i < grid.n_pieces[0]; ++i)
          patches.push_back(make_patch(grid, data, i, j, sector));
  }

  /// The piece of a cell swept over one sector; its coordinates are the cell's two with the azimuth between
  /// them, which makes it right-handed.
  Patch make_patch(const CellGrid &grid, const CellData &data, unsigned int column, unsigned int row,
                   unsigned int sector) const
  {
    const unsigned int n_nodes = degree + 1;
    Patch patch;
    patch.reference_cell = ReferenceCells::Hexahedron;
    patch.n_subdivisions = degree;
    patch.points_are_available = true;
    patch.data.reinit(n_rows, n_nodes * n_nodes * n_nodes);
    for (unsigned int j = 0, node = 0; j < n_nodes; ++j)
      for (unsigned int k = 0; k < n_nodes; ++k)
      {
        const auto &values = data[(sector * degree + k) % basis.n_lines()];
        for (unsigned int i = 0; i < n_nodes; ++i, ++node)
          for (unsigned int r = 0; r < n_rows; ++r)
            patch.data(r, node) =
              static_cast<float>(values(r, grid.index(column * degree + i, row * degree + j)));
      }
    return patch;
  }

  CellData evaluate(const Cell &cell, const CellGrid &grid) const
  {
    const MeridianField::Amplitudes amplitudes = field.amplitudes(cell, grid.points());
    const std::vector<Point<2>> &nodes = amplitudes.points;
    const Eigen::MatrixXd in_phase = amplitudes.in_phase * basis.values().transpose();
    const Eigen::MatrixXd conjugate = amplitudes.conjugate * basis.conjugates().transpose();
    CellData data(basis.n_lines());
    for (unsigned int line = 0; line < basis.n_lines(); ++line)
    {
      data[line].resize(n_rows, nodes.size());
      for (unsigned int node = 0; node < nodes.size(); ++node)
        data[line].col(node) =
          in_slip_frame(nodes[node], basis.azimuth(line) + axis, in_phase.block<6, 1>(6 * node, line),
                        conjugate.block<3, 1>(3 * node, line));
    }
    if (is_contact(cell))
      add_pressure(contact_face(cell), grid, nodes, data);
    return data;
  }

  void add_pressure(unsigned int face, const CellGrid &grid, const std::vector<Point<2>> &nodes,
                    CellData &data) const
  {
    for (unsigned int node = 0; node < nodes.size(); ++node)
      if (grid.is_on_face(node, face))
      {
        const Eigen::VectorXd on_circle = pressure.on_circle(nodes[node][0], basis);
        for (unsigned int line = 0; line < basis.n_lines(); ++line)
          data[line](pressure_row, node) = on_circle(line);
      }
  }

  /// A node's displacement and stress, from cylindrical components, with the table's motion put back on the
  /// glass.
  Eigen::Matrix<double, n_rows, 1> in_slip_frame(const Point<2> &at, double azimuth,
                                                 const Eigen::Matrix<double, 6, 1> &in_phase,
                                                 const Eigen::Vector3d &conjugate) const
  {
    Eigen::Matrix3d axes = Eigen::Matrix3d::Identity(); // columns e_r, e_theta, e_z
    axes.topLeftCorner<2, 2>() = Eigen::Rotation2Dd(azimuth).toRotationMatrix();
    const Eigen::Vector3d point = axes * Eigen::Vector3d(at[0], 0, at[1]);
    const Eigen::Vector2d tilt = motion.tail<2>();
    Eigen::Vector3d displacement = axes * Eigen::Vector3d(in_phase(0), conjugate(0), in_phase(1));
    displacement.head<2>() -= tilt * point(2);
    displacement(2) += motion(0) + tilt.dot(point.head<2>());
    Eigen::Matrix3d stress;
    stress << in_phase(2), conjugate(1), in_phase(5), //
      conjugate(1), in_phase(3), conjugate(2),        //
      in_phase(5), conjugate(2), in_phase(4);
    stress = (axes * stress * axes.transpose()).eval();
    const Eigen::Matrix3d strain = strain_of(stress, field.material());

    Eigen::Matrix<double, n_rows, 1> rows;
    rows.segment<3>(displacement_row) = displacement;
    rows.segment<9>(stress_row) = Eigen::Map<const Eigen::Matrix<double, 9, 1>>(stress.data());
    rows.segment<9>(strain_row) = Eigen::Map<const Eigen::Matrix<double, 9, 1>>(strain.data());
    rows(von_mises_row) = von_mises(stress);
    rows(pressure_row) = 0;
    rows.segment<3>(point_row) = point;
    return rows;
  }

  const MeridianField &field;
  const PressureField &pressure;
  const Eigen::Vector3d motion;
  const double axis;
  const unsigned int degree;
  const unsigned int n_sectors;
  const FourierBasis basis; ///< on the azimuths of the picture's nodes
  const unsigned int n_contact_pieces;
};

} // namespace

void write_revolution_fields(const MeridianField &field, const PressureField &pressure,
                             const Eigen::Vector3d &motion, double axis, std::ostream &file)
{
  PatchWriter writer(FootPicture(field, pressure, motion, axis).patches());
  DataOutBase::VtkFlags flags;
  flags.write_higher_order_cells = field.space().dof_handler().get_fe().degree > 1;
  flags.compression_level = decltype(flags.compression_level)::best_speed;
  flags.print_date_and_time = false; // equal runs give equal files
  writer.set_flags(flags);
  writer.write_vtu(file);
}

std::vector<StressedPatch> revolution_section(const MeridianField &field, double azimuth)
{
  constexpr unsigned int n_points = 2; // of a cell in each direction
  std::vector<Point<2>> unit_points;
  for (unsigned int j = 0; j < n_points; ++j)
    for (unsigned int i = 0; i < n_points; ++i)
      unit_points.emplace_back(i / (n_points - 1.), j / (n_points - 1.));
  std::vector<StressedPatch> patches;
  for (const auto &cell : field.space().dof_handler().active_cell_iterators())
  {
    const MeridianField::Amplitudes amplitudes = field.amplitudes(cell, Quadrature<2>(unit_points));
    for (const int side : { 1, -1 })
    {
      // The modes at the azimuth, and their conjugates.
      Eigen::VectorXd modes(field.n_modes()), conjugates(field.n_modes());
      for (unsigned int mode = 0; mode < field.n_modes(); ++mode)
      {
        const double angle = FourierBasis::harmonic(mode) * (azimuth + (side < 0 ? numbers::PI : 0));
        modes(mode) = FourierBasis::is_sine(mode) ? std::sin(angle) : std::cos(angle);
        conjugates(mode) = mode == 0 ? 0 : FourierBasis::is_sine(mode) ? -std::cos(angle) : std::sin(angle);
      }
      const Eigen::VectorXd in_phase = amplitudes.in_phase * modes,
                            conjugate = amplitudes.conjugate * conjugates;
      StressedPatch patch(n_points);
      for (unsigned int p = 0; p < unit_points.size(); ++p)
      {
        const auto at = in_phase.segment<6>(6 * p);
        const auto across = conjugate.segment<3>(3 * p);
        Eigen::Matrix3d stress;
        stress << at(2), across(1), at(5), across(1), at(3), across(2), at(5), across(2), at(4);
        patch[p / n_points].push_back({ side * amplitudes.points[p][0], amplitudes.points[p][1], side * at(0),
                                        at(1), von_mises(stress) });
      }
      patches.push_back(std::move(patch));
    }
  }
  return patches;
}

} // namespace stemware::fem
