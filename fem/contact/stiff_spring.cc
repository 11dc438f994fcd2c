#include "fem/contact/stiff_spring.h"

#include "fem/contact/azimuthal_density.h"
#include "fem/contact/line_integral.h"
#include "fem/contact/winkler_interface.h"
#include "ring_model/load/constants.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace stemware::fem
{

double PressureProfile::at(double radius) const
{
  const double x = (radius - middle) / half_width;
  return std::abs(x) < 1 ? peak * std::pow((1 - x) * (1 + x), exponent) : 0;
}

namespace
{

constexpr int n_moments = 5;
using Moments = Eigen::Matrix<double, n_moments, 1>; // int p (r - origin)^k dr

/// Force, centre and shape of the pressure on a cut.
struct PressureMoments
{
  double azimuth = 0;  ///< [rad]
  double force = 0;    ///< int p dr [N/m]
  double middle = 0;   ///< mean radius of the force [m]
  double variance = 0; ///< variance of the radius, weighted by the pressure [m^2]
  double kurtosis = 0; ///< fourth central moment over the square of the variance
};

/// Returns the pressure moments of the cut at @p azimuth from the moments @p of_cut about @p origin [m].
PressureMoments central_moments(double azimuth, double origin, const Moments &of_cut)
{
  PressureMoments cut;
  cut.azimuth = azimuth;
  cut.middle = origin;
  cut.force = of_cut(0);
  if (!(cut.force > 0))
    return cut;
  const Moments mean = of_cut / cut.force;
  const double shift = mean(1);
  cut.middle = origin + shift;
  cut.variance = mean(2) - shift * shift;
  const double fourth = mean(4) - shift * (4 * mean(3) - shift * (6 * mean(2) - 3 * shift * shift));
  cut.kurtosis = fourth / (cut.variance * cut.variance);
  return cut;
}

/// Returns the pressure moments of each cut; arguments as in profiles_of_cuts(). Empty without load.
std::vector<PressureMoments> moments_of_cuts(const ContactSurface &surface,
                                             const std::vector<Eigen::Vector3d> &depths,
                                             const std::function<double(double)> &pressure)
{
  const auto integrate = [&](std::size_t l, const auto &visit)
  {
    const ContactLine &line = surface.lines[l];
    const Eigen::Vector3d along = quadratic_through(depths[l]), x = quadratic_through(line.position.col(0)),
                          y = quadratic_through(line.position.col(1));
    for_each_loaded_point(AreaElement(line), depths[l],
                          [&](const LinePoint &point)
                          {
                            const double radius = std::hypot(value_at(x, point.xi), value_at(y, point.xi));
                            visit(radius, pressure(value_at(along, point.xi)) * point.area /
                                            (radius * line.azimuth_width));
                          });
  };
  Eigen::Vector2d sums = Eigen::Vector2d::Zero();
  for (std::size_t l = 0; l < depths.size(); ++l)
    integrate(l, [&](double radius, double force) { sums += force * Eigen::Vector2d(1, radius); });
  sums = surface.parts.sum(sums);
  if (!(sums(0) > 0))
    return {};
  const double origin = sums(1) / sums(0); // an origin inside the contact limits cancellation

  std::array<std::vector<double>, n_moments> of_lines;
  of_lines.fill(std::vector<double>(depths.size(), 0));
  for (std::size_t l = 0; l < depths.size(); ++l)
    integrate(l,
              [&](double radius, double force)
              {
                for (std::vector<double> &moment : of_lines)
                {
                  moment[l] += force;
                  force *= radius - origin;
                }
              });
  std::array<std::vector<AzimuthValue>, n_moments> of_cuts;
  for (std::size_t k = 0; k < n_moments; ++k)
    of_cuts[k] = values_of_cuts(surface, of_lines[k], [](double one, double other) { return one + other; });
  std::vector<PressureMoments> cuts;
  for (std::size_t c = 0; c < of_cuts[0].size(); ++c)
  {
    Moments of_cut;
    for (std::size_t k = 0; k < n_moments; ++k)
      of_cut(static_cast<Eigen::Index>(k)) = of_cuts[k][c].value;
    cuts.push_back(central_moments(of_cuts[0][c].azimuth, origin, of_cut));
  }
  return cuts;
}

/// Returns the profile with @p exponent and force, middle, variance of @p moments; peak 0 without a force.
PressureProfile profile_of(const PressureMoments &moments, double exponent)
{
  PressureProfile profile = { moments.azimuth, moments.middle, 0, exponent, 0 };
  if (!(moments.force > 0 && moments.variance > 0))
    return profile;
  // (1 - x^2)^a with a = exponent has the variance 1 / (2 a + 3) and the kurtosis 3 (2 a + 3) / (2 a + 5).
  profile.half_width = std::sqrt(moments.variance * (2 * exponent + 3));
  profile.peak = moments.force / profile.half_width * std::tgamma(exponent + 1.5) /
                 std::tgamma(exponent + 1) / std::sqrt(ring::pi);
  return profile;
}

class StiffSpringLaw : public PressureLaw<WinklerInterface>
{
public:
  using PressureLaw::PressureLaw;

  ContactExtent extent(const ContactSolution &solution) const override
  {
    ContactExtent extent = PressureLaw::extent(solution);
    std::vector<AzimuthValue> peaks;
    for (const PressureProfile &profile : profiles_of(solution))
      peaks.push_back({ profile.azimuth, profile.peak });
    if (!peaks.empty())
      extent.peak_pressure = largest_between(peaks);
    return extent;
  }

  PressureMap pressure_map(const ContactSolution &solution) const override
  {
    const auto profiles = profiles_of(solution);
    return profiles.empty() ? PressureLaw::pressure_map(solution) : pressure_map_of(profiles);
  }

private:
  /// Returns the pressure profiles of the cuts; empty unless the land is crowned and its lines are radial.
  std::vector<PressureProfile> profiles_of(const ContactSolution &solution) const
  {
    if (!surface.is_crowned || !surface.lines_are_radial)
      return {};
    return profiles_of_cuts(surface, penetrations(solution.normal_displacement),
                            [this](double depth) { return law.pressure(depth); });
  }
};

class StiffSpring : public WinklerInterface
{
public:
  using WinklerInterface::WinklerInterface;

  std::unique_ptr<TableLaw> make(const ContactSurface &surface, double /*penalty*/) const override
  {
    validate();
    return std::make_unique<StiffSpringLaw>(surface, *this);
  }
};

} // namespace

std::vector<PressureProfile> profiles_of_cuts(const ContactSurface &surface,
                                              const std::vector<Eigen::Vector3d> &depths,
                                              const std::function<double(double)> &pressure)
{
  const std::vector<PressureMoments> cuts = moments_of_cuts(surface, depths, pressure);
  double force = 0, kurtosis = 0;
  for (const PressureMoments &cut : cuts)
    if (cut.variance > 0)
    {
      force += cut.force;
      kurtosis += cut.force * cut.kurtosis;
    }
  kurtosis /= force;
  // (1 - x^2)^a has the kurtosis 1.8 for a = 0 and 2.3 for a = 1.8. Other kurtoses are not approximated.
  if (!(kurtosis > 1.8 && kurtosis < 2.3))
    return {};
  // On a half-space the exponent is 1/2 (Hertz). A layer never makes the pressure more uniform, so the
  // exponent is at least 1/2.
  const double exponent = std::max(0.5, (5 * kurtosis - 9) / (6 - 2 * kurtosis));
  std::vector<PressureProfile> profiles;
  for (const PressureMoments &cut : cuts)
    profiles.push_back(profile_of(cut, exponent));
  return profiles;
}

PressureMap pressure_map_of(const std::vector<PressureProfile> &profiles)
{
  constexpr unsigned int n_points_across = 33;
  double inner = std::numeric_limits<double>::infinity(), outer = 0;
  for (const PressureProfile &profile : profiles)
    if (profile.peak > 0)
    {
      inner = std::min(inner, profile.middle - profile.half_width);
      outer = std::max(outer, profile.middle + profile.half_width);
    }
  PressureMap map;
  map.is_grid = true;
  for (const PressureProfile &profile : profiles)
  {
    std::vector<PressurePoint> &cut = map.cuts.emplace_back();
    for (unsigned int i = 0; i < n_points_across; ++i)
    {
      const double radius = inner + (outer - inner) * i / (n_points_across - 1);
      cut.push_back({ radius, profile.azimuth, profile.peak > 0 ? profile.at(radius) : 0 });
    }
  }
  return map.rotated(0); // rotated(0) maps the azimuths to [0, 2 pi)
}

std::shared_ptr<const InterfaceLaw> make_stiff_spring(double modulus)
{
  return std::make_shared<StiffSpring>(modulus);
}

} // namespace stemware::fem
