#pragma once

#include "fem/pipeline/coupling/elastic_foot.h"
#include "fem/pipeline/study/motion_section.h"
#include "ring_model/spin/hand_drive.h"

#include <memory>

namespace stemware::pipeline
{

/// Returns tau_z(t, psi, omega) [N m] without the grip, independent of the yaw angle psi, at the orbit speeds
/// of Motion/Orbit speed file. Each call solves the balance of contact, friction and moments at the present
/// speed, acceleration and spin; moment balances hand and full include the hand's tangential force m dv/dt.
/// @p foot: study_foot() with its rings; nullptr for a first-harmonic load on a ring of @p contact_radius
/// [m]. The torque throws as contact solves and balances.
ring::PhasedTorqueFunction driven_torque(const MotionSection &motion, double contact_radius,
                                         const std::shared_ptr<ElasticFoot> &foot);

/// Returns the breakaway of a study whose hand starts from rest, with Motion/Breakaway friction or the law's
/// coefficient at rest. Throws BadInput if the glass tips before it slides.
ring::Breakaway find_breakaway(const MotionSection &motion, double contact_radius,
                               const std::shared_ptr<ElasticFoot> &foot);

} // namespace stemware::pipeline
