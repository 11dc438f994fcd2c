// Patch tests of the meridian problem of one harmonic. References: harmonic potentials and Code_Aster
// SSLV109.
#include "fem/revolution/block_inverse.h"
#include "fem/revolution/meridian_stiffness.h"
#include "tests/ulps.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q1.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>

#include <Eigen/SparseCholesky>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

using namespace dealii;
using namespace stemware::fem;

namespace
{

/// Amplitudes of u_r cos(n theta), u_theta sin(n theta), u_z cos(n theta) at (r, z).
using Field = std::function<Tensor<1, 3>(const Point<2> &)>;

constexpr types::boundary_id top = 3; // boundary id of the upper side of a rectangle in deal.II

/// Stiffness K_n of the cylinder 0 <= r <= 1, 0 <= z <= length, on distorted cells with hanging nodes.
struct Cylinder
{
  Cylinder(double length, unsigned int degree, const ElasticMaterial &material)
      : element(FE_Q<2>(degree), 3)
      , dofs(triangulation)
  {
    GridGenerator::subdivided_hyper_rectangle(triangulation, { 3, 3 }, Point<2>(0, 0), Point<2>(1, length),
                                              true);
    GridTools::distort_random(0.15, triangulation, true, 3);
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->active_cell_index() % 4 == 0)
        cell->set_refine_flag();
    triangulation.execute_coarsening_and_refinement();
    dofs.distribute_dofs(element);
    points.resize(dofs.n_dofs());
    DoFTools::map_dofs_to_support_points(mapping, dofs, points);
    components.resize(dofs.n_dofs());
    std::vector<types::global_dof_index> of_cell(element.n_dofs_per_cell());
    for (const auto &cell : dofs.active_cell_iterators())
    {
      cell->get_dof_indices(of_cell);
      for (unsigned int i = 0; i < of_cell.size(); ++i)
        components[of_cell[i]] = element.system_to_component_index(i).first;
    }
    stiffness = std::make_unique<MeridianStiffness>(mapping, dofs, material);
  }

  Vector<double> nodal_values(const Field &field) const
  {
    Vector<double> values(dofs.n_dofs());
    for (unsigned int i = 0; i < dofs.n_dofs(); ++i)
      values(i) = field(points[i])[components[i]];
    return values;
  }

  void assemble(unsigned int harmonic, const AffineConstraints<double> &constraints, SparsityPattern &pattern,
                SparseMatrix<double> &matrix) const
  {
    DynamicSparsityPattern dynamic(dofs.n_dofs());
    DoFTools::make_sparsity_pattern(dofs, dynamic, constraints, false);
    pattern.copy_from(dynamic);
    matrix.reinit(pattern);
    stiffness->assemble(MeridianStiffness::factors_of(harmonic), constraints, matrix);
  }

  AffineConstraints<double> hanging_nodes() const
  {
    AffineConstraints<double> constraints;
    DoFTools::make_hanging_node_constraints(dofs, constraints);
    constraints.close();
    return constraints;
  }

  /// Returns the largest force |K_n u| at the inner nodes, divided by the largest product of a diagonal entry
  /// of K_n and its displacement.
  double unbalanced_force(unsigned int harmonic, const Field &field) const
  {
    AffineConstraints<double> none;
    none.close();
    SparsityPattern pattern;
    SparseMatrix<double> matrix;
    assemble(harmonic, none, pattern, matrix);
    const Vector<double> displacement = nodal_values(field);
    Vector<double> force(dofs.n_dofs());
    matrix.vmult(force, displacement);
    const AffineConstraints<double> constraints = hanging_nodes();
    constraints.condense(force);
    const IndexSet boundary = DoFTools::extract_boundary_dofs(dofs);
    double unbalanced = 0;
    double size = 0;
    for (unsigned int i = 0; i < dofs.n_dofs(); ++i)
      if (!boundary.is_element(i) && !constraints.is_constrained(i))
      {
        unbalanced = std::max(unbalanced, std::abs(force(i)));
        size = std::max(size, std::abs(matrix(i, i) * displacement(i)));
      }
    return unbalanced / size;
  }

  const MappingQ1<2> mapping;
  Triangulation<2> triangulation;
  const FESystem<2> element;
  DoFHandler<2> dofs;
  std::vector<Point<2>> points;
  std::vector<unsigned int> components;
  std::unique_ptr<MeridianStiffness> stiffness;
};

} // namespace

/// Closed form: u = grad(r^n cos(n theta)) has zero divergence and zero curl, so every isotropic material is
/// in equilibrium without body forces. Elements of degree n - 1 represent u exactly, elements of degree n - 2
/// do not.
TEST(FourierPatch, GradientsOfHarmonicPolynomialsAreInEquilibriumOnlyAtSufficientDegree)
{
  for (const unsigned int n : { 2u, 3u, 4u, 5u })
  {
    const Field gradient = [n](const Point<2> &x)
    {
      const double amplitude = n * std::pow(x[0], n - 1);
      return Tensor<1, 3>({ amplitude, -amplitude, 0. });
    };
    EXPECT_LT(Cylinder(1, n - 1, ElasticMaterial{ 72, 0.3 }).unbalanced_force(n, gradient), 1e-12)
      << "n = " << n;
    if (n > 2)
    {
      EXPECT_GT(Cylinder(1, n - 2, ElasticMaterial{ 72, 0.3 }).unbalanced_force(n, gradient), 1e-5)
        << "n = " << n;
    }
  }
}

/// Closed form: u = grad(z r^n cos(n theta)) shears the meridian. Divergence and curl of u vanish.
TEST(FourierPatch, HarmonicGradientFieldsThatShearTheMeridianNeedNoBodyForces)
{
  for (const unsigned int n : { 1u, 2u, 3u, 4u })
  {
    const Field gradient = [n](const Point<2> &x)
    {
      const double amplitude = n * std::pow(x[0], n - 1) * x[1];
      return Tensor<1, 3>({ amplitude, -amplitude, std::pow(x[0], n) });
    };
    EXPECT_LT(Cylinder(1, n, ElasticMaterial{ 72, 0.3 }).unbalanced_force(n, gradient), 1e-12) << "n = " << n;
  }
}

/// Code_Aster SSLV109, n = 1: the end traction sigma_zz = r cos(theta) bends a cylinder of radius 1 and
/// length 6 with E = 72 and nu = 0.3. Solution with kappa = 1/72: u_r = -kappa (z^2 + nu r^2) / 2, u_theta =
/// kappa (z^2 - nu r^2) / 2, u_z = kappa r z. Quadratic elements represent this solution exactly.
TEST(FourierPatch, CylinderBendsAsInSSLV109)
{
  const ElasticMaterial material{ 72, 0.3 };
  const double length = 6;
  const double kappa = 1 / material.young_modulus;
  const Field exact = [&](const Point<2> &x)
  {
    const double squeeze = material.poisson_ratio * x[0] * x[0];
    return Tensor<1, 3>(
      { -kappa * (x[1] * x[1] + squeeze) / 2, kappa * (x[1] * x[1] - squeeze) / 2, kappa * x[0] * x[1] });
  };
  EXPECT_NEAR(-exact({ 0, 6 })[0], 0.25, stemware::ulps(18, 0.25));
  EXPECT_NEAR(-exact({ 1, 0 })[0], 2.08333e-3, 5e-9);

  const Cylinder cylinder(length, 2, material);
  AffineConstraints<double> constraints;
  DoFTools::make_hanging_node_constraints(cylinder.dofs, constraints);
  for (unsigned int i = 0; i < cylinder.dofs.n_dofs(); ++i)
  {
    // On the axis, u_theta = -u_r and u_z = 0. The bottom slides in its plane, and its centre is fixed.
    if (constraints.is_constrained(i))
      continue;
    const bool on_axis = cylinder.points[i][0] < 1e-12;
    const bool on_bottom = cylinder.points[i][1] < 1e-12;
    if ((cylinder.components[i] == 2 && (on_axis || on_bottom)) ||
        (cylinder.components[i] != 2 && on_axis && on_bottom))
      constraints.add_line(i);
    else if (cylinder.components[i] == 1 && on_axis)
      for (unsigned int j = 0; j < cylinder.dofs.n_dofs(); ++j)
        if (cylinder.components[j] == 0 && cylinder.points[j].distance(cylinder.points[i]) < 1e-12)
        {
          constraints.add_line(i);
          constraints.add_entry(i, j, -1);
        }
  }
  constraints.close();

  Vector<double> forces(cylinder.dofs.n_dofs());
  FEFaceValues<2> values(cylinder.mapping, cylinder.element, QGauss<1>(4),
                         update_values | update_quadrature_points | update_JxW_values);
  std::vector<types::global_dof_index> of_cell(cylinder.element.n_dofs_per_cell());
  Vector<double> cell_forces(cylinder.element.n_dofs_per_cell());
  for (const auto &cell : cylinder.dofs.active_cell_iterators())
    for (const unsigned int face : cell->face_indices())
    {
      if (!cell->at_boundary(face) || cell->face(face)->boundary_id() != top)
        continue;
      values.reinit(cell, face);
      cell->get_dof_indices(of_cell);
      cell_forces = 0;
      for (const unsigned int q : values.quadrature_point_indices())
        for (unsigned int i = 0; i < of_cell.size(); ++i)
          if (cylinder.element.system_to_component_index(i).first == 2)
          {
            const double radius = values.quadrature_point(q)[0];
            cell_forces(i) += values.shape_value(i, q) * radius * radius * values.JxW(q);
          }
      constraints.distribute_local_to_global(cell_forces, of_cell, forces);
    }

  SparsityPattern pattern;
  SparseMatrix<double> matrix;
  cylinder.assemble(1, constraints, pattern, matrix);
  const Eigen::SimplicialLLT<LowerTriangle> factors(lower_triangle_of(matrix));
  const Eigen::VectorXd solution =
    factors.solve(Eigen::Map<const Eigen::VectorXd>(forces.begin(), forces.size()));
  Vector<double> displacement(cylinder.dofs.n_dofs());
  std::copy(solution.data(), solution.data() + solution.size(), displacement.begin());
  constraints.distribute(displacement);
  displacement -= cylinder.nodal_values(exact);
  EXPECT_LT(displacement.linfty_norm(), 1e-10 * 0.25); // the stiffness of a slender beam is ill-conditioned
}
