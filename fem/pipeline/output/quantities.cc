#include "fem/pipeline/output/quantities.h"

namespace stemware::pipeline::quantity
{

Quantity torque_at(double omega)
{
  return { "torque[]", "tau_z at omega = " + significant<9>(omega) + " rad/s", "N m",
           "τ_z at " + significant<6>(omega) + " rad/s", "tau at " + significant<4>(omega) };
}

} // namespace stemware::pipeline::quantity
