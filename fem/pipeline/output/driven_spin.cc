#include "fem/pipeline/output/driven_spin.h"

#include "fem/pipeline/output/render/curve_plot.h"
#include "fem/pipeline/output/render/number_format.h"

#include <algorithm>

namespace stemware::pipeline
{

ReportSection driven_spin_section(const SpinUpCurves &curves)
{
  const DrivenSpinUp &driven = curves.driven.value();
  const auto [slowest, fastest] = std::minmax_element(driven.speed.begin(), driven.speed.end());
  return {
    "A hand that is no motor",
    fmt::format(FMT_STRING("Led with the speeds of Motion/Orbit speed file, between {} and {} m/s, the glass "
                           "spins at {} rad/s in the end; at the constant Motion/Orbit speed, to which all "
                           "other numbers belong, at {} rad/s. Contact, friction and moments are in balance "
                           "at every instant, with the force that accelerates the glass along its orbit."),
                format::significant<4>(*slowest), format::significant<4>(*fastest),
                format::significant<6>(driven.omega.back()), format::significant<6>(curves.adaptive.back())),
    { curve_plot({ "driven_spin_up",
                   "The spin under the hand's own speed, beside that at constant speed.",
                   { "t (s)" },
                   { "ω (rad/s)" },
                   { { "v(t)", driven.time, driven.omega }, { "constant v", curves.time, curves.adaptive } },
                   "set xzeroaxis lt 8\n" }),
      curve_plot({ "orbit_speed",
                   "The speed of the hand.",
                   { "t (s)" },
                   { "v (m/s)" },
                   { { "", driven.time, driven.speed } },
                   "set yrange [0:*]\n" }) }
  };
}

Table driven_spin_table(const DrivenSpinUp &driven)
{
  return { "Spin-up from rest with the speeds of Motion/Orbit speed file",
           { numbers("time", "s", driven.time), numbers("orbit speed", "m/s", driven.speed),
             numbers("dv/dt", "m/s^2", driven.acceleration), numbers("omega", "rad/s", driven.omega) } };
}

nlohmann::ordered_json driven_spin_summary(const DrivenSpinUp &driven)
{
  return { { "speed_at_end", driven.speed.back() }, { "omega_at_end", driven.omega.back() } };
}

} // namespace stemware::pipeline
