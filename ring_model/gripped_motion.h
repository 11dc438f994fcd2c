#pragma once

#include "ring_model/yaw_motion.h"

#include <vector>

namespace stemware::ring
{
/// Returns the motion at @p times [s] after @p start, braked by the fingers with @p grip [N m]. Other
/// arguments as in yaw_motion(). The torque is not evaluated after the last time.
std::vector<YawSample> gripped_motion(const YawSample &start, const PhasedTorqueFunction &torque,
                                      double yaw_inertia, const std::vector<double> &times, double accuracy,
                                      double spin_scale, double grip, const std::vector<double> &breaks = {});
} // namespace stemware::ring
