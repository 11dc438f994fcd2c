#pragma once

#include "fem/contact/linear_conditions.h"
#include "fem/pipeline/study/contact_section.h"
#include "fem/pipeline/study/glass_section.h"
#include "fem/pipeline/study/load_section.h"
#include "fem/pipeline/study/motion_section.h"
#include "fem/pipeline/study/table_section.h"

#include <map>
#include <string>

namespace stemware::pipeline
{

/// Parts of the model that a budget leaves out one at a time. They are no entries of a study file.
struct ModelChoices
{
  bool foot_is_rigid = false;        ///< the foot has no compliance
  bool friction_in_foot = true;      ///< friction deforms the foot, where Study::friction_deforms()
  bool friction_in_substrate = true; ///< and an elastic substrate
  bool waviness = true;              ///< rim and table are as wavy as the study says
};

/// Everything that a study file says: one member per subsection. SI units, or any other consistent set.
struct Study
{
  MotionSection motion;
  GlassSection glass;
  TableSection table;
  ContactSection contact;
  LoadSection load;
  ModelChoices model;
  /// "Section/Entry" of those that a study file or an option has set, with the text that they were given.
  std::map<std::string, std::string> given_entries;
  std::string name = "default"; ///< that people know it by: of its file; not an entry

  /// True if rim or table are out of flat: the load then depends on where their marks stand.
  bool has_waviness() const { return model.waviness && (!glass.waviness.empty() || !table.waviness.empty()); }

  /// True if friction tractions deform foot and substrate.
  bool friction_deforms() const { return contact.friction_coupling == FrictionCoupling::elastic; }

  /// True if the lean of the glass on its foot counts in the balance of moments: Motion/Tilt = included, in
  /// the closure full, on a contact whose moment is not given.
  bool tilts() const;

  /// Resultants asked of the table at omega = 0, where the friction is exactly (-mu N, 0): N = m g with the
  /// closure's moment, or with the given moment of a static study, M_N = m N R/2 (sin, -cos)(direction of the
  /// load's maximum) [N, N m]. Throws BadInput when the foot would tip, m >= 2.
  fem::Resultants required_resultants() const;
};

/// m = |M_N| / (N R / 2).
double moment_ratio(const fem::Resultants &load, double contact_radius);

/// A sentence without subject for the console: whether friction deforms the foot of a contact, and that this
/// may matter where interface and table are stiff. Empty where there is no contact.
std::string friction_note(const Study &study);

/// Throws BadInput, with one sentence, for values that do not go together, that no physical system has, or
/// that this version does not know.
void check_values(const Study &study);

/// Refuses a study whose rim or table is out of flat for @p verb, which follows one load over the spin: that
/// of such a study depends on the yaw angle too. Throws BadInput.
void require_flat(const Study &study, const std::string &verb);

} // namespace stemware::pipeline
