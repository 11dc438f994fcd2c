#pragma once

#include "fem/contact/table.h"
#include "fem/contact/winkler_interface.h"
#include "fem/geometry/contact_cells.h"
#include "fem/geometry/elastic_material.h"
#include "fem/geometry/glass_profile.h"
#include "fem/geometry/waviness.h"
#include "fem/revolution/contact_compliance.h"

#include <functional>
#include <memory>
#include <vector>

namespace stemware::fem
{

/// Foot of revolution, its table, and the resolution of both.
struct RevolutionSetup
{
  GlassProfile profile;
  ElasticMaterial material;
  Table table = { std::make_shared<WinklerInterface>(), {} };
  RimImperfection imperfection;
  bool foot_is_rigid = false; ///< the foot has no compliance
  /// mu of the friction that deforms foot and substrate; 0: friction does not change the pressure.
  double friction_coefficient = 0;
  /// mu as a function of |v_rel| / v. Empty: friction_coefficient everywhere.
  std::function<double(double relative_slip)> friction_by_slip;
  bool friction_in_foot = true; ///< whether friction tractions deform the foot
  bool friction_in_substrate = true;

  MeridianOptions meridian;      ///< order and highest elastic harmonic
  MeridianResolution resolution; ///< see resolved_for()
  /// Indices of the active cells of the foot to be halved, mesh after mesh.
  std::vector<std::vector<unsigned int>> halved_cells;
  /// Number of halvings of the cells at re-entrant corners.
  unsigned int corner_halvings = 0;
  unsigned int n_lines = 256; ///< azimuth lines
  /// Penalty that represents a hard interface, over the stiffness of the contact.
  double hardness = 1000;
  double fineness = 1;                   ///< refinement of the cells in the contact, over the default
  unsigned int halvings_beyond_zone = 0; ///< halvings of the cells beyond zone_half_width()
  double normal_force = 1;       ///< N for which the mesh resolves the contact [N], see resolved_for()
  double contact_half_width = 0; ///< expected_half_width() of a crowned rim under normal_force [m]

  /// Returns this setup with a meridional mesh that resolves the contact under @p normal_force [N]. If the
  /// elasticity of the bodies shapes the pressure, cells are a sixth of the contact's half-width and a third
  /// of a thin layer. If the interface is a thousand times more compliant, all cells are halved once; a flat
  /// land then has equal cells. Under a hard interface, cells are refined towards the inner edge of a flat
  /// land.
  RevolutionSetup resolved_for(double normal_force) const;

  /// Returns the table's interface; for a hard table a penalty law whose penetration is 1 / hardness of the
  /// contact's deformation, compliance_under_band() times the pressure. Throws std::invalid_argument if no
  /// part is compliant.
  std::shared_ptr<const InterfaceLaw> interface() const;

  /// Returns the compliance of foot and substrate together, without disabled parts; @p disc: nullptr without
  /// a substrate.
  ContactCompliance total_compliance(const ContactCompliance &foot, const ContactCompliance *disc) const;

  /// Returns the half-width of the zone that may carry pressure [m]: ten half-widths of a narrow contact,
  /// which allows for a load concentrated on a part of the rim; 0 for a flat land.
  double zone_half_width() const { return 10 * contact_half_width; }

  /// Returns the options of meridional problems with forces within zone_half_width() only; on the whole land
  /// if that is 0.
  MeridianOptions meridian_of_zone() const;

  /// Returns the load per length of the rim under @p normal_force [N/m].
  double line_load(double normal_force) const;

  /// Returns the displacement of the compliant bodies per pressure on a band of @p width [m/Pa]: the smaller
  /// one of a half-space and, for a thin substrate, a laterally confined layer.
  double compliance_under_band(double width) const;

  /// Returns (1 - nu^2) / E of the compliant bodies, 1 / E* [1/Pa].
  double plane_strain_compliance() const;
};

/// Returns the half-width of the Hertz contact of a crowned rim pressed evenly on its table, sqrt(4 q rho /
/// (pi E*)) with q = N / (2 pi R) [m]; 0 for a flat land.
double hertz_half_width(const RevolutionSetup &setup, double normal_force);

/// Returns the half-width across the rim of the Hertz contact on one of three crests of a wavy, rigid,
/// crowned rim [m], the short semiaxis of the ellipse; 0 without waviness (Johnson, Contact Mechanics, 1985,
/// section 4.2). The curvature along the rim is the root of the sum of squares of the harmonics' curvatures.
double crest_half_width(const RevolutionSetup &setup, double normal_force);

/// Returns the half-width of the contact of a crowned rim without moment [m]: the larger of the half-widths
/// due to bodies and interface; 0 for a flat land. On hard crests, which the foot's unknown bending flattens,
/// the geometric mean of crest_half_width() and the half-width of an even rim, if larger.
double expected_half_width(const RevolutionSetup &setup, double normal_force);

} // namespace stemware::fem
