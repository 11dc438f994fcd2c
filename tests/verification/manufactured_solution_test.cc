// Manufactured solution: u = d cos(k . x) with the amplitude d and the wave vector k. The body force is
// ((lambda + mu)(d . k) k + mu |k|^2 d) cos(k . x).
#include "fem/solid/stiffness_3d.h"
#include "tests/fem/multiply.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria.h>
#include <deal.II/lac/trilinos_solver.h>
#include <deal.II/numerics/vector_tools.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace dealii;
using namespace stemware::fem;

namespace
{

const Tensor<1, 3> wave({ 2.1, -1.3, 0.7 });
const Tensor<1, 3> amplitude({ 0.8, 0.5, -1.1 });
const ElasticMaterial material{ 3., 0.3 };

class Displacement : public Function<3>
{
public:
  Displacement()
      : Function<3>(3)
  {
  }
  double value(const Point<3> &x, unsigned int component) const override
  {
    return amplitude[component] * std::cos(wave * x);
  }
};

class BodyForce : public Function<3>
{
public:
  BodyForce()
      : Function<3>(3)
  {
  }
  double value(const Point<3> &x, unsigned int component) const override
  {
    const double lambda = material.lame_lambda();
    const double mu = material.shear_modulus();
    return std::cos(wave * x) * ((lambda + mu) * (amplitude * wave) * wave[component] +
                                 mu * wave.norm_square() * amplitude[component]);
  }
};

/// Returns the L2 error on a cube of n^3 cells with randomly displaced inner vertices (fixed seed).
double l2_error(unsigned int degree, unsigned int n)
{
  Triangulation<3> triangulation;
  GridGenerator::subdivided_hyper_cube(triangulation, n);
  GridTools::distort_random(0.1, triangulation, true, 3);
  const MappingQ<3> mapping(1);
  const FESystem<3> element(FE_Q<3>(degree), 3);
  DoFHandler<3> dof_handler(triangulation);
  dof_handler.distribute_dofs(element);
  const Displacement exact;
  AffineConstraints<double> constraints;
  VectorTools::interpolate_boundary_values(mapping, dof_handler, 0, exact, constraints);
  constraints.close();

  // The boundary displacement is lifted into the solution, and the solver computes a correction with zero
  // boundary values.
  const IndexSet dofs = complete_index_set(dof_handler.n_dofs());
  TrilinosWrappers::MPI::Vector solution(dofs, MPI_COMM_SELF), missing(dofs, MPI_COMM_SELF),
    rhs(dofs, MPI_COMM_SELF);
  constraints.distribute(solution);
  AffineConstraints<double> none, held;
  none.close();
  DoFTools::make_zero_boundary_constraints(dof_handler, 0, held);
  held.close();
  TrilinosWrappers::SparseMatrix free_stiffness, stiffness;
  assemble_stiffness(mapping, dof_handler, material, none, free_stiffness);
  assemble_stiffness(mapping, dof_handler, material, held, stiffness);
  VectorTools::create_right_hand_side(mapping, dof_handler, QGauss<3>(degree + 1), BodyForce(), missing);
  stemware::fem_tests::multiply(free_stiffness, rhs, solution);
  rhs.sadd(-1, 1, missing);
  held.set_zero(rhs);
  SolverControl control;
  TrilinosWrappers::SolverDirect solver(control);
  solver.solve(stiffness, missing, rhs);
  held.distribute(missing);
  solution += missing;

  Vector<double> cell_errors(triangulation.n_active_cells());
  VectorTools::integrate_difference(mapping, dof_handler, solution, exact, cell_errors, QGauss<3>(degree + 3),
                                    VectorTools::L2_norm);
  return cell_errors.l2_norm();
}

} // namespace

TEST(ManufacturedSolution, LinearElementsConvergeAtSecondOrder)
{
  const double order = std::log2(l2_error(1, 6) / l2_error(1, 12));
  EXPECT_GT(order, 1.85);
  EXPECT_LT(order, 2.25);
}

TEST(ManufacturedSolution, QuadraticElementsConvergeAtThirdOrder)
{
  const double order = std::log2(l2_error(2, 4) / l2_error(2, 8));
  EXPECT_GT(order, 2.85);
  EXPECT_LT(order, 3.3);
}
