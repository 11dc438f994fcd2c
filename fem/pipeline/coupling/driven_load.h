#pragma once

#include "fem/pipeline/coupling/elastic_foot.h"
#include "fem/pipeline/study/study.h"
#include "ring_model/orbit_speed_table.h"
#include "ring_model/yaw_motion.h"

#include <memory>

namespace stemware::pipeline
{

/// tau_z(t, psi, omega) [N m], the same at every yaw angle psi, while the hand leads the glass with the
/// speeds of a table: contact, friction and moments are in balance at every speed, acceleration and spin,
/// with the hand's tangential force m dv/dt (closures hand and full). The balance is solved at each call, not
/// interpolated. The grip is not in it. @p foot is study_foot() and has its rings. The torque throws what
/// contacts and balances throw.
ring::PhasedTorqueFunction driven_torque(const Study &study, const std::shared_ptr<ElasticFoot> &foot,
                                         const ring::OrbitSpeedTable &speeds);

} // namespace stemware::pipeline
