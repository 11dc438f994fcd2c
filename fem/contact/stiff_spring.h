#pragma once

#include "fem/contact/interface_law.h"

namespace stemware::fem
{

/// Returns a law for a stiff spring of @p modulus [Pa/m] that approximates a hard interface: a Winkler
/// interface with the same force and moments across the rim as a hard contact. The pressure at a point
/// oscillates; on a crowned land, extent and pressure map are therefore computed from the moments
/// (PressureProfile).
std::shared_ptr<const InterfaceLaw> make_stiff_spring(double modulus);

} // namespace stemware::fem
