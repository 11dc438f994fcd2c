#pragma once

#include <functional>

namespace stemware::fem
{

/// Returns the step length of Newton's method: 1, or the stationary point of the energy if the energy
/// increases towards the end of the step. With @p may_go_beyond the step length may reach 2, because Newton
/// steps towards a narrower contact are too short.
///
/// @p slope: slope of the energy along the step, as a function of the step length. @p start, @p end: slopes
/// at the step lengths 0 and 1. Slopes below @p noise are rounding.
double line_search_step(const std::function<double(double)> &slope, double start, double end, double noise,
                        bool may_go_beyond);

} // namespace stemware::fem
