#pragma once

#include "fem/pipeline/analysis/compared_loads.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace stemware::pipeline
{

/// The glass under one closure, on one kind of load with some of its harmonics. What does not exist is
/// missing, and state says why.
struct ComparisonRow
{
  ring::Closure closure = ring::Closure::full;
  std::string load;
  unsigned int harmonics = 0;
  bool all_harmonics = false;
  std::optional<double> tau_at_rest;      ///< [N m]
  std::optional<double> moment_ratio;     ///< of the load at rest
  std::optional<double> omega_terminal;   ///< [rad/s]
  std::optional<double> band = {};        ///< half-width of its error band, where one was estimated [rad/s]
  std::optional<double> difference;       ///< of omega_terminal to the paper's, relative to that
  std::optional<double> least_load;       ///< at the terminal spin [N/rad]
  std::optional<double> contact_fraction; ///< share of the rim that carries load at the terminal spin
  /// "full contact", "lift-off", "formal" (the load, or what is left of it, would have to pull), "tips",
  /// "no balance", "no terminal spin".
  std::string state;
  std::string trouble; ///< more about the last three
};

/// The closures that are compared, the paper's first.
inline constexpr ring::Closure compared_closures[] = { ring::Closure::paper, ring::Closure::hand,
                                                       ring::Closure::full };

/// All rows: closures by kinds of loads by truncations, the paper's first.
struct Comparison
{
  std::vector<ComparisonRow> rows;

  /// The row of a closure on a kind of load with @p n harmonics (0: all); nothing where there is none.
  const ComparisonRow *find(ring::Closure closure, const std::string &load, unsigned int n = 0) const;
};

/// Gives the elastic foot in balance with all its harmonics its error bands under the closures paper and
/// full: those that the answer names. A few further contact problems each; throws what they throw.
void add_error_bands(const Study &study, Comparison &comparison);

/// Rows that a comparison of these kinds of loads has.
std::size_t n_rows(const std::vector<LoadKind> &kinds);

/// Solves for every row; no row's trouble stops the others. @p progress is told after each how many are done.
Comparison compare_models(const Study &study, const std::vector<LoadKind> &kinds,
                          const std::function<void(std::size_t n_done)> &progress = {});

} // namespace stemware::pipeline
