#pragma once

#include "fem/contact/contact_load.h"
#include "fem/contact/winkler_interface.h"
#include "fem/geometry/foot_mesh.h"
#include "tests/fem/factorized_body.h"
#include "tests/fem/reference_load.h"

#include <deal.II/distributed/tria.h>

#include <cmath>
#include <memory>

namespace stemware::fem_tests
{

/// A generated solid foot and its last contact solution.
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
