#pragma once

#include "fem/pipeline/base/failures.h"
#include "fem/pipeline/study/study_file.h"
#include "ring_model/load/constants.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>
#include <string>

namespace stemware::pipeline
{

inline std::string table_name(const TableSection &table)
{
  const std::string interface = table.interface == TableInterface::hard      ? "hard"
                                : table.interface == TableInterface::winkler ? "Winkler"
                                                                             : "rough";
  return interface + (table.substrate == TableSubstrate::elastic ? " on elastic" : " on rigid");
}

/// Returns the name of the moment balance, e.g. "full, two-way", or "m = 1.24" for a prescribed moment.
inline std::string balance_name(const Study &study)
{
  if (study.load.is_static())
    return "m = " + std::to_string(study.load.moment_ratio).substr(0, 4);
  return ring::to_string(study.motion.closure) +
         (study.load.coupling == LoadCoupling::two_way ? ", two-way" : ", one-way");
}

/// Random studies of a body of revolution within realistic ranges. Equal seeds give equal studies.
class RandomStudies
{
public:
  explicit RandomStudies(unsigned int seed)
      : random(seed)
  {
  }

  Study next()
  {
    for (;;)
    {
      Study study;
      study.contact.body = BodyKind::revolution;
      draw_glass(study.glass);
      draw_table(study);
      draw_motion(study.motion);
      draw_contact(study);
      if (!draw_load(study))
        continue;
      try
      {
        check_study(study);
        return study;
      }
      catch (const BadInput &)
      {
      }
    }
  }

private:
  // std::mt19937 is portable, std::uniform_real_distribution is not.
  double between(double low, double high)
  {
    return low + (high - low) * static_cast<double>(random()) / 4294967296.;
  }
  double log_between(double low, double high) { return std::exp(between(std::log(low), std::log(high))); }
  bool happens(double probability) { return between(0, 1) < probability; }
  unsigned int one_of(unsigned int n) { return static_cast<unsigned int>(between(0, n)); }

  /// Draws a step profile or the foot of a real glass, each with probability 1/2. Sections of impossible
  /// shape are drawn again.
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
    profile.crown_radius = happens(0.15) ? 0 : log_between(0.0005, 0.012);
    profile.stem_radius = between(0.003, 0.007);
    profile.stem_height = between(0.008, 0.02);
    profile.underside_rise = between(0.001, 0.004);
    profile.edge_thickness = between(0.001, 0.0025);
    profile.fillet_radius = between(0.002, 0.006);
  }

  void draw_table(Study &study)
  {
    TableSection &table = study.table;
    const TableInterface interfaces[] = { TableInterface::hard, TableInterface::winkler,
                                          TableInterface::rough };
    table.interface = interfaces[one_of(3)];
    table.foundation_modulus = log_between(1e8, 1e12);
    table.roughness.decay_length = log_between(2e-7, 5e-6);
    table.substrate = happens(0.5) ? TableSubstrate::elastic : TableSubstrate::rigid;
    table.disc.radius = study.glass.profile.foot_radius + between(0.01, 0.12);
    table.disc.thickness = between(0.015, 0.06);
    switch (one_of(5))
    {
    case 0: // a layer of cork, rubber or felt
      table.disc.thickness = between(0.002, 0.008);
      table.disc_material = { log_between(1e6, 5e7), between(0, 0.4) };
      break;
    case 1:
      table.disc_material = { between(5e9, 15e9), between(0.2, 0.4) }; // wood
      break;
    case 2:
      table.disc_material = { between(55e9, 85e9), between(0.18, 0.26) }; // glass
      break;
    case 3:
      table.disc_material = { 210e9, 0.3 }; // steel
      break;
    default:
      table.disc_material = { log_between(1e8, 1e11), between(0, 0.45) };
    }
    if (!happens(0.1))
      return;
    const unsigned int place = one_of(3);
    if (place != 1)
      study.glass.waviness = draw_waviness();
    if (place != 0)
      table.waviness = draw_waviness();
  }

  Waviness draw_waviness()
  {
    return { { 2 + one_of(5), log_between(1e-7, 5e-6), between(-ring::pi, ring::pi) } };
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
    orbit.centre_of_mass_height = between(0.04, 0.12);
    const ring::Closure closures[] = { ring::Closure::paper, ring::Closure::hand, ring::Closure::full };
    motion.closure = closures[std::min(one_of(4), 2u)];
    motion.tilt = happens(0.8);
    if (happens(0.2))
      motion.grip_torque = log_between(1e-5, 1e-3);
  }

  void draw_contact(Study &study)
  {
    ContactSection &contact = study.contact;
    contact.friction_coupling = happens(0.75) ? FrictionCoupling::elastic : FrictionCoupling::none;
    const unsigned int rings[] = { 1, 3, 5, 5, 5, 8 };
    contact.rings = rings[one_of(6)];
    study.load.coupling = happens(0.85) ? LoadCoupling::two_way : LoadCoupling::one_way;
  }

  /// Draws a prescribed moment up to strong lift-off (probability 1/4) and returns true, or draws a moment
  /// balance and returns true if m < 1.6 at rest; the spinning glass may still tip.
  bool draw_load(Study &study)
  {
    if (happens(0.25))
    {
      study.load.moment_ratio = between(0, 1.95);
      study.load.moment_direction = between(-ring::pi, ring::pi);
      return true;
    }
    ring::Motion &orbit = study.motion.orbit;
    orbit.force_offset =
      std::max(1e-3, between(-0.02, 0.03)) - orbit.centre_of_mass_height; // above the table
    const double half_arm = study.glass.profile.contact_radius / 2;
    return ring::required_moment_at_rest(study.motion.closure, orbit).norm() <
           1.6 * orbit.normal_force() * half_arm;
  }

  std::mt19937 random;
};

inline Study four_times_finer(Study study)
{
  study.contact.refinements += 2;
  study.contact.harmonics *= 4;
  study.contact.azimuth_lines *= 4;
  return study;
}

} // namespace stemware::pipeline
