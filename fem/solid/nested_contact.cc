#include "fem/solid/nested_contact.h"

#include <cmath>

namespace stemware::fem
{

namespace
{

/// Returns the control of a solve on a coarser mesh. Its solution is only the initial guess on the finer
/// mesh, so the tolerances are loose.
ContactControl coarse_control(double softening)
{
  ContactControl control;
  control.requires_unchanged_set = softening == 1;
  control.tolerance = 1e-6;
  control.equilibrium_tolerance = 1e-4;
  control.resultant_tolerance = 1e-4;
  return control;
}

/// Returns @p start for an interface that is stiffer by the factor @p ratio, with the same pressure.
ContactStart hardened(ContactStart start, const ContactSurface &surface, double ratio)
{
  const Eigen::VectorXd penetration = -(surface.node_gap + start.normal_displacement);
  start.normal_displacement += penetration.cwiseMax(0) * (1 - 1 / ratio);
  return start;
}

/// Returns an initial guess from solves on gradually stiffer interfaces; std::nullopt if @p softening is 1.
std::optional<ContactStart> start_on_coarsest_mesh(SolidBody &body, const InterfaceLaw &interface,
                                                   double softening, const ContactDemand &demand,
                                                   double radius)
{
  std::optional<ContactStart> start;
  if (softening == 1)
    return start;
  const ContactSurface &surface = body.contact_surface();
  const LinearConditions conditions = conditions_of(surface, demand);
  for (unsigned int n = 4; n > 0; --n)
  {
    const auto law = interface.softened(std::pow(softening, n))->make(surface, 0);
    const ContactSolution solution =
      solve_contact(body, *law, conditions, radius, coarse_control(softening), start ? &*start : nullptr);
    start = hardened({ solution.motion, solution.normal_displacement }, surface, softening);
  }
  return start;
}

} // namespace

std::optional<ContactStart> start_from_coarser_mesh(SolidBody &body, const InterfaceLaw &interface,
                                                    double softening, const ContactDemand &demand,
                                                    double radius)
{
  body.reset();
  const std::unique_ptr<SolidBody> coarse = body.coarser();
  if (!coarse)
    return std::nullopt;
  const std::shared_ptr<const InterfaceLaw> softer = interface.softened(softening);
  try
  {
    const std::optional<ContactStart> start =
      coarse->has_coarser_mesh() ? start_from_coarser_mesh(*coarse, *softer, softening, demand, radius)
                                 : start_on_coarsest_mesh(*coarse, *softer, softening, demand, radius);
    const std::unique_ptr<TableLaw> law = softer->make(coarse->contact_surface(), 0);
    const ContactSolution solution =
      solve_contact(*coarse, *law, conditions_of(coarse->contact_surface(), demand), radius,
                    coarse_control(softening), start ? &*start : nullptr);
    body.interpolate_from(*coarse);
    const ContactSurface &surface = body.contact_surface();
    return hardened(
      { solution.motion, body.contact_displacement() + surface.motion_modes() * solution.motion }, surface,
      softening);
  }
  catch (const ContactFailure &)
  {
    return std::nullopt;
  }
}

} // namespace stemware::fem
