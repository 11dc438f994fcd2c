#include "fem/solid/mesh_hierarchy.h"
#include "fem/solid/nested_contact.h"
#include "fem/solid/stiffness_3d.h"
#include "tests/fem/foot_case.h"

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/lac/trilinos_sparsity_pattern.h>

#include <gtest/gtest.h>

using namespace stemware::fem_tests;

namespace
{

FootResolution refined(unsigned int refinements)
{
  return { 24, 2, 1, refinements };
}

SolidOptions options_of(unsigned int degree)
{
  SolidOptions options;
  options.degree = degree;
  return options;
}

ContactSolution solve_nested(FootCase &foot, const InterfaceLaw &interface, const Resultants &load)
{
  const std::optional<ContactStart> start =
    start_from_coarser_mesh(*foot.body, interface, 1, load, foot.radius);
  EXPECT_TRUE(start);
  const auto law = make_law(interface, foot.body->contact_surface());
  return solve_contact(*foot.body, *law, load, foot.radius, {}, start ? &*start : nullptr);
}

NewtonIncrement solve_linear(FootCase &foot, const InterfaceLaw &interface, const ContactSolution &contact,
                             const Resultants &load)
{
  ContactForces forces;
  make_law(interface, foot.body->contact_surface())->evaluate(contact.normal_displacement, forces);
  foot.body->reset();
  return foot.body->solve(forces.tangent, forces.forces,
                          prescribed_resultants(foot.body->contact_surface(), load), { 0, 0, 0 });
}

} // namespace

template <typename Number>
void expect_the_assembled_matrix(unsigned int degree, unsigned int edge_halvings, double tolerance)
{
  dealii::parallel::distributed::Triangulation<3> mesh(MPI_COMM_WORLD);
  make_foot_mesh(GlassProfile(), { 12, 2, 1, 0, edge_halvings }, mesh);
  const SolidLevel level(std::shared_ptr<const dealii::Triangulation<3>>(&mesh, [](const auto *) {}), degree,
                         degree);
  const dealii::IndexSet &owned = level.dof_handler.locally_owned_dofs();
  dealii::TrilinosWrappers::SparseMatrix matrix;
  assemble_stiffness(level.mapping, level.dof_handler, ElasticMaterial(), level.constraints, matrix);

  const auto stiffness =
    make_elastic_operator<Number>(level.mapping, level.dof_handler, level.constraints, ElasticMaterial());
  typename ElasticOperator<Number>::Vector from, to, diagonal;
  stiffness->initialize_dof_vector(from);
  stiffness->initialize_dof_vector(to);
  dealii::TrilinosWrappers::MPI::Vector predict_from(owned, MPI_COMM_WORLD),
    expected_to(owned, MPI_COMM_WORLD);
  for (const auto i : owned)
  {
    const double value = level.constraints.is_constrained(i) ? 0 : std::sin(1.7 * static_cast<double>(i));
    from(i) = static_cast<Number>(value);
    predict_from(i) = value;
  }
  multiply(matrix, expected_to, predict_from);
  stiffness->vmult(to, from);
  stiffness->compute_diagonal(diagonal);
  const double scale = expected_to.linfty_norm();
  double error = 0, diagonal_error = 0;
  for (const auto i : owned)
    if (!level.constraints.is_constrained(i))
    {
      error = std::max(error, std::abs(to(i) - expected_to(i)) / scale);
      diagonal_error = std::max(diagonal_error, std::abs(diagonal(i) / matrix.diag_element(i) - 1));
    }
  EXPECT_LT(error, tolerance) << "degree " << degree;
  EXPECT_LT(diagonal_error, tolerance) << "degree " << degree;
}

TEST(MatrixFree, OperatorEqualsTheAssembledMatrix)
{
  for (const unsigned int degree : { 1u, 2u, 3u })
  {
    for (const unsigned int edge_halvings : { 0u, 1u })
    {
      expect_the_assembled_matrix<double>(degree, edge_halvings, 1e-12);
      expect_the_assembled_matrix<float>(degree, edge_halvings, 1e-5);
    }
  }
}

namespace
{

void expect_the_increment_of_the_factorisation(const GlassProfile &profile, const FootResolution &resolution,
                                               unsigned int degree)
{
  SCOPED_TRACE("degree " + std::to_string(degree) + ", crown " + std::to_string(profile.crown_radius));
  FootCase direct(profile, resolution, options_of(degree), TestSolver::factors);
  FootCase multigrid(profile, resolution, options_of(degree));
  for (FootCase *foot : { &direct, &multigrid })
    foot->body->set_linear_tolerance(1e-11);
  const WinklerInterface mat(1e11);
  direct.solve_on_winkler(1e11, load_at(1.3));
  const NewtonIncrement expected = solve_linear(direct, mat, direct.solution, load_at(1.3));
  const NewtonIncrement found = solve_linear(multigrid, mat, direct.solution, load_at(1.3));
  expect_equal(found, expected);
}

void expect_iterations_that_hardly_grow(const GlassProfile &profile, FootResolution resolution,
                                        unsigned int degree, unsigned int finest)
{
  unsigned int before = 0;
  for (resolution.refinements = 1; resolution.refinements <= finest; ++resolution.refinements)
  {
    FootCase foot(profile, resolution, options_of(degree));
    foot.body->set_linear_tolerance(1e-8);
    const WinklerInterface mat(1e11);
    const ContactSolution contact = solve_nested(foot, mat, load_at(1.3));
    const unsigned int iterations = solve_linear(foot, mat, contact, load_at(1.3)).linear_iterations;
    EXPECT_LE(iterations, 25u) << "Q" << degree << ", " << resolution.refinements << " refinements";
    if (before > 0)
    {
      EXPECT_LE(iterations, before + 2) << "Q" << degree << ", " << resolution.refinements << " refinements";
    }
    before = iterations;
  }
}

} // namespace

TEST(Multigrid, AgreesWithTheFactorisation)
{
  // Cases: hanging nodes in the contact of a crowned foot; a flat foot with quadratic elements on the fine
  // level and linear elements on the coarse levels.
  expect_the_increment_of_the_factorisation(GlassProfile(), { 12, 2, 1, 1, 1 }, 1);
  expect_the_increment_of_the_factorisation(flat_profile(), { 12, 2, 1 }, 2);
}

TEST(Multigrid, IterationsHardlyGrowWithRefinement)
{
  expect_iterations_that_hardly_grow(GlassProfile(), { 24, 2, 1 }, 1, 2);
}

TEST(Multigrid, IterationsHardlyGrowWithRefinementLong)
{
  // The program multigrid_benchmark measures more levels (docs/method/solid_measurements.md).
  for (const GlassProfile &profile : { GlassProfile(), flat_profile() })
  {
    expect_iterations_that_hardly_grow(profile, { 48, 2, 2 }, 1, 2);
    expect_iterations_that_hardly_grow(profile, { 48, 2, 2 }, 2, 1);
  }
}

TEST(Multigrid, NestedIterationAgreesWithTheFactorisation)
{
  const WinklerInterface mat(1e11);
  FootCase direct(GlassProfile(), refined(1), options_of(2), TestSolver::factors);
  FootCase multigrid(GlassProfile(), refined(1), options_of(2));
  const auto law = make_law(mat, direct.body->contact_surface());
  const ContactLoad expected = direct.solve(*law, load_at(1.3, 0.4));
  const ContactSolution found = solve_nested(multigrid, mat, load_at(1.3, 0.4));
  const ContactLoad load = extract_load(*law, found, 8);
  for (unsigned int n = 0; n <= 8; ++n)
    EXPECT_NEAR(load.a(n) / load.a(0), expected.a(n) / expected.a(0), 1e-9) << "n = " << n;
  EXPECT_LE(found.n_iterations, 6u);
  EXPECT_LE(found.equilibrium_residual, 1e-9);
}

TEST(Multigrid, MomentBalanceWithFrictionArmAndTiltAgreesWithTheFactorisation)
{
  // A friction arm of half the radius and a tilt moment make the system unsymmetric.
  FootCase direct(GlassProfile(), { 12, 2, 1, 1 }, options_of(2), TestSolver::factors);
  FootCase multigrid(GlassProfile(), { 12, 2, 1, 1 }, options_of(2));
  const auto conditions_on = [](const ContactSurface &surface)
  {
    Eigen::MatrixX3d weights = surface.motion_modes();
    weights.col(1).array() += 0.015 * surface.node_position.col(1).array() / 0.03;
    weights.col(2).array() += 0.004;
    const Eigen::Matrix3d leaning = Eigen::Vector3d(0, 0.2, 0.2).asDiagonal();
    return LinearConditions(surface, weights, { weight, 0.6 * weight * 0.015, 0.2 * weight * 0.015 },
                            leaning);
  };
  std::vector<ContactSolution> solutions;
  for (FootCase *foot : { &direct, &multigrid })
  {
    const ContactSurface &surface = foot->body->contact_surface();
    const auto law = make_law(WinklerInterface(1e10), surface);
    solutions.push_back(solve_contact(*foot->body, *law, conditions_on(surface), foot->radius));
  }
  EXPECT_LT((solutions[0].motion - solutions[1].motion).norm(), 1e-9 * solutions[0].motion.norm());
  const SurfaceParts &parts = direct.body->contact_surface().parts;
  const double difference = parts.sum((solutions[0].forces - solutions[1].forces).squaredNorm());
  EXPECT_LT(difference, 1e-16 * parts.sum(solutions[0].forces.squaredNorm()));
}
