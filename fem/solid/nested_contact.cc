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
    const ContactSurface &on_coarse = coarse->contact_surface(), &surface = body.contact_surface();
    const LinearConditions conditions = conditions_of(on_coarse, demand);
    std::optional<ContactStart> start;
    unsigned int n_laws = 1;
    if (coarse->has_coarser_mesh())
      start = start_from_coarser_mesh(*coarse, *softer, softening, demand, radius);
    else if (softening != 1)
      n_laws = 5; // the contact on the coarsest mesh is found by gradual stiffening
    while (n_laws-- > 0)
    {
      const auto law = softer->softened(std::pow(softening, n_laws))->make(on_coarse, 0);
      const ContactSolution solution = solve_contact(*coarse, *law, conditions, radius,
                                                     coarse_control(softening), start ? &*start : nullptr);
      start = hardened({ solution.motion, solution.normal_displacement }, on_coarse, softening);
    }
    body.interpolate_from(*coarse);
    return hardened({ start->motion, body.contact_displacement() + surface.motion_modes() * start->motion },
                    surface, softening);
  }
  catch (const ContactFailure &)
  {
    return std::nullopt;
  }
}

} // namespace stemware::fem
