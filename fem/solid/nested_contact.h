#pragma once

#include "fem/contact/contact_demand.h"
#include "fem/contact/contact_newton.h"
#include "fem/contact/interface_law.h"
#include "fem/solid/solid_body.h"

#include <optional>

namespace stemware::fem
{

/// Finds the contact under @p interface, which is not hard, on the coarser meshes of @p body, from the
/// coarsest up, and takes it over: returns where solve_contact() on @p body begins, at its new displacement.
/// Nothing, and the body at rest, when there is no coarser mesh or when the next coarser one does not find
/// the contact.
///
/// Each coarser mesh has an interface @p softening times softer: 1 for a table that yields by itself, more
/// for a spring that stands for a hard one and can be found by hardening only.
std::optional<ContactStart> start_from_coarser_mesh(SolidBody &body, const InterfaceLaw &interface,
                                                    double softening, const ContactDemand &demand,
                                                    double radius);

} // namespace stemware::fem
