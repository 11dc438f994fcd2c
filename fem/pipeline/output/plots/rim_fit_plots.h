#pragma once

#include "fem/geometry/rim_circle.h"
#include "fem/pipeline/output/render/report.h"

namespace stemware::pipeline
{

/// The points of the land and the circle through them, heights drawn larger.
Plot rim_circle_plot(const fem::RimCircle &circle);

/// The distances of the points from the circle, between lines at one scatter.
Plot rim_residual_plot(const fem::RimCircle &circle);

} // namespace stemware::pipeline
