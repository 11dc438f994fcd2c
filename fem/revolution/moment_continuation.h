#pragma once

#include "fem/contact/contact_newton.h"
#include "fem/revolution/body_of_revolution.h"

namespace stemware::fem
{

/// Returns the contact of @p body and @p law under @p conditions by continuation in the moment from the
/// moment-free contact @p even, for conditions from which Newton's method does not converge directly. A
/// failed step is halved. If the continuation ends, throws ContactFailure: tipping, if the tilt diverged
/// under a moment that grows with tilt or friction; else the failure of the last step.
ContactSolution continue_in_moment(BodyOfRevolution &body, TableLaw &law, const LinearConditions &conditions,
                                   double radius, const ContactControl &control, const ContactSolution &even);

} // namespace stemware::fem
