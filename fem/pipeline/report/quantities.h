#pragma once

#include "fem/pipeline/document/table.h"

/// Quantities that pictures name by themselves; all are declared in quantities.json.
namespace stemware::pipeline::quantity
{

inline const Quantity omega_terminal = quantity_named("omega_terminal");
inline const Quantity harmonic_effect = quantity_named("harmonic_effect");

} // namespace stemware::pipeline::quantity
