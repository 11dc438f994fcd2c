#pragma once

#include "fem/contact/contact_newton.h"
#include "fem/pipeline/study/study.h"

namespace stemware::pipeline
{

/// What the table's pressure has to balance at omega = 0, where the friction is exactly (-mu N, 0): N = m g
/// with the closure's moment, or with the given moment of a static study, M_N = m N R/2 (sin, -cos)(direction
/// of the load's maximum). Throws BadInput when the foot would tip, m >= 2.
fem::ContactLoad demanded_load(const Study &study);

/// m = |M_N| / (N R / 2).
double moment_ratio(const fem::ContactLoad &load, double contact_radius);

} // namespace stemware::pipeline
