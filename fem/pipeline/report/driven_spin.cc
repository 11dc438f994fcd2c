#include "fem/pipeline/report/driven_spin.h"

#include "fem/pipeline/report/render/number_format.h"

#include <algorithm>

namespace stemware::pipeline
{

namespace
{

/// What the spin is uncertain by: how the entries of the file are joined, and the discretisation.
std::string uncertainty_sentence(const DrivenSpinUp &driven, const std::optional<double> &band)
{
  const std::string lines = fmt::format(
    FMT_STRING(" What lies between the rows of the file nobody knows: straight lines in the place of the "
               "monotone cubic would change the spin by up to {} rad/s on the way and {} in the end"),
    format::scientific_or_zero<1>(driven.interpolation_change),
    format::scientific_or_zero<1>(driven.interpolation_change_at_end));
  if (!band)
    return lines + ".";
  return lines + fmt::format(
                   FMT_STRING("{} the discretisation{} {}, the band of the terminal spin at constant speed."),
                   driven.interpolation_change > *band ? "; this matters more than" : ";",
                   driven.interpolation_change > *band ? ", about" : " about", format::band(*band));
}

} // namespace

ReportSection driven_spin_section(const SpinUpCurves &curves, const std::optional<double> &band)
{
  const DrivenSpinUp &driven = curves.driven.value();
  const auto [slowest, fastest] = std::minmax_element(driven.speed.begin(), driven.speed.end());
  return { "A hand that is no motor",
           fmt::format(
             FMT_STRING("Led with the speeds of Motion/Orbit speed file, between {} and {} m/s, the glass "
                        "spins at {} rad/s in the end; at the constant Motion/Orbit speed, to which all "
                        "other numbers belong, at {} rad/s. Contact, friction and moments are in balance "
                        "at every instant, with the force that accelerates the glass along its orbit."),
             format::significant<4>(*slowest), format::significant<4>(*fastest),
             format::significant<6>(driven.omega.back()), format::significant<6>(curves.adaptive.back())) +
             uncertainty_sentence(driven, band),
           { plot_from("driven_spin_up"), plot_from("orbit_speed") } };
}

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
