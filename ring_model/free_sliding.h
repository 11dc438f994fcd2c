#pragma once

#include "ring_model/friction_functionals.h"
#include "ring_model/sliding_body.h"

#include <functional>
#include <vector>

namespace stemware::ring
{
/// State of a body that slides freely on a level table; SI units. Only friction acts.
struct FreeSlider
{
  SlidingBody body;            ///< footprint and pressure
  double mass;                 ///< m [kg]
  double yaw_inertia;          ///< I [kg m^2]; mass * body.mean_square_radius() if spread like the weight
  double friction_coefficient; ///< mu > 0
  double gravity = 9.81;       ///< g [m/s^2]
  double centre_of_mass_height =
    0.; ///< h [m]: the friction tilts the pressure forward by mu h (first harmonic)

  /// Throws std::invalid_argument with one sentence about the first inadmissible value.
  void validate() const;
};

/// Friction of the table on a sliding body in the slip frame, at the speed v >= 0 [m/s] and the spin omega
/// [rad/s], not both 0. A function of the ratio omega / v only (Coulomb).
using SlidingFriction = std::function<Wrench(double speed, double omega)>;

/// Inertia of a sliding body; SI units.
struct SlidingInertia
{
  double mass;         ///< m [kg]
  double yaw_inertia;  ///< I [kg m^2]
  double outer_radius; ///< R [m], of the slip ratio omega R / v

  /// Throws std::invalid_argument with one sentence about the first inadmissible value.
  void validate() const;
};

/// Position and motion on the table. The frame is fixed: x along the initial velocity, y to its left, z up.
struct SlidingState
{
  double time;    ///< [s]
  double x;       ///< [m]
  double y;       ///< [m]
  double yaw;     ///< angle turned about z [rad]
  double speed;   ///< |v| [m/s]
  double heading; ///< direction of v from x [rad]; NaN if undefined, see slide_to_stop()
  double omega;   ///< spin [rad/s]
  /// Work of friction so far [J], the integral of its power -(T.v + tau_z omega) over time.
  double friction_loss;
  double distance; ///< along the path [m]
};

/// Path of a sliding body from the start to the stop.
struct SlidingPath
{
  std::vector<SlidingState> states; ///< accepted steps, the last one at the stop (speed and spin 0)
  double final_slip_ratio;          ///< limit of omega R / v at the stop, R the outer radius
};

/**
 * Returns the friction on the body in the slip frame at @p speed [m/s] and @p omega [rad/s], with the
 * quasi-static forward tilt of the pressure p ~ 1 + r (alpha cos theta + beta sin theta) that balances the
 * friction's moment about the centre of mass.
 * @throws std::invalid_argument if the body neither slides nor spins.
 */
Wrench sliding_friction(const FreeSlider &slider, double speed, double omega);

/**
 * Computes the slide from @p speed >= 0 [m/s] and @p omega [rad/s], not both 0, to the stop. Without speed
 * the body spins in place, even if that is unstable.
 *
 * The equations are singular at the stop, where v and omega vanish together. The integration variable is
 * therefore sigma = -ln S with S^2 = v^2 + I omega^2 / m, which friction can only lower; the unknowns are
 * omega / v and the direction, and time and path follow. docs/theory/free_sliding.md. If a share of the
 * friction stays perpendicular to the motion, the direction turns without limit as sigma grows, and the
 * heading at the stop is NaN.
 *
 * @param accuracy Requested relative accuracy of a step.
 * @throws std::invalid_argument for values that are not allowed, std::runtime_error if the step control gives
 * up.
 */
SlidingPath slide_to_stop(const SlidingInertia &inertia, const SlidingFriction &friction, double speed,
                          double omega, double accuracy = 1e-12);

/**
 * Returns the slip ratio eps = omega R / v (R the outer radius) at the stop of a body that starts with @p
 * slip_ratio: the next stationary ratio in the direction in which the ratio changes. For a FreeSlider with
 * untilted pressure, stationary ratios solve eps f(eps) = t(eps) / gamma, gamma = I / (m R^2). Returns 0 if
 * the spin dies first, +-infinity if the sliding does. The root is bracketed on a grid of @p n_intervals in
 * each of 0 < |eps| < 1 and 1 < |eps| < infinity and polished to rounding; two roots in one interval are
 * missed.
 */
double final_slip_ratio(const SlidingInertia &inertia, const SlidingFriction &friction, double slip_ratio,
                        unsigned int n_intervals = 200);
} // namespace stemware::ring
