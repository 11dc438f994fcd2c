#pragma once

#include "fem/contact/interface_law.h"

namespace stemware::fem
{

/// Returns a stiff Winkler interface of @p modulus [Pa/m] that approximates a hard interface. Its force and
/// moments across the rim are accurate, but its pressure at a point oscillates; on a crowned land, extent and
/// pressure map are therefore computed from the moments (PressureProfile).
std::shared_ptr<const InterfaceLaw> make_stiff_spring(double modulus);

} // namespace stemware::fem
