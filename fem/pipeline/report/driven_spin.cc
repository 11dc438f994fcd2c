#include "fem/pipeline/report/driven_spin.h"

namespace stemware::pipeline
{

Table driven_spin_table(const DrivenSpinUp &driven)
{
  return { "Spin-up from rest with the speeds of Motion/Orbit speed file",
           { numbers("time", "s", driven.time), numbers("orbit speed", "m/s", driven.speed),
             numbers("dv/dt", "m/s^2", driven.acceleration), numbers("omega", "rad/s", driven.omega) } };
}

nlohmann::ordered_json driven_spin_summary(const DrivenSpinUp &driven)
{
  return { { "speed_at_end", driven.speed.back() },
           { "omega_at_end", driven.omega.back() },
           { "interpolation_change", driven.interpolation_change },
           { "interpolation_change_at_end", driven.interpolation_change_at_end } };
}

} // namespace stemware::pipeline
