#pragma once

#include "fem/contact/table_law.h"
#include "fem/geometry/require.h"

#include <cmath>
#include <memory>

namespace stemware::fem
{

/// The law by which foot and table touch: its parameters, before there is a contact surface. A law is one
/// class derived from this; nothing else asks which it is.
class InterfaceLaw
{
public:
  virtual ~InterfaceLaw() = default;

  /// Whether the surfaces touch without penetration, at the contact nodes: such a law needs as many lines as
  /// the body has modes, a mesh that resolves the Hertz contact, and augmented-Lagrangian updates.
  virtual bool is_hard() const { return false; }

  /// Whether the contact ends somewhere; else the pressure fades with the distance and is zero nowhere.
  virtual bool has_edge() const { return true; }

  /// dp/d(penetration) where the pressure is @p pressure [Pa/m]; infinite for a hard law.
  virtual double stiffness_at(double pressure) const = 0;

  /// Half-width of the band that carries under a rigid rim of @p crown_radius [m] with @p line_load [N/m], as
  /// far as the interface alone decides on it [m].
  virtual double half_width(double line_load, double crown_radius) const = 0;

  /// Where the pressure is @p pressure > 0 [m].
  virtual double penetration_at(double pressure) const = 0;

  /// A law of the same kind whose stiffness_at() is smaller by @p factor >= 1: the way to a solution from
  /// afar.
  virtual std::shared_ptr<const InterfaceLaw> softened(double factor) const = 0;

  /// The law on @p surface, to which it keeps a reference. @p penalty [Pa/m] steers a hard law, and only the
  /// path to its solution: E / (cell size) is the natural scale. Throws std::invalid_argument for parameters
  /// that are not allowed.
  virtual std::unique_ptr<TableLaw> make(const ContactSurface &surface, double penalty) const = 0;
};

/// Throws std::invalid_argument, with @p name, @p unit and @p example in its sentence, unless @p value is
/// positive and finite.
inline void require_positive(const char *name, double value, const char *unit, const char *example)
{
  require(std::isfinite(value) && value > 0, name, " = ", value, " ", unit,
          " is not allowed; give a finite number greater than 0 (", example, ").");
}

} // namespace stemware::fem
