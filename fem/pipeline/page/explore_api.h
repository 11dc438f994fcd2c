#pragma once

/// C interface of the live solver, one Explorer. Functions return UTF-8 JSON, valid until the next call;
/// failures are {"error": message}. Answers contain a part of the "document" of the page of `run`.
extern "C"
{
  /// Resets to the default study without compliances.
  void explore_begin();
  /// Sets the compliance, serialized(), of the foot or of the disc.
  void explore_take(const double *numbers, int is_disc);
  /// Sets the entry @p path to @p value.
  const char *explore_set(const char *path, const char *value);
  /// Calls Explorer::freeze_mesh().
  void explore_ready(double fineness);
  /// Calls Explorer::solve(); @p n_harmonics = 0: all harmonics.
  const char *explore_solve(unsigned int n_harmonics, int cold);
  /// Returns the pressure of the last answer.
  const char *explore_pressure();
  /// Returns torques over the spin, the spin-up and its instants.
  const char *explore_curves();
  /// Returns the budget of the last answer.
  const char *explore_budget();
}
