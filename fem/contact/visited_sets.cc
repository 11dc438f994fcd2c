#include "fem/contact/visited_sets.h"

#include <algorithm>

namespace stemware::fem
{

bool VisitedSets::makes_progress(const ActiveSet &set, double residual)
{
  // Two active sets are equal only if they agree on every part (MPI rank) of the surface.
  std::vector<double> differs;
  for (const Visit &visit : visits)
    differs.push_back(visit.set != set ? 1 : 0);
  parts.sum_in_place(differs);
  const auto same = std::find(differs.begin(), differs.end(), 0.);
  if (same == differs.end())
  {
    visits.push_back({ set, residual });
    return true;
  }
  double &residual_then = visits[static_cast<std::size_t>(same - differs.begin())].residual;
  const bool gains = residual < 0.5 * residual_then;
  residual_then = residual;
  return gains;
}

} // namespace stemware::fem
