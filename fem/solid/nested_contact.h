#pragma once

#include "fem/contact/contact_demand.h"
#include "fem/contact/contact_newton.h"
#include "fem/contact/interface_law.h"
#include "fem/solid/solid_body.h"

#include <optional>

namespace stemware::fem
{

/// Solves the contact under @p interface (not hard) on the coarser meshes of @p body, from the coarsest up.
/// Sets the displacement of @p body and returns the start of solve_contact(); std::nullopt, with @p body at
/// rest, if there is no coarser mesh or its contact fails. Interfaces of coarser meshes are @p softening
/// times softer: 1 for a compliant table, more for a penalty law of a hard table, whose contact is found by
/// stiffening only.
std::optional<ContactStart> start_from_coarser_mesh(SolidBody &body, const InterfaceLaw &interface,
                                                    double softening, const ContactDemand &demand,
                                                    double radius);

} // namespace stemware::fem
