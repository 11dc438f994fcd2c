#pragma once

/// Functions that a page calls: one Explorer by the names of entries. All texts are JSON in UTF-8, valid
/// until the next call; answers that there are not are {"error": sentence}.
extern "C"
{
  /// Forgets everything: the default study, no compliances.
  void explore_begin();
  /// Takes a compliance, packed(), of the foot or of the disc under it.
  void explore_take(const double *numbers, int is_disc);
  /// Gives an entry another value.
  const char *explore_set(const char *path, const char *value);
  /// Explorer::ready().
  void explore_ready(double fineness);
  /// All entries: path, unit, words for what is allowed, help, value, whether it is a number.
  const char *explore_entries();
  /// Explorer::solve(); @p n_harmonics = 0: all.
  const char *explore_solve(unsigned int n_harmonics, int cold);
  /// The pressure p(r, theta) of the last answer, at most @p n_azimuths azimuths.
  const char *explore_pressure(unsigned int n_azimuths);
  const char *explore_curves();
  const char *explore_budget();
}
