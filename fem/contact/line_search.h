#pragma once

#include <functional>

namespace stemware::fem
{

/// The share of a Newton step to take: all of it unless the energy rises again towards its end, then where it
/// is stationary. Where @p may_go_beyond, up to twice the step: Newton's steps towards a narrower contact are
/// too short.
///
/// @param slope of the energy along the step, at a share of it.
/// @param start,end slopes at the shares 0 and 1.
/// @param noise below which slopes say nothing.
double step_of_least_energy(const std::function<double(double)> &slope, double start, double end,
                            double noise, bool may_go_beyond);

} // namespace stemware::fem
