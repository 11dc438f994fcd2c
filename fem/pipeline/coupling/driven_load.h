#pragma once

#include "fem/pipeline/coupling/elastic_foot.h"
#include "fem/pipeline/study/study.h"
#include "ring_model/orbit_speed_table.h"
#include "ring_model/yaw_motion.h"

#include <memory>

namespace stemware::pipeline
{

/// Returns tau_z(t, psi, omega) [N m], independent of the yaw angle psi, under the orbit speeds of a table:
/// contact, friction and moments are in balance at every speed, acceleration and spin, including the hand's
/// tangential force m dv/dt (closures hand and full). Each call solves the balance; nothing is interpolated.
/// The grip is not included. @p foot: study_foot() with its rings. The torque throws as contact solves and
/// balances.
ring::PhasedTorqueFunction driven_torque(const Study &study, const std::shared_ptr<ElasticFoot> &foot,
                                         const ring::OrbitSpeedTable &speeds);

/// The moment at which a glass that rests begins to slide under a growing force of the hand.
struct Breakaway
{
  double time = 0;                 ///< at which the hand starts [s]
  double friction_coefficient = 0; ///< of that moment
  double force = 0;                ///< of the hand, along the motion to come [N]
  double moment_ratio = 0;         ///< of the load
};

/// The breakaway of a study whose hand starts from rest, with Motion/Breakaway friction or the law's
/// coefficient at rest: the load is in balance with the static friction. Throws BadInput if the glass falls
/// over before it slides.
Breakaway find_breakaway(const Study &study, const std::shared_ptr<ElasticFoot> &foot,
                         const ring::OrbitSpeedTable &speeds);

} // namespace stemware::pipeline
