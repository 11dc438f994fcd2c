#pragma once

#include "fem/pipeline/study/study.h"
#include "fem/pipeline/support/progress.h"
#include "ring_model/free_sliding.h"

#include <optional>
#include <string>
#include <vector>

namespace stemware::pipeline
{

/// Body that is pushed and let go.
enum class SlidingBodyKind
{
  glass,   ///< the study's foot on its table, its pressure in balance with its friction at every slip ratio
  ring,    ///< a thin ring of the contact radius
  annulus, ///< uniform pressure between an inner radius and the contact radius
  disc     ///< the annulus without a hole
};

/// "glass", "ring", "annulus" or "disc".
std::string to_string(SlidingBodyKind kind);

/// Slide to be computed: body and initial motion.
struct SlideQuestion
{
  SlidingBodyKind body = SlidingBodyKind::glass;
  double speed = 1;        ///< v_0 > 0 [m/s]
  double spin = 20;        ///< omega_0, counter-clockwise positive [rad/s]
  double inner_radius = 0; ///< of an annulus [m]
};

/// A moment of the slide.
struct SlidePoint
{
  ring::SlidingState state;
  double slip_ratio;        ///< omega R / v; at the stop its limit
  ring::Wrench friction;    ///< just before the stop for the last one
  double side_acceleration; ///< T_y / m, to the left of the motion [m/s^2]
  double kinetic_energy;    ///< [J]
  double moment_ratio;      ///< what tilts the pressure over what makes a linear one vanish at the rim
};

/// A body that is pushed, let go, and comes to rest.
struct SlideStudy
{
  SlideQuestion question;
  ring::SlidingInertia inertia;
  double centre_of_mass_height = 0; ///< h [m]
  double friction_coefficient = 0;
  double gravity = 0;             ///< [m/s^2]
  std::vector<SlidePoint> points; ///< from the push to the stop
  /// omega R / v in the limit of the stop: 0 where the spin, infinite where the sliding dies first.
  double final_slip_ratio = 0;
  double energy_error = 0; ///< largest |kinetic energy + friction loss - its start| over the start
  double load_error = 0;   ///< of the glass's load between solved slip ratios, over a_0
  /// Largest change of the friction of a glass on contact cells twice as large with half the elastic
  /// harmonics, at the push, half-way to the final slip ratio and there: of T over mu N, of tau_z over mu N
  /// R. Nothing where the load does not come from the contact of a body of revolution.
  std::optional<double> mesh_change = {};
  bool inertia_is_given = false; ///< by the study, else that of the body's own pressure
  bool height_is_given = false;  ///< by the study, else 0; a glass has the study's in any case

  const SlidePoint &start() const { return points.front(); }
  const SlidePoint &stop() const { return points.back(); }
  /// The largest moment ratio on the way.
  double largest_moment_ratio() const;
  /// Whether a part of the pressure would have to pull; a glass lifts off instead.
  bool is_formal() const { return question.body != SlidingBodyKind::glass && largest_moment_ratio() > 1; }
};

/// Throws BadInput where @p question cannot be asked of @p study.
void check_slide(const Study &study, const SlideQuestion &question);

/// Pushes the body and follows it to the stop. Mass, friction and gravity are those of Motion, the outer
/// radius is Glass/Contact radius. A ring, an annulus and a disc have the inertia of a body whose mass is
/// spread like its pressure, and its centre of mass on the table, unless the study gives Motion/Yaw inertia
/// and Motion/Centre of mass height. Throws BadInput, what contacts and balances throw, and
/// std::runtime_error where the body tips or the glass's spin outlasts its sliding.
SlideStudy study_slide(const Study &study, const SlideQuestion &question,
                       Progress &progress = silent_progress());

/// The given entries that have no effect on that slide.
std::vector<std::string> idle_in_slide(const Study &study, SlidingBodyKind body);

} // namespace stemware::pipeline
