#pragma once

// Elastic half-spaces and layers under loads on a ring, by published kernels and plain quadrature.
#include "fem/geometry/elastic_material.h"

#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/special_functions/bessel.hpp>

#include <cmath>
#include <limits>

namespace stemware::verification
{

using fem::ElasticMaterial;

struct Band
{
  double inner, outer;
};

inline double plane_strain_modulus(const ElasticMaterial &material)
{
  return material.young_modulus / (1 - material.poisson_ratio * material.poisson_ratio);
}

/// Returns the ratio of the surface displacements of a layer bonded to a rigid base and of a half-space under
/// a frictionless pressure of wave number k. @p thickness: k h, infinite for a half-space. A thin layer gives
/// k h (1 - 2 nu) / (2 (1 - nu)^2) (Johnson, Contact Mechanics, 1985, section 5.8).
inline double layer_over_half_space(double thickness, double poisson_ratio)
{
  if (thickness > 300)
    return 1;
  const double kappa = 3 - 4 * poisson_ratio;
  return (2 * kappa * std::sinh(2 * thickness) - 4 * thickness) /
         (2 * kappa * std::cosh(2 * thickness) + 1 + kappa * kappa + 4 * thickness * thickness);
}

template <typename Function>
double integral(const Function &f, double from, double to, unsigned int n)
{
  using Gauss = boost::math::quadrature::gauss<double, 10>;
  double sum = 0;
  for (unsigned int i = 0; i < n; ++i)
    sum += Gauss::integrate(f, from + (to - from) * i / n, from + (to - from) * (i + 1) / n);
  return sum;
}

/// Returns int u_z r dr over @p seen at theta = 0 under a unit pressure cos(n theta) on @p loaded [m^5/N],
/// from Hankel transforms of both bands and the kernel 2 / (E* k) of Boussinesq or of a layer.
inline double normal_compliance(unsigned int n, Band loaded, Band seen, const ElasticMaterial &material,
                                double thickness = std::numeric_limits<double>::infinity())
{
  const auto transform = [n](Band band, double k)
  {
    return integral([&](double r) { return r * boost::math::cyl_bessel_j(static_cast<int>(n), k * r); },
                    band.inner, band.outer, 1 + static_cast<unsigned int>(k * (band.outer - band.inner) / 8));
  };
  const bool is_same = loaded.inner == seen.inner && loaded.outer == seen.outer;
  const auto integrand = [&](double k)
  {
    const double of_load = transform(loaded, k);
    return layer_over_half_space(k * thickness, material.poisson_ratio) * of_load *
           (is_same ? of_load : transform(seen, k));
  };
  // The integrand oscillates in k with the radius as frequency and decays like k^-3, or faster between two
  // bands.
  const double width = std::min(loaded.outer - loaded.inner, seen.outer - seen.inner);
  const double radius = seen.outer;
  const double end = 50 / width;
  return 2 / plane_strain_modulus(material) *
         integral(integrand, 0, end, static_cast<unsigned int>(end * radius / 6) + 1);
}

/// int u_z r dr under radial tractions cos(n theta) and azimuthal tractions sin(n theta) [m^5/N].
struct TangentialCompliance
{
  double radial, azimuthal;
};

/// Returns the compliance of a half-space below the plane (z upwards) under unit tractions, n >= 1. Cerruti:
/// a force Q along x displaces the surface by u_z = -(1 - 2 nu) / (4 pi G) Q x / rho^2 (Johnson, eq. 3.7).
/// Here x / rho^2 is the derivative of ln rho along x, and ln rho has the azimuthal harmonics -(pi / n)
/// (smaller / larger radius)^n. A ring of radius s therefore displaces the surface by (1 - 2 nu) / (4 G s)
/// times (r/s)^n (f_r + f_theta) for r < s and (s/r)^n (f_theta - f_r) for r > s.
inline TangentialCompliance tangential_compliance(unsigned int n, Band loaded, Band seen,
                                                  const ElasticMaterial &material)
{
  constexpr int n_pieces = 400;
  const double ds = (loaded.outer - loaded.inner) / n_pieces, dr = (seen.outer - seen.inner) / n_pieces;
  TangentialCompliance sum = { 0, 0 };
  for (int j = 0; j < n_pieces; ++j)
    for (int i = 0; i < n_pieces; ++i)
    {
      const double s = loaded.inner + (j + 0.5) * ds, r = seen.inner + (i + 0.5) * dr;
      const double power = std::pow(r < s ? r / s : s / r, n) * r * dr * ds;
      sum.radial += r < s ? power : r > s ? -power : 0;
      sum.azimuthal += power;
    }
  const double factor = (1 - 2 * material.poisson_ratio) / (4 * material.shear_modulus());
  return { factor * sum.radial, factor * sum.azimuthal };
}

} // namespace stemware::verification
