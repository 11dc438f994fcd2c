#pragma once

#include "fem/contact/pressure_law.h"

#include <algorithm>
#include <cmath>

namespace stemware::fem
{

/// Asperities of a nominally flat rough surface on a smooth one: pressure p = p0 exp(d / s), -d being the
/// separation of the mean planes. Where these meet, d = 0, the asperities are flat and the law goes on as its
/// tangent p0 (1 + d / s).
///
/// Greenwood & Williamson, Proc. R. Soc. A 295 (1966) 300, for exponentially distributed summits; Persson,
/// Phys. Rev. Lett. 99 (2007) 125502, for self-affine surfaces at low pressure. A factor in p0 is an offset
/// of the table, so the load depends on the decay length alone as long as the mean planes do not meet.
struct RoughInterface : PressureInterface<RoughInterface>
{
  RoughInterface() = default;
  RoughInterface(double reference_pressure, double decay_length)
      : reference_pressure(reference_pressure)
      , decay_length(decay_length)
  {
  }

  double stiffness_at(double pressure) const override
  {
    return std::min(pressure, reference_pressure) / decay_length;
  }
  /// Two and a half standard deviations of the bell exp(-x^2 / (2 rho s)).
  double half_width(double, double crown_radius) const override
  {
    return 2.5 * std::sqrt(crown_radius * decay_length);
  }
  double penetration_at(double pressure) const override
  {
    const double ratio = pressure / reference_pressure;
    return decay_length * (ratio < 1 ? std::log(ratio) : ratio - 1);
  }
  std::shared_ptr<const InterfaceLaw> softened(double factor) const override
  {
    return std::make_shared<RoughInterface>(reference_pressure, decay_length * factor);
  }

  double reference_pressure = 1e9; ///< p0, at touching mean planes [Pa]
  double decay_length = 1e-6;      ///< s [m], of the order of the rms roughness

  double pressure(double depth) const
  {
    const double ratio = depth / decay_length;
    return reference_pressure * (ratio < 0 ? std::exp(ratio) : 1 + ratio);
  }
  double stiffness(double depth) const
  {
    return reference_pressure / decay_length * (depth < 0 ? std::exp(depth / decay_length) : 1);
  }
  /// Where the pressure is 1e-20 of the greatest.
  double least_depth(double deepest) const { return std::min(deepest, 0.) - 46 * decay_length; }

  /// Under a rounded rim the pressure is a bell of width sqrt(crown radius * s): every panel is as long as
  /// that or shorter.
  template <typename Visitor>
  void integrate(const ContactLine &line, const Eigen::Vector3d &, const Visitor &visit) const
  {
    const double rise = line.gap.maxCoeff() - line.gap.minCoeff();
    const double panels = std::ceil(std::sqrt(2 * rise / decay_length));
    for_each_point(line, static_cast<unsigned int>(std::clamp(panels, 1., 200.)), visit);
  }

  void validate() const
  {
    require_positive("Reference pressure", reference_pressure, "Pa",
                     "a tenth of the harder body's E, 1e9 for wood");
    require_positive("Decay length", decay_length, "m", "half the rms roughness, 1e-6 for planed wood");
  }
};

} // namespace stemware::fem
