#pragma once

#include "fem/contact/azimuthal_density.h"

#include <vector>

namespace stemware::fem
{

/// Returns the largest value between @p cuts, sorted by azimuth: the maximum of the polynomial through the
/// largest one and three neighbours on either side, or one neighbour if the contact ends closer by.
double largest_between(const std::vector<CutValue> &cuts);

} // namespace stemware::fem
