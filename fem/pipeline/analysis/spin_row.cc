#include "fem/pipeline/analysis/spin_row.h"

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

bool SpinRow::pulls() const
{
  return (at_rest && at_rest->minimum < 0) || (at_terminal && at_terminal->minimum < 0);
}

} // namespace stemware::pipeline
