#include "fem/pipeline/analysis/closure_comparison.h"

#include "ring_model/first_harmonic_ring.h"

#include <stdexcept>

namespace stemware::pipeline
{

std::vector<ClosureRow> compare_closures(const ring::Motion &motion, double radius)
{
  std::vector<ClosureRow> rows;
  for (const ring::Closure closure : { ring::Closure::paper, ring::Closure::hand, ring::Closure::full })
  {
    const ring::FirstHarmonicRing ring(closure, motion, radius);
    ClosureRow row;
    row.closure = closure;
    row.tau_at_rest = ring.torque(0);
    row.moment_ratio_at_rest = ring.load(0).moment_ratio();
    try
    {
      row.omega_terminal = ring.terminal_spin().omega;
      row.moment_ratio_at_terminal = ring.load(*row.omega_terminal).moment_ratio();
    }
    catch (const std::runtime_error &)
    {
      // A formal load may push for ever; a comparison shows that as a blank.
    }
    rows.push_back(row);
  }
  return rows;
}

} // namespace stemware::pipeline
