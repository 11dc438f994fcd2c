#pragma once

namespace stemware::fem
{

/// Parameters of the pressure law of a rough surface, RoughInterface.
struct Roughness
{
  double reference_pressure = 1e9; ///< p0, at touching mean planes [Pa]
  double decay_length = 1e-6;      ///< s [m], half the rms roughness
};

} // namespace stemware::fem
