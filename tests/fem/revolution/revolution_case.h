#pragma once

#include "fem/contact/contact_load.h"
#include "fem/contact/winkler_interface.h"
#include "fem/geometry/meridian_mesh.h"
#include "fem/revolution/body_of_revolution.h"
#include "fem/revolution/compliance_cache.h"
#include "tests/fem/reference_load.h"

#include <deal.II/grid/tria.h>

namespace stemware::revolution_tests
{

using namespace stemware::fem;
using namespace stemware::fem_tests;

inline MeridianResolution equal_cells(unsigned int refinements = 0)
{
  MeridianResolution resolution;
  resolution.land_grading = 1;
  resolution.refinements = refinements;
  return resolution;
}

inline MeridianResolution graded_cells(unsigned int refinements = 0)
{
  MeridianResolution resolution;
  resolution.refinements = refinements;
  return resolution;
}

inline ContactCompliance foot_compliance(const GlassProfile &profile, const MeridianResolution &resolution,
                                         const MeridianOptions &options = {})
{
  dealii::Triangulation<2> triangulation;
  make_meridian_mesh(profile, resolution, triangulation);
  return compute_compliance(triangulation, ElasticMaterial(), options);
}

/// Returns int N_i r dr between two radii [m^2], the nodal forces per radian of a unit pressure. Simpson's
/// rule is exact for quadratic elements.
inline Eigen::VectorXd nodes_between(const ContactCompliance &compliance, double inner, double outer)
{
  const Eigen::VectorXd &radii = compliance.radii;
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(radii.size());
  for (Eigen::Index first = 0; first + 2 < radii.size(); first += 2)
    if (radii(first + 1) > inner && radii(first + 1) < outer)
      for (const Eigen::Index node : { 0, 1, 2 })
        weights(first + node) +=
          (node == 1 ? 4 : 1) * (radii(first + 2) - radii(first)) / 6 * radii(first + node);
  return weights;
}

struct RevolutionCase
{
  RevolutionCase(const GlassProfile &profile, const ContactCompliance &compliance, unsigned int n_lines = 256)
      : radius(profile.contact_radius)
      , body(
          compliance, [profile](double r, double) { return profile.gap(r); }, n_lines)
  {
  }

  ContactLoad solve(TableLaw &law, const Resultants &load, unsigned int n_harmonics = 8)
  {
    solution = solve_contact(body, law, load, radius);
    return extract_load(law, solution, n_harmonics);
  }

  ContactLoad solve_on_winkler(double modulus, const Resultants &load, unsigned int n_harmonics = 8)
  {
    const auto mat = make_law(WinklerInterface(modulus), body.contact_surface());
    return solve(*mat, load, n_harmonics);
  }

  double radius;
  BodyOfRevolution body;
  ContactSolution solution;
};

} // namespace stemware::revolution_tests
