#pragma once

#include "fem/contact/table.h"
#include "fem/contact/winkler_interface.h"
#include "fem/elasticity/elastic_material.h"
#include "fem/geometry/glass_profile.h"
#include "fem/geometry/meridian_mesh.h"
#include "fem/geometry/waviness.h"
#include "fem/revolution/contact_compliance.h"

#include <functional>
#include <memory>
#include <vector>

namespace stemware::fem
{

/// A foot of revolution, its table, and how finely both are resolved.
struct RevolutionSetup
{
  GlassProfile profile;
  ElasticMaterial material;
  Table table = { std::make_shared<WinklerInterface>(), {} };
  RimImperfection imperfection;
  bool foot_is_rigid = false; ///< the foot has no compliance
  /// mu of the friction that deforms foot and substrate; 0: friction does not act back on the pressure.
  double friction_coefficient = 0;
  /// mu at |v_rel| / v where it depends on the slip; empty: friction_coefficient everywhere.
  std::function<double(double relative_slip)> friction_by_slip;
  bool friction_in_foot = true; ///< whether friction tractions deform the foot
  bool friction_in_substrate = true;

  MeridianOptions meridian;      ///< order and highest elastic harmonic
  MeridianResolution resolution; ///< see resolved_for()
  /// Numbers of the active cells of the foot that are halved, mesh after mesh.
  std::vector<std::vector<unsigned int>> halved;
  /// How often the cells at re-entrant corners are halved.
  unsigned int corner_halvings = 0;
  unsigned int n_lines = 256; ///< azimuth lines
  /// How stiff the spring is that stands for a hard interface, over the stiffness of the contact itself.
  double hardness = 1000;
  double fineness = 1;                   ///< of the cells in the contact, over the usual
  unsigned int halvings_beyond_zone = 0; ///< of the cells beyond zone_reach()
  double normal_force = 1;               ///< N that the contact is resolved for [N], see resolved_for()
  double contact_half_width = 0;         ///< of a crowned rim under it, expected_half_width() [m]

  /// This setup with a meridional mesh that resolves the contact under @p normal_force [N]. Where the bodies'
  /// own elasticity shapes the pressure, cells of a sixth of the contact's half-width, and of a third of a
  /// thin layer; where the interface yields a thousand times more, all cells halved once, on a
  /// flat land equal ones; towards the inner edge of a flat land under a hard interface.
  RevolutionSetup resolved_for(double normal_force) const;

  /// The table's interface, a hard one as a spring whose penetration is 1 / hardness of what the contact
  /// itself yields. Throws std::invalid_argument where nothing yields.
  std::shared_ptr<const InterfaceLaw> interface() const;

  /// Compliance of foot and substrate together, without what is switched off; @p disc: nothing without a
  /// substrate.
  ContactCompliance together(const ContactCompliance &foot, const ContactCompliance *disc) const;

  /// Distance from the contact circle up to which it may have pressure [m]: ten half-widths of a narrow
  /// contact, room for a load that gathers on a part of the rim; 0 for a flat land.
  double zone_reach() const { return 10 * contact_half_width; }

  /// The meridional problems with forces on the elements within zone_reach() alone; on the whole land where
  /// that is 0.
  MeridianOptions meridian_of_zone() const;

  /// Load per length of the rim under @p normal_force [N/m].
  double line_load(double normal_force) const;

  /// (1 - nu^2) / E of the bodies that yield, 1 / E* [1/Pa].
  double plane_strain_compliance() const;
};

/// Half-width of the Hertz contact of a crowned rim pressed evenly on its table, sqrt(4 q rho / (pi E*)) with
/// q = N / (2 pi R) [m]; 0 for a flat land.
double hertz_half_width(const RevolutionSetup &setup, double normal_force);

/// Half-width across the rim of Hertz's contact on one of three crests of a wavy, rigid, crowned rim [m], 0
/// without waviness: the short semiaxis of the ellipse (Johnson, Contact Mechanics, 1985, section 4.2). The
/// curvature along the rim is the root of the sum of the squares of all harmonics'.
double crest_half_width(const RevolutionSetup &setup, double normal_force);

/// Half-width that the contact of a crowned rim pressed evenly will have: that of its bodies or of its
/// interface, whichever is larger [m]; 0 for a flat land. On hard crests, which the foot's bending flattens
/// nobody knows how far, the geometric mean of crest_half_width() and that of an even rim, if it is larger.
double expected_half_width(const RevolutionSetup &setup, double normal_force);

} // namespace stemware::fem
