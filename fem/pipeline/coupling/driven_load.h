#pragma once

#include "fem/pipeline/coupling/elastic_foot.h"
#include "fem/pipeline/study/study.h"
#include "ring_model/spin/hand_drive.h"

#include <memory>

namespace stemware::pipeline
{

/// Returns tau_z(t, psi, omega) [N m], independent of the yaw angle psi, under the orbit speeds of a table:
/// contact, friction and moments are in balance at every speed, acceleration and spin, including the hand's
/// tangential force m dv/dt (moment balances hand and full). Each call solves the balance; nothing is
/// interpolated. The grip is not included. @p foot: study_foot() with its rings. The torque throws as contact
/// solves and balances.
ring::PhasedTorqueFunction driven_torque(const Study &study, const std::shared_ptr<ElasticFoot> &foot,
                                         const ring::OrbitSpeedTable &speeds);

/// Returns the breakaway of a study whose hand starts from rest, with Motion/Breakaway friction or the law's
/// coefficient at rest: the load is in balance with the static friction. Throws BadInput if the glass tips
/// before it slides.
ring::Breakaway find_breakaway(const Study &study, const std::shared_ptr<ElasticFoot> &foot,
                               const ring::OrbitSpeedTable &speeds);

} // namespace stemware::pipeline
