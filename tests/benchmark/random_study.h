#pragma once

#include "fem/pipeline/study/study.h"

#include <cmath>
#include <random>
#include <stdexcept>

namespace stemware::pipeline
{

/// Studies of a body of revolution with random glass, table, moment and closure within what a kitchen and its
/// tables offer. Equal seeds make equal studies.
class RandomStudies
{
public:
  explicit RandomStudies(unsigned int seed)
      : random(seed)
  {
  }

  Study next()
  {
    Study study;
    study.contact.body = BodyKind::revolution;
    draw_glass(study.glass);
    draw_table(study.table);
    draw_motion(study.motion);
    draw_load(study);
    return study;
  }

private:
  // std::uniform_real_distribution differs between libraries; the generator itself does not.
  double between(double low, double high)
  {
    return low + (high - low) * static_cast<double>(random()) / 4294967296.;
  }
  double log_between(double low, double high) { return std::exp(between(std::log(low), std::log(high))); }
  bool happens(double probability) { return between(0, 1) < probability; }

  /// Half of the glasses are step profiles, the others have the foot of a real glass; sections that no glass
  /// has are drawn anew.
  void draw_glass(GlassSection &glass)
  {
    glass.material.young_modulus = between(55e9, 85e9);
    glass.material.poisson_ratio = between(0.18, 0.26);
    for (;;)
      try
      {
        draw_profile(glass.profile);
        glass.profile.validate();
        return;
      }
      catch (const std::invalid_argument &)
      {
      }
  }

  void draw_profile(fem::GlassProfile &profile)
  {
    profile.shape = happens(0.5) ? fem::GlassShape::foot : fem::GlassShape::step;
    profile.contact_radius = between(0.022, 0.042);
    profile.land_width = between(0.002, 0.005);
    profile.land_height = between(0.0005, 0.0015);
    profile.foot_radius = profile.land_outer_radius() + between(0.001, 0.004);
    profile.foot_thickness = between(0.002, 0.006);
    profile.crown_radius = happens(0.25) ? 0 : log_between(0.001, 0.02);
    profile.stem_radius = between(0.003, 0.007);
    profile.stem_height = between(0.008, 0.02);
    profile.underside_rise = between(0.001, 0.004);
    profile.edge_thickness = between(0.001, 0.0025);
    profile.fillet_radius = between(0.002, 0.006);
  }

  void draw_table(TableSection &table)
  {
    table.interface = happens(0.25) ? TableInterface::rough : TableInterface::winkler;
    table.foundation_modulus = log_between(1e8, 1e12);
    table.roughness.decay_length = log_between(3e-7, 5e-6);
  }

  void draw_motion(MotionSection &motion)
  {
    ring::Motion &orbit = motion.orbit;
    orbit.mass = between(0.12, 0.5);
    orbit.yaw_inertia = between(1e-4, 5e-4);
    orbit.orbit_radius = between(0.1, 0.25);
    orbit.orbit_speed = between(0.2, 0.5);
    orbit.friction_coefficient = between(0.15, 0.4);
    orbit.orbit_sense = happens(0.5) ? ring::OrbitSense::counterclockwise : ring::OrbitSense::clockwise;
    orbit.centre_of_mass_height = between(0.05, 0.1);
    motion.closure = happens(0.5) ? ring::Closure::full : ring::Closure::paper;
  }

  /// Half of the studies get a moment up to strong lift-off, the others that of their closure, below N R / 2
  /// at rest, with contact and friction in balance at every spin.
  void draw_load(Study &study)
  {
    if (happens(0.5))
    {
      study.load.moment_ratio = between(0.1, 1.7);
      study.load.moment_direction = between(-M_PI, M_PI);
      return;
    }
    study.load.coupling = LoadCoupling::two_way;
    ring::Motion &orbit = study.motion.orbit;
    const double half_arm = study.glass.profile.contact_radius / 2;
    do
    {
      orbit.orbit_speed = between(0.2, 0.5);
      orbit.force_offset = between(-0.02, 0.03) - orbit.centre_of_mass_height;
    } while (ring::required_moment_at_rest(study.motion.closure, orbit).norm() >
             0.95 * orbit.normal_force() * half_arm);
  }

  std::mt19937 random;
};

/// The study four times finer in everything: cells, harmonics, azimuth lines.
inline Study four_times_finer(Study study)
{
  study.contact.refinements += 2;
  study.contact.harmonics *= 4;
  study.contact.azimuth_lines *= 4;
  return study;
}

} // namespace stemware::pipeline
