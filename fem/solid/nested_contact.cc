#include "fem/solid/nested_contact.h"

namespace stemware::fem
{

namespace
{

/// The error of a coarser mesh is larger than this: solving its contact further would not help the finer.
ContactControl coarse_control()
{
  ContactControl control;
  control.tolerance = 1e-6;
  control.equilibrium_tolerance = 1e-4;
  control.resultant_tolerance = 1e-4;
  return control;
}

} // namespace

std::optional<ContactStart> start_from_coarser_mesh(SolidBody &body, const MakeTableLaw &make_law,
                                                    const ContactDemand &demand, double radius)
{
  body.reset();
  const std::unique_ptr<SolidBody> coarse = body.coarser();
  if (!coarse)
    return std::nullopt;
  const std::optional<ContactStart> start = start_from_coarser_mesh(*coarse, make_law, demand, radius);
  const std::unique_ptr<TableLaw> law = make_law(*coarse);
  try
  {
    const ContactSolution solution =
      solve_contact(*coarse, *law, conditions_of(coarse->contact_surface(), demand), radius, coarse_control(),
                    start ? &*start : nullptr);
    body.start_from(*coarse);
    return ContactStart{ solution.motion, body.contact_displacement() +
                                            body.contact_surface().motion_modes() * solution.motion };
  }
  catch (const ContactFailure &)
  {
    return std::nullopt;
  }
}

} // namespace stemware::fem
