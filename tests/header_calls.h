#pragma once

// Names that the calls at the beginning of the headers use without declaring them; they are compiled, never
// linked.
#include "fem/contact/contact_newton.h"
#include "fem/contact/rough_interface.h"
#include "fem/contact/winkler_interface.h"
#include "fem/meridian/meshed_revolution_foot.h"
#include "fem/solid/solid_foot.h"
#include "ring_model/friction_functionals.h"
#include "ring_model/friction_kernels.h"
#include "ring_model/spin/answer.h"

namespace stemware::fem
{
using namespace ring;

extern const double a_0, a_1, b_1, radius, contact_radius, crown_radius, line_load, omega, penalty, v;
extern const double N, M_x, M_y, weight, moment;
extern const RingStack load;
extern const ContactSurface surface;
extern const RevolutionSetup setup;
extern ElasticBody &body;
extern TableLaw &law;
} // namespace stemware::fem
