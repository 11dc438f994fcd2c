#pragma once

#include "fem/contact/table_law.h"
#include "fem/geometry/require.h"

#include <cmath>
#include <memory>

namespace stemware::fem
{

/// Parameters of the law between foot and table, independent of a contact surface.
///
///     const WinklerInterface law(1e10);              // [Pa/m]
///     law.half_width(line_load, crown_radius);       // of the contact of a rigid rim [m]
///     const auto table = law.make(surface, penalty); // pressure on the nodes of a ContactSurface
class InterfaceLaw
{
public:
  virtual ~InterfaceLaw() = default;

  /// Returns whether nodes touch without penetration. A hard law needs as many lines as the body has modes, a
  /// mesh that resolves the Hertz contact, and augmented-Lagrangian updates.
  virtual bool is_hard() const { return false; }

  /// Returns whether the contact has an edge; otherwise the pressure decays with the distance.
  virtual bool has_edge() const { return true; }

  /// Returns dp/d(penetration) at @p pressure [Pa/m]; infinite for a hard law.
  virtual double stiffness_at(double pressure) const = 0;

  /// Returns the half-width [m] of a rigid rim's contact: @p crown_radius [m] under @p line_load [N/m].
  virtual double half_width(double line_load, double crown_radius) const = 0;

  /// Returns the penetration at @p pressure > 0 [m].
  virtual double penetration_at(double pressure) const = 0;

  /// Returns a law of this kind with stiffness_at() smaller by @p factor >= 1, for cold starts.
  virtual std::shared_ptr<const InterfaceLaw> softened(double factor) const = 0;

  /// Returns the law on @p surface, keeping a reference. @p penalty [Pa/m], about E / (cell size), affects
  /// the iterations of a hard law only. Throws std::invalid_argument for inadmissible parameters.
  virtual std::unique_ptr<TableLaw> make(const ContactSurface &surface, double penalty) const = 0;
};

/// Parameters of the pressure law of a rough surface, RoughInterface.
struct Roughness
{
  double reference_pressure = 1e9; ///< p0, at touching mean planes [Pa]
  double decay_length = 1e-6;      ///< s [m], half the rms roughness
};

/// Throws std::invalid_argument with @p name, @p unit and @p example unless @p value is positive and finite.
inline void require_positive(const char *name, double value, const char *unit, const char *example)
{
  require(std::isfinite(value) && value > 0, name, " = ", value, " ", unit,
          " is not allowed; give a finite number greater than 0 (", example, ").");
}

} // namespace stemware::fem
