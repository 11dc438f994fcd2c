#pragma once

#include "fem/contact/contact_newton.h"
#include "fem/revolution/body_of_revolution.h"

namespace stemware::fem
{

/// The contact of @p body and @p law under @p conditions, found on a path of growing moments that begins with
/// @p even, the contact without any: for conditions from which Newton's method does not converge at once. A
/// step that fails is halved. Where the path ends, throws ContactFailure: tipping, if the glass has leant
/// over faster and faster before, under a moment that grows with its lean or with the friction of the load;
/// else what the last step has thrown.
ContactSolution solve_along_moment(BodyOfRevolution &body, TableLaw &law, const LinearConditions &conditions,
                                   double radius, const ContactControl &control, const ContactSolution &even);

} // namespace stemware::fem
