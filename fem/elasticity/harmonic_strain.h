#pragma once

#include <array>

namespace stemware::fem
{

/// Strain amplitudes of a displacement harmonic in the order rr, zz, theta theta, rz, r theta, z theta
/// (shears are engineering strains).
using HarmonicStrain = std::array<double, 6>;

/// Strain of a shape function in the displacement u_r cos(n theta), u_theta sin(n theta), u_z cos(n theta):
/// `constant` + n `linear`.
struct ShapeStrain
{
  HarmonicStrain constant{};
  HarmonicStrain linear{};
};

/// Strain of a shape function, value N, gradient (N_r, N_z), at @p radius; @p component 0, 1, 2: r, theta, z.
inline ShapeStrain strain_of(unsigned int component, double value, const std::array<double, 2> &gradient,
                             double radius)
{
  ShapeStrain strain;
  const double hoop = value / radius;
  switch (component)
  {
  case 0:
    strain.constant = { gradient[0], 0, hoop, gradient[1], 0, 0 };
    strain.linear = { 0, 0, 0, 0, -hoop, 0 };
    break;
  case 1:
    strain.constant = { 0, 0, 0, 0, gradient[0] - hoop, gradient[1] };
    strain.linear = { 0, 0, hoop, 0, 0, 0 };
    break;
  default:
    strain.constant = { 0, gradient[1], 0, gradient[0], 0, 0 };
    strain.linear = { 0, 0, 0, 0, 0, -hoop };
  }
  return strain;
}

/// Bilinear form of twice the elastic energy density, @p lambda and @p shear Lame's constants [Pa].
inline double energy_product(const HarmonicStrain &a, const HarmonicStrain &b, double lambda, double shear)
{
  double normal = 0;
  double tangential = 0;
  for (unsigned int i = 0; i < 3; ++i)
  {
    normal += a[i] * b[i];
    tangential += a[i + 3] * b[i + 3];
  }
  return lambda * (a[0] + a[1] + a[2]) * (b[0] + b[1] + b[2]) + shear * (2 * normal + tangential);
}

} // namespace stemware::fem
