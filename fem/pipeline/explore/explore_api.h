#pragma once

/// C interface of the live solver, one Explorer. Every function returns UTF-8 JSON, valid until the next
/// call; failures are {"error": message}.
extern "C"
{
  /// Resets to the default study without compliances.
  void explore_begin();
  /// Sets the compliance, serialized(), of the foot or of the disc.
  void explore_take(const double *numbers, int is_disc);
  /// Gives an entry another value.
  const char *explore_set(const char *path, const char *value);
  /// Explorer::ready().
  void explore_ready(double fineness);
  /// Returns all entries: path, unit, allowed values, help, value, whether it is a number.
  const char *explore_entries();
  /// Explorer::solve(); @p n_harmonics = 0: all.
  const char *explore_solve(unsigned int n_harmonics, int cold);
  /// Returns the pressure p(r, theta) of the last answer at no more than @p n_azimuths azimuths.
  const char *explore_pressure(unsigned int n_azimuths);
  const char *explore_curves();
  const char *explore_budget();
}
