// Frictionless axisymmetric punch with rounded edges on a disc: NAFEMS R0094, contact benchmark 2; values of
// Code_Aster SSNA122. The body of revolution allows contact on the axis for n = 0 only. With the compliance
// of n = 0 for every harmonic, the azimuth lines are independent, and each line is an axisymmetric contact.
// At M, the point on the axis at the top of the disc, SSNA122 (cells of 6 mm) gives u_z = -0.130734 mm and
// sigma_zz = -91.1006 MPa with linear elements and -0.132941 mm and -94.1221 MPa with quadratic elements.
// Cells of 0.5, 0.25 and 0.125 mm at the contact edge give -0.13402, -0.13396 and -0.13396 mm, and -87.28,
// -87.21 and -87.21 MPa in this test.
#include "fem/contact/contact_newton.h"
#include "fem/contact/winkler_interface.h"
#include "fem/geometry/boundary_ids.h"
#include "fem/revolution/meridian_field.h"
#include "ring_model/load/constants.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

using stemware::ring::pi;
using namespace dealii;
using namespace stemware::fem;

namespace
{

constexpr double punch_radius = 0.050;
constexpr double punch_height = 0.100;
constexpr double flat_radius = 0.040;
constexpr double edge_radius = 0.010;

struct PunchParameters
{
  ElasticMaterial punch = { 210e9, 0.3 };
  ElasticMaterial disc = { 70e9, 0.3 };
  double disc_radius = 0.100;     ///< [m]
  double disc_height = 0.200;     ///< [m]
  double pressure_on_top = 100e6; ///< [Pa]

  double normal_force() const { return pressure_on_top * pi * punch_radius * punch_radius; }
};

double underside(double radius)
{
  const double x = std::max(radius - flat_radius, 0.);
  return edge_radius - std::sqrt(std::max(edge_radius * edge_radius - x * x, 0.));
}

/// Returns the lengths of cells that fill @p length [m]. The lengths start with @p smallest and grow by the
/// factor @p growth up to @p largest.
std::vector<double> graded_lengths(double length, double smallest, double growth, double largest)
{
  std::vector<double> cells;
  double filled = 0;
  for (double size = smallest; filled < length; size = std::min(size * growth, largest))
  {
    cells.push_back(size);
    filled += size;
  }
  for (double &cell : cells)
    cell *= length / filled;
  return cells;
}

std::vector<double> reversed(std::vector<double> cells)
{
  std::reverse(cells.begin(), cells.end());
  return cells;
}

void append(std::vector<double> &cells, const std::vector<double> &more)
{
  cells.insert(cells.end(), more.begin(), more.end());
}

std::vector<double> equal_lengths(double length, double about)
{
  const long n = std::lround(length / about);
  return std::vector<double>(static_cast<std::size_t>(n), length / static_cast<double>(n));
}

struct PunchCells
{
  std::vector<double> on_contact, on_punch, on_disc; ///< along r, beginning with the contact zone
  std::vector<double> upward, downward;              ///< along z, beginning at the contact

  /// Adds cells along the rounded edge outside the contact zone, in steps of @p angle up to 90 degrees.
  void add_edge(double angle)
  {
    double radius = std::accumulate(on_contact.begin(), on_contact.end(), 0.);
    double at = std::asin((radius - flat_radius) / edge_radius);
    while (at < pi / 2 - 1e-6)
    {
      at = std::min(at + angle, pi / 2);
      const double next = flat_radius + edge_radius * std::sin(at);
      on_punch.push_back(next - radius);
      radius = next;
    }
  }
};

PunchCells fine_cells_of_punch(const PunchParameters &parameters, double smallest)
{
  constexpr double growth = 1.25;
  constexpr double fine = 2e-3; // width of the finely meshed edge zone [m]; contact ends at 40.4 mm
  constexpr double end = 0.045; // outer radius of the contact zone [m]
  PunchCells cells;
  cells.on_contact = reversed(graded_lengths(flat_radius, smallest, growth, 3e-3));
  append(cells.on_contact, equal_lengths(fine, smallest));
  append(cells.on_contact, graded_lengths(end - flat_radius - fine, smallest, growth, 1e-3));
  cells.on_punch = cells.on_disc = cells.on_contact;
  cells.add_edge(pi / 18);
  append(cells.on_disc, graded_lengths(parameters.disc_radius - end, cells.on_contact.back(), growth,
                                       parameters.disc_radius / 16));
  cells.upward = graded_lengths(punch_height, smallest, growth, 6e-3);
  cells.downward = graded_lengths(parameters.disc_height, smallest, growth, parameters.disc_height / 16);
  return cells;
}

/// Meshes a section with cells of the widths @p columns and the heights @p rows, from r = 0 and z = 0. The
/// first @p n_contact faces at z = 0 are the contact zone, faces for which @p held is true are clamped, and
/// @p shape moves the vertices.
void make_section(const std::vector<double> &columns, const std::vector<double> &rows, bool downward,
                  std::size_t n_contact, const std::function<bool(const Point<2> &)> &held,
                  const std::function<Point<2>(const Point<2> &)> &shape, Triangulation<2> &triangulation)
{
  const auto sum = [](const std::vector<double> &cells)
  { return std::accumulate(cells.begin(), cells.end(), 0.); };
  const double height = sum(rows);
  const Point<2> low(0, downward ? -height : 0);
  const Point<2> high(sum(columns), downward ? 0 : height);
  GridGenerator::subdivided_hyper_rectangle(triangulation, { columns, downward ? reversed(rows) : rows }, low,
                                            high);
  const double end =
    std::accumulate(columns.begin(), columns.begin() + static_cast<std::ptrdiff_t>(n_contact), 0.);
  for (const auto &face : triangulation.active_face_iterators())
    if (face->at_boundary())
    {
      const Point<2> centre = face->center();
      const FootBoundary id = std::abs(centre[1]) < 1e-9 * height && centre[0] < end
                                ? FootBoundary::contact_zone
                              : held(centre) ? FootBoundary::stem_cut
                                             : FootBoundary::free;
      face->set_boundary_id(static_cast<types::boundary_id>(id));
    }
  GridTools::transform(shape, triangulation);
}

/// Makes the section of the punch. The innermost face of the top is fixed. Its reaction vanishes, because
/// pressure and contact force are in equilibrium.
void make_punch(const PunchCells &cells, Triangulation<2> &triangulation)
{
  const double spot = cells.on_punch.front();
  make_section(
    cells.on_punch, cells.upward, false, cells.on_contact.size(),
    [=](const Point<2> &x) { return x[1] > punch_height * (1 - 1e-9) && x[0] < spot; },
    [](const Point<2> &x) { return Point<2>(x[0], x[1] + underside(x[0]) * (1 - x[1] / punch_height)); },
    triangulation);
}

void make_disc(const PunchParameters &parameters, const PunchCells &cells, Triangulation<2> &triangulation)
{
  make_section(
    cells.on_disc, cells.downward, true, cells.on_contact.size(),
    [&](const Point<2> &x) { return x[1] < -parameters.disc_height * (1 - 1e-9); },
    [](const Point<2> &x) { return x; }, triangulation);
}

/// Returns the vertical displacement of the contact nodes [m] under @p pressure on the top of the punch.
Eigen::VectorXd displacement_under_top(const MeridianSpace &space, double pressure)
{
  const FiniteElement<2> &element = space.dof_handler().get_fe();
  FEFaceValues<2> values(space.mapping(), element, QGauss<1>(element.degree + 1),
                         update_values | update_quadrature_points | update_JxW_values);
  Vector<double> displacement(space.n_dofs()); // first stores the forces per radian
  std::vector<MeridianSpace::Dof> dofs(element.n_dofs_per_cell());
  for (const auto &cell : space.dof_handler().active_cell_iterators())
    for (const unsigned int face : cell->face_indices())
    {
      if (cell->face(face)->center()[1] < punch_height * (1 - 1e-9))
        continue;
      values.reinit(cell, face);
      cell->get_dof_indices(dofs);
      for (const unsigned int q : values.quadrature_point_indices())
        for (unsigned int i = 0; i < dofs.size(); ++i)
          if (element.system_to_component_index(i).first == 2)
            displacement(dofs[i]) -=
              pressure * values.shape_value(i, q) * values.quadrature_point(q)[0] * values.JxW(q);
    }
  MeridianSpace::Factors(space, 0).solve(displacement);
  Eigen::VectorXd of_contact(space.n_contact_nodes());
  for (unsigned int i = 0; i < space.n_contact_nodes(); ++i)
    of_contact(i) = displacement(space.contact_dofs(i)[2]);
  return of_contact;
}

ContactCompliance axisymmetric_compliance(const MeridianSpace &space)
{
  ContactCompliance compliance;
  compliance.degree = space.dof_handler().get_fe().degree;
  compliance.radii.resize(space.n_contact_nodes());
  for (unsigned int i = 0; i < space.n_contact_nodes(); ++i)
    compliance.radii(i) = space.contact_radius(i);
  compliance.tail = MeridianSpace::Compliances(space, 0, 0, space.n_contact_nodes())(0);
  compliance.harmonics = { compliance.tail, compliance.tail };
  return compliance;
}

/// Punch pressed on the disc. M is the point on the axis at the top of the disc.
struct PressedPunch
{
  /// Solves the contact. @p smallest: cell length at the contact edge [m]. @p modulus: foundation modulus of
  /// a stiff mat that approximates the hard interface [Pa/m].
  explicit PressedPunch(double smallest, double modulus = 1e17)
  {
    const PunchParameters parameters;
    const PunchCells cells = fine_cells_of_punch(parameters, smallest);
    Triangulation<2> punch_section, disc_section;
    make_punch(cells, punch_section);
    make_disc(parameters, cells, disc_section);
    const MeridianSpace punch(punch_section, parameters.punch, 2);
    const MeridianSpace disc(disc_section, parameters.disc, 2);

    ContactCompliance compliance = axisymmetric_compliance(punch);
    compliance += axisymmetric_compliance(disc);
    const Eigen::VectorXd &radii = compliance.radii;
    const Eigen::VectorXd under_top = displacement_under_top(punch, parameters.pressure_on_top);
    BodyOfRevolution body(
      compliance, [&](double r, double) { return underside(r) + compliance.shape_at(r).dot(under_top); }, 4);

    ContactControl control;
    control.tolerance = 1e-10;
    control.requires_unchanged_set = false;
    const auto law = WinklerInterface(modulus).make(body.contact_surface(), 0);
    const ContactSolution solution =
      solve_contact(body, *law, Resultants{ parameters.normal_force(), 0, 0 }, punch_radius, control);
    pressure = law->nodal_pressure(solution).head(radii.size());
    for (Eigen::Index i = 0; i < radii.size(); ++i)
      if (pressure(i) > 0)
        contact_radius = radii(i);
    const Eigen::VectorXd forces = body.forces().rowwise().sum();
    force = forces.sum();
    evaluate_at_m(MeridianField(disc, parameters.disc, { -forces, {}, {} }));
  }

  double displacement = 0;   ///< u_z(M) [m]
  double stress = 0;         ///< sigma_zz(M) in the disc [Pa]
  Eigen::VectorXd pressure;  ///< at the contact nodes [Pa]
  double force = 0;          ///< total contact force [N]
  double contact_radius = 0; ///< radius of the outermost node under pressure [m]

private:
  void evaluate_at_m(const MeridianField &field)
  {
    for (const auto &cell : field.space().dof_handler().active_cell_iterators())
      for (const unsigned int v : cell->vertex_indices())
        if (cell->vertex(v).norm() < 1e-12)
        {
          const auto at_m = field.amplitudes(cell, Quadrature<2>(GeometryInfo<2>::unit_cell_vertex(v)));
          displacement = at_m.in_phase(1, 0);
          stress = at_m.in_phase(4, 0);
        }
  }
};

double deviation(double value, double reference)
{
  return std::abs(value / reference - 1);
}

} // namespace

TEST(NafemsPunch, FineMeshesConvergeToTheBenchmark)
{
  const PressedPunch coarser = PressedPunch(5e-4);
  const PressedPunch punch = PressedPunch(2.5e-4);
  EXPECT_LT(deviation(punch.force, PunchParameters().normal_force()), 1e-12);
  EXPECT_LT(deviation(coarser.displacement, punch.displacement), 6e-4);
  EXPECT_LT(deviation(coarser.stress, punch.stress), 1e-3);
  // The stress in the disc at M equals minus the contact pressure.
  EXPECT_LT(deviation(punch.stress, -punch.pressure(0)), 5e-5);
  EXPECT_LT(deviation(PressedPunch(2.5e-4, 1e18).displacement, punch.displacement), 2e-5);
  EXPECT_NEAR(punch.contact_radius, 0.0402, 2e-4);
  EXPECT_LT(deviation(punch.displacement, -0.132941e-3), 0.01); // SSNA122, quadratic elements
  EXPECT_LT(deviation(punch.displacement, -0.130734e-3), 0.03); // SSNA122, linear elements
  EXPECT_LT(deviation(punch.stress, -91.1006e6), 0.05);
}
