#pragma once

#include <functional>

namespace stemware::fem
{

/// Returns the step length of Newton's method: 1, or the stationary point of the energy if the energy
/// increases at the end of the step. @p may_go_beyond: up to 2, because steps towards a narrower contact are
/// too short. @p slope: energy slope at a step length; @p start, @p end: slopes at 0 and 1; @p noise:
/// rounding of slopes.
double line_search_step(const std::function<double(double)> &slope, double start, double end, double noise,
                        bool may_go_beyond);

} // namespace stemware::fem
