#pragma once

#include "fem/contact/pressure_law.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace stemware::fem
{

/// Exponential pressure law of a nominally flat rough surface on a smooth one: p = p0 exp(d / s), -d the
/// separation of the mean planes. For d > 0 (flattened asperities) the law continues as its tangent.
/// Greenwood & Williamson, Proc. R. Soc. A 295 (1966) 300, for exponentially distributed summits; Persson,
/// Phys. Rev. Lett. 99 (2007) 125502, for self-affine surfaces at low pressure. If d < 0 everywhere, p0 only
/// shifts the table, and the load depends on s only.
struct RoughInterface : PressureInterface<RoughInterface>, Roughness
{
  RoughInterface() = default;
  explicit RoughInterface(const Roughness &roughness)
      : Roughness(roughness)
  {
  }
  RoughInterface(double reference_pressure, double decay_length)
      : Roughness{ reference_pressure, decay_length }
  {
  }

  bool has_edge() const override { return false; }
  double stiffness_at(double pressure) const override
  {
    return std::min(pressure, reference_pressure) / decay_length;
  }
  /// Returns 2.5 standard deviations of the Gaussian exp(-x^2 / (2 rho s)).
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

  double pressure(double depth) const
  {
    const double ratio = depth / decay_length;
    return reference_pressure * (ratio < 0 ? std::exp(ratio) : 1 + ratio);
  }
  /// Returns p [Pa] and dp/dd [Pa/m], computed with one exponential.
  std::pair<double, double> pressure_and_stiffness(double depth) const
  {
    const double ratio = depth / decay_length, factor = ratio < 0 ? std::exp(ratio) : 1;
    return { reference_pressure * (factor + std::max(ratio, 0.)),
             reference_pressure / decay_length * factor };
  }
  /// Returns the depth at which the pressure is 1e-20 of the largest.
  double cutoff_depth(double deepest) const { return std::min(deepest, 0.) - 46 * decay_length; }

  /// Integrates by Gauss quadrature on panels along a line. Panels are so short that d / s changes little;
  /// they cover the range of pressures above rounding of the line's maximum, and end at d = 0, where the
  /// second derivative of the law jumps.
  template <typename Visitor>
  void integrate(const AreaElement &area, const Eigen::Vector3d &depth, const Visitor &visit) const
  {
    constexpr double rounding = 36, unloaded = -100; // exponents
    const double slope = (depth(2) - depth(0)) / 2, curvature = depth(0) - 2 * depth(1) + depth(2);
    const auto depth_at = [&](double xi) { return depth(1) + xi * (slope + xi * curvature / 2); };
    double top = depth(0) > depth(2) ? -1 : 1;
    if (curvature < -std::abs(slope))
      top = -slope / curvature;
    const double highest = depth_at(top);
    if (highest < unloaded * decay_length)
      return for_each_point(area, LineSegment{ -1, 1 }, visit);

    // Depth of the largest pressure: the largest depth, or the depth at which the mean planes touch.
    const double level = std::min(highest, 0.);
    const double slope_at_level =
      std::sqrt(std::max(0., std::pow(slope + top * curvature, 2) - 2 * curvature * (highest - level)));
    const double panels_per_length =
      std::max(std::sqrt(std::abs(curvature) / decay_length), slope_at_level / (2 * decay_length));
    const PositiveSegments loaded((depth.array() - level + rounding * decay_length).matrix());
    const PositiveSegments beyond(depth); // parts on which the mean planes touch
    for (unsigned int s = 0; s < loaded.n_segments; ++s)
    {
      double begin = loaded.segments[s].begin;
      const auto integrate_to = [&](double end)
      {
        if (!(end > begin))
          return;
        const double n_panels = std::clamp(std::ceil(panels_per_length * (end - begin)), 1., 200.);
        const double length = (end - begin) / n_panels;
        for (double panel = 0; panel < n_panels; ++panel)
          for_each_point<6>(area, { begin + panel * length, begin + (panel + 1) * length }, visit);
        begin = end;
      };
      for (unsigned int b = 0; b < beyond.n_segments; ++b)
        for (const double border : { beyond.segments[b].begin, beyond.segments[b].end })
          integrate_to(std::min(border, loaded.segments[s].end));
      integrate_to(loaded.segments[s].end);
    }
  }

  void validate() const
  {
    require_positive("Reference pressure", reference_pressure, "Pa",
                     "a tenth of the harder body's E, 1e9 for wood");
    require_positive("Decay length", decay_length, "m", "half the rms roughness, 1e-6 for planed wood");
  }
};

} // namespace stemware::fem
