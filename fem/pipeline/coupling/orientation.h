#pragma once

#include "fem/geometry/waviness.h"
#include "fem/pipeline/study/study.h"
#include "ring_model/load/slip.h"
#include "ring_model/motion.h"

namespace stemware::pipeline
{

/// Where the marks of glass and table stand in the slip frame at @p time, the glass having yawed by @p
/// yaw_angle since t = 0: theta = chi + psi - phi -/+ pi/2 and theta = chi - phi -/+ pi/2 with the orbit
/// angle phi = +/- v t / rho, upper signs for a counter-clockwise orbit.
ring::Orientation orientation_of_marks(const ring::Motion &motion, double time, double yaw_angle);

/// Rim and table of a study as gaps.
fem::RimImperfection imperfection_of(const Study &study);

/// The periods [rad] with which the load repeats itself when glass or table turn: 2 pi over the greatest
/// common divisor of the harmonics. 0 for a perfect surface.
struct PhasePeriods
{
  double glass = 0;
  double table = 0;

  bool any() const { return glass > 0 || table > 0; }
};

PhasePeriods phase_periods(const fem::RimImperfection &imperfection);

} // namespace stemware::pipeline
