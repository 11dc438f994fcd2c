#pragma once

#include "fem/contact/contact_demand.h"
#include "fem/contact/contact_newton.h"
#include "fem/solid/solid_body.h"

#include <memory>
#include <optional>

namespace stemware::fem
{

/// The table law under a body.
using MakeTableLaw = std::function<std::unique_ptr<TableLaw>(const SolidBody &)>;

/// Finds the contact on the coarser meshes of @p body, from the coarsest up, and takes it over: returns where
/// solve_contact() on @p body begins, at its new displacement. Nothing, and the body at rest, when there is
/// no coarser mesh or when the next coarser one does not resolve the contact.
std::optional<ContactStart> start_from_coarser_mesh(SolidBody &body, const MakeTableLaw &make_law,
                                                    const ContactDemand &demand, double radius);

} // namespace stemware::fem
