#pragma once

#include "fem/contact/interface_law.h"

#include <limits>

namespace stemware::fem
{

/// Signorini's conditions f_i >= 0, gap_i >= 0, f_i gap_i = 0 at the nodes, by an augmented Lagrangian.
struct HardInterface : InterfaceLaw
{
  bool is_hard() const override { return true; }
  double stiffness_at(double) const override { return std::numeric_limits<double>::infinity(); }
  double half_width(double, double) const override { return 0; }
  double penetration_at(double) const override { return 0; }
  std::shared_ptr<const InterfaceLaw> softened(double) const override
  {
    return std::make_shared<HardInterface>();
  }
  std::unique_ptr<TableLaw> make(const ContactSurface &surface, double penalty) const override;
};

} // namespace stemware::fem
