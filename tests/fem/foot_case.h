#pragma once

#include "fem/contact/contact_load.h"
#include "fem/contact/winkler_interface.h"
#include "fem/geometry/foot_mesh.h"
#include "fem/solid/solid_body.h"
#include "fem/solid/solid_contact_zone.h"
#include "fem/solid/stiffness_3d.h"
#include "tests/fem/multiply.h"
#include "tests/fem/reference_load.h"

#include <deal.II/distributed/tria.h>
#include <deal.II/lac/trilinos_solver.h>

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

namespace stemware::fem_tests
{

/// Assembled stiffness K with a direct factorisation of K + B' T B, the reference for multigrid. B restricts
/// to the contact nodes, T is the contact tangent.
class FactorizedStiffness : public BodyStiffness
{
public:
  FactorizedStiffness(const dealii::Triangulation<3> &triangulation, unsigned int degree,
                      unsigned int mapping_degree, const ElasticMaterial &material)
      : BodyStiffness(std::make_shared<MeshHierarchy>(
                        std::vector<LevelElements>{ { { std::shared_ptr<void>(), &triangulation }, degree } },
                        mapping_degree, material),
                      0, material)
  {
    assemble_stiffness(mesh().mapping, mesh().dof_handler, material, mesh().constraints, stiffness);
  }

  void vmult(Vector &dst, const Vector &src) const override { multiply(stiffness, dst, src); }
  void set_contact(const Eigen::SparseMatrix<double> &tangent) override
  {
    factors.reset(); // the factors hold a reference to `sum`
    sum.copy_from(stiffness);
    for (const ContactNodes::Entry &entry : contact_nodes()->owned_rows(tangent))
      sum.add(entry.row, entry.column, entry.value);
    sum.compress(dealii::VectorOperation::add);
    using Solver = dealii::TrilinosWrappers::SolverDirect;
    factors = std::make_unique<Solver>(control, Solver::AdditionalData(false, "Amesos_Mumps"));
    factors->initialize(sum);
  }
  void precondition(Vector &dst, const Vector &src) const override { factors->solve(dst, src); }

private:
  dealii::TrilinosWrappers::SparseMatrix stiffness, sum;
  dealii::SolverControl control;
  std::unique_ptr<dealii::TrilinosWrappers::SolverDirect> factors;
};

inline void expect_equal(const NewtonIncrement &found, const NewtonIncrement &expected)
{
  const double largest = expected.displacement.lpNorm<Eigen::Infinity>();
  EXPECT_LT((found.displacement - expected.displacement).lpNorm<Eigen::Infinity>(), 1e-8 * largest);
  EXPECT_LT((found.motion - expected.motion).norm(), 1e-8 * expected.motion.norm());
  EXPECT_NEAR(found.energy_curvature / expected.energy_curvature, 1, 1e-8);
}

enum class TestSolver
{
  factors, ///< FactorizedStiffness
  multigrid
};

inline std::unique_ptr<SolidBody> make_body(TestSolver solver, const dealii::Triangulation<3> &triangulation,
                                            const SolidGap &gap, const SolidOptions &options = {},
                                            const ElasticMaterial &material = {})
{
  if (solver == TestSolver::multigrid)
    return std::make_unique<SolidBody>(triangulation, material, gap, options);
  const unsigned int mapping_degree = options.straight_edges ? 1 : options.degree;
  return std::make_unique<SolidBody>(
    std::make_unique<FactorizedStiffness>(triangulation, options.degree, mapping_degree, material), gap);
}

struct FootCase
{
  FootCase(const GlassProfile &profile, const FootResolution &resolution, const SolidOptions &options = {},
           TestSolver solver = TestSolver::multigrid)
      : triangulation(MPI_COMM_WORLD)
      , radius(profile.contact_radius)
  {
    make_foot_mesh(profile, resolution, triangulation);
    body = make_body(
      solver, triangulation, [profile](double x, double y) { return profile.gap(std::hypot(x, y)); },
      options);
  }

  ContactLoad solve(TableLaw &law, const Resultants &load, unsigned int n_harmonics = 8)
  {
    solution = solve_contact(*body, law, load, radius);
    return extract_load(law, solution, n_harmonics);
  }

  ContactLoad solve_on_winkler(double modulus, const Resultants &load, unsigned int n_harmonics = 8)
  {
    const auto mat = make_law(WinklerInterface(modulus), body->contact_surface());
    return solve(*mat, load, n_harmonics);
  }

  dealii::parallel::distributed::Triangulation<3> triangulation;
  double radius;
  std::unique_ptr<SolidBody> body;
  ContactSolution solution;
};

} // namespace stemware::fem_tests
