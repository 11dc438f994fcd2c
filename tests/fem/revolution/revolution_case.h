#pragma once

#include "fem/contact/load_harmonics.h"
#include "fem/geometry/meridian_mesh.h"
#include "fem/revolution/body_of_revolution.h"
#include "fem/revolution/meridian_problem.h"

#include <deal.II/grid/tria.h>

#include <cmath>
#include <memory>

namespace stemware::revolution_tests
{

using namespace stemware::fem;

/// The weight of the reference cases, 0.30 kg at 9.81 m/s^2 [N].
constexpr double weight = 2.943;

/// Resultants of a load with moment ratio @p m (of N R / 2) whose maximum lies at azimuth @p direction.
inline ContactLoad load_at(double m, double direction = 0, double radius = 0.03)
{
  const double moment = m * weight * radius / 2;
  return { weight, moment * std::sin(direction), -moment * std::cos(direction) };
}

/// The flat foot of the reference: land 2 mm wide, no crown.
inline GlassProfile flat_profile()
{
  GlassProfile profile;
  profile.land_width = 0.002;
  profile.crown_radius = 0;
  return profile;
}

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

/// A foot that is a body of revolution with everything that a contact solve needs.
struct RevolutionCase
{
  RevolutionCase(const GlassProfile &profile, const ContactCompliance &compliance, unsigned int n_lines = 256)
      : radius(profile.contact_radius)
      , body(
          compliance, [profile](double r, double) { return profile.gap(r); }, n_lines)
  {
  }

  LoadHarmonics press(TableLaw &law, const ContactLoad &load, unsigned int n_harmonics = 8)
  {
    solution = solve_contact(body, law, load, radius);
    return extract_load(law, solution, n_harmonics);
  }

  LoadHarmonics press_on_mat(double modulus, const ContactLoad &load, unsigned int n_harmonics = 8)
  {
    const auto mat = make_mat(body.contact_surface(), modulus);
    return press(*mat, load, n_harmonics);
  }

  double radius;
  BodyOfRevolution body;
  ContactSolution solution;
};

} // namespace stemware::revolution_tests
