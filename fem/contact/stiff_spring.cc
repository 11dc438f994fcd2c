#include "fem/contact/stiff_spring.h"

#include "fem/contact/pressure_profile.h"
#include "fem/contact/winkler_interface.h"

#include <vector>

namespace stemware::fem
{

namespace
{

class StiffSpringLaw : public PressureLaw<WinklerInterface>
{
public:
  StiffSpringLaw(const ContactSurface &surface, const WinklerInterface &spring)
      : PressureLaw(surface, spring)
      , land(surface)
      , spring(spring)
  {
  }

  ContactExtent extent(const ContactSolution &solution) const override
  {
    ContactExtent extent = PressureLaw::extent(solution);
    std::vector<CutValue> peaks;
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
    if (!land.is_crowned || !land.lines_are_radial)
      return {};
    std::vector<Eigen::Vector3d> depths;
    for (const ContactLine &line : land.lines)
      depths.push_back(penetration(line, solution.normal_displacement));
    return profiles_of_cuts(land, depths, [this](double depth) { return spring.pressure(depth); });
  }

  const ContactSurface &land;
  const WinklerInterface spring;
};

class StiffSpring : public WinklerInterface
{
public:
  using WinklerInterface::WinklerInterface;

  std::shared_ptr<const InterfaceLaw> softened(double factor) const override
  {
    return std::make_shared<StiffSpring>(modulus / factor);
  }
  std::unique_ptr<TableLaw> make(const ContactSurface &surface, double /*penalty*/) const override
  {
    validate();
    return std::make_unique<StiffSpringLaw>(surface, *this);
  }
};

} // namespace

std::shared_ptr<const InterfaceLaw> make_stiff_spring(double modulus)
{
  return std::make_shared<StiffSpring>(modulus);
}

} // namespace stemware::fem
