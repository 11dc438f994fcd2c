#pragma once

#include "fem/contact/interface_law.h"

namespace stemware::fem
{

/// Returns a law for a stiff spring of @p modulus [Pa/m] in the place of a hard interface: a Winkler
/// interface whose force and moments across the rim are those of a hard contact. Extent and pressure map of a
/// crowned land come from these (PressureProfile), since the pressure at a point oscillates.
std::shared_ptr<const InterfaceLaw> make_stiff_spring(double modulus);

} // namespace stemware::fem
