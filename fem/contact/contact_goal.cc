#include "fem/contact/contact_goal.h"

#include <algorithm>
#include <numeric>

namespace stemware::fem
{

std::vector<unsigned int> MeshError::mark(double share) const
{
  std::vector<unsigned int> order(cells.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(),
                   [&](unsigned int i, unsigned int j) { return cells[i] > cells[j]; });
  const double target = share * std::accumulate(cells.begin(), cells.end(), 0.);
  double sum = 0;
  double last = 0;
  auto end = order.begin();
  for (; end != order.end() && (sum < target || cells[*end] == last); ++end)
    sum += last = cells[*end];
  order.erase(end, order.end());
  return order;
}

} // namespace stemware::fem
