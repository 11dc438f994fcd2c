#pragma once

#include "fem/contact/load_harmonics.h"
#include "fem/geometry/foot_mesh.h"
#include "fem/solid/solid_body.h"

#include <deal.II/distributed/tria.h>
#include <deal.II/grid/grid_tools.h>

#include <cmath>
#include <memory>

namespace stemware::fem_tests
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

/// A generated foot with everything that a contact solve needs.
struct FootCase
{
  FootCase(const GlassProfile &profile, const FootResolution &resolution, const SolidOptions &options = {},
           const ElasticMaterial &material = {}, double rotation = 0)
      : triangulation(MPI_COMM_WORLD)
      , radius(profile.contact_radius)
  {
    make_foot_mesh(profile, resolution, triangulation);
    if (rotation != 0)
      dealii::GridTools::rotate(rotation, 2, triangulation);
    body = std::make_unique<SolidBody>(
      triangulation, material, [profile](double x, double y) { return profile.gap(std::hypot(x, y)); },
      options);
  }

  LoadHarmonics press(TableLaw &law, const ContactLoad &load, unsigned int n_harmonics = 8)
  {
    solution = solve_contact(*body, law, load, radius);
    return extract_load(law, solution, n_harmonics);
  }

  LoadHarmonics press_on_mat(double modulus, const ContactLoad &load, unsigned int n_harmonics = 8)
  {
    const auto mat = make_mat(body->contact_surface(), modulus);
    return press(*mat, load, n_harmonics);
  }

  dealii::parallel::distributed::Triangulation<3> triangulation;
  double radius;
  std::unique_ptr<SolidBody> body;
  ContactSolution solution;
};

/// The flat foot of the reference: land 2 mm wide, no crown.
inline GlassProfile flat_profile()
{
  GlassProfile profile;
  profile.land_width = 0.002;
  profile.crown_radius = 0;
  return profile;
}

} // namespace stemware::fem_tests
