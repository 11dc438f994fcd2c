#pragma once

#include <functional>

namespace stemware::fem
{

/// Returns the step length of Newton's method: 1, or the stationary point of the energy if the energy
/// increases towards the end of the step. With @p may_go_beyond the step length may reach 2, because Newton
/// steps towards a narrower contact are too short.
///
/// @param slope of the energy along the step, at a step length. @param start,end slopes at the step lengths
/// 0 and 1. @param noise bound below which slopes are rounding.
double line_search_step(const std::function<double(double)> &slope, double start, double end, double noise,
                        bool may_go_beyond);

} // namespace stemware::fem
