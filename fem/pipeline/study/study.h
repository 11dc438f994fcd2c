#pragma once

#include "fem/contact/linear_conditions.h"
#include "fem/pipeline/study/contact_section.h"
#include "fem/pipeline/study/glass_section.h"
#include "fem/pipeline/study/load_section.h"
#include "fem/pipeline/study/motion_section.h"
#include "fem/pipeline/study/table_section.h"

#include <cmath>
#include <map>
#include <string>

namespace stemware::pipeline
{

/// Content of a study file, one member per subsection. SI units, or any other consistent set.
struct Study
{
  MotionSection motion;
  GlassSection glass;
  TableSection table;
  ContactSection contact;
  LoadSection load;
  /// Text of the entries set by a study file or an option, by "Section/Entry".
  std::map<std::string, std::string> given_entries;
  std::string name = "default"; ///< name of the study's file; not an entry

  /// Returns true with waviness of rim or table: the load then depends on the phase.
  bool has_waviness() const { return !glass.waviness.empty() || !table.waviness.empty(); }

  /// Returns true if friction tractions deform foot and substrate.
  bool friction_deforms() const { return contact.friction_coupling == FrictionCoupling::elastic; }

  /// Returns true if the spin affects the contact: friction enters the moment balance or deforms the foot.
  bool depends_on_spin() const;

  /// Returns true if every spin has its own balance of contact, friction and moments, and so its own load.
  bool varies_with_spin() const { return load.is_in_balance() && depends_on_spin(); }

  /// Returns true if all ranks must solve the foot together.
  bool is_collective() const { return load.is_from_contact() && !contact.is_of_revolution(); }

  /// Returns FootResolution::edge_halvings of a solid foot: fem::edge_halvings_for() for a generated mesh,
  /// but at most 2 with a goal, whose mesh is refined further; 0 for a mesh file.
  unsigned int edge_halvings() const;

  /// Returns true if the tilt of the glass enters the moment balance: Motion/Tilt = included, Motion/Closure
  /// = full, and a contact whose moment is not given.
  bool tilts() const;

  /// Returns the resultants required at omega = 0, where the friction is exactly (-mu N, 0): the weight N,
  /// and the moment of the moment balance or, with Load/Moment ratio m, M_N = m N R/2 (sin, -cos)(direction
  /// of the load's maximum) [N, N m]. Throws ring::Tipping if m >= tipping_ratio().
  fem::Resultants required_resultants() const;

  /// Returns the moment ratio at which the glass tips: 2 r_o / R on a flat land of outer radius r_o, 2 on a
  /// crowned rim or a ring. Infinite for a mesh file, whose contact zone is not known here.
  double tipping_ratio() const;

  /// Returns v / R with the contact radius of the glass [rad/s].
  double spin_unit() const { return motion.orbit.orbit_speed / glass.profile.contact_radius; }

  /// Returns the first-order terminal spin 2 |M_Nx| / (N R) v/R, from the moment at rest, limited to 1e-6 ...
  /// 1 of v/R [rad/s]; v/R without M_Nx or for a load file.
  double spin_scale() const;

  /// Returns the rounding error of spins and of their differences [rad/s].
  double rounding_of_spins() const { return 1e-9 * spin_scale(); }

  /// Returns true if @p omega exceeds rounding_of_spins().
  bool is_spin(double omega) const { return std::abs(omega) >= rounding_of_spins(); }

  /// Returns a clause: whether friction deforms the foot, and whether this may matter.
  std::string friction_note() const;

  /// Returns a sentence if the load at rest is used although it depends on the spin, else an empty string.
  std::string frozen_note() const;

  /// Throws BadInput for incompatible, unphysical or unsupported values.
  void check_values() const;
};

/// Returns the moment ratio m = |M_N| / (N R / 2) of @p load, R = @p contact_radius [m].
double moment_ratio(const fem::Resultants &load, double contact_radius);

} // namespace stemware::pipeline
