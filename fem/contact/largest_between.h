#pragma once

#include "fem/contact/azimuthal_density.h"

#include <vector>

namespace stemware::fem
{

/// Returns the largest value between @p cuts (sorted by azimuth): maximum of the polynomial through the
/// largest and three neighbours on either side, or one neighbour next to the contact's end.
double largest_between(const std::vector<CutValue> &cuts);

} // namespace stemware::fem
