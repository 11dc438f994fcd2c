#include "fem/contact/contact_goal.h"

#include <algorithm>
#include <numeric>

namespace stemware::fem
{

MarkedCells MeshError::mark(double share) const
{
  std::vector<double> all = foot_cells;
  all.insert(all.end(), disc_cells.begin(), disc_cells.end());
  std::vector<unsigned int> order(all.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(),
                   [&](unsigned int i, unsigned int j) { return all[i] > all[j]; });
  const double enough = share * std::accumulate(all.begin(), all.end(), 0.);
  MarkedCells marked;
  double sum = 0;
  double last = 0;
  for (auto cell = order.begin(); cell != order.end() && (sum < enough || all[*cell] == last); ++cell)
  {
    sum += last = all[*cell];
    if (*cell < foot_cells.size())
      marked.foot.push_back(*cell);
    else
      marked.disc.push_back(*cell - static_cast<unsigned int>(foot_cells.size()));
  }
  return marked;
}

} // namespace stemware::fem
