#include "fem/pipeline/analysis/spin_row.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace stemware::pipeline
{

std::string to_string(Standing standing)
{
  static constexpr const char *names[] = { "full contact", "lift-off",   "formal",
                                           "tips",         "no balance", "no terminal spin" };
  return names[static_cast<std::size_t>(standing)];
}

std::optional<double> SpinRow::omega_terminal() const
{
  return terminal ? std::optional(terminal->omega) : std::nullopt;
}

std::optional<double> SpinRow::last_spin() const
{
  return terminal ? std::optional(terminal->omega) : fall ? std::optional(fall->omega) : std::nullopt;
}

std::optional<double> SpinRow::time_constant() const
{
  return terminal && std::isfinite(terminal->time_constant) ? std::optional(terminal->time_constant)
                                                            : std::nullopt;
}

double SpinRow::amplitude() const
{
  if (!at_rest)
    return 0;
  const ring::RingStack &load = at_rest->load;
  const unsigned int highest = std::min(harmonics, load.n_harmonics());
  return std::hypot(load.a(highest), load.b(highest)) / load.a(0);
}

double SpinRow::least_load() const
{
  double least = at_rest ? at_rest->minimum : 0;
  if (at_terminal)
    least = std::min(least, at_terminal->minimum);
  return least;
}

double SpinRow::pulling_share() const
{
  return std::max(at_rest ? at_rest->pulling_share : 0, at_terminal ? at_terminal->pulling_share : 0);
}

} // namespace stemware::pipeline
