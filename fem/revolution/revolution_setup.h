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
  /// mu of the friction that deforms foot and substrate; 0: no effect on the pressure.
  double friction_coefficient = 0;
  /// mu as a function of |v_rel| / v. Empty: friction_coefficient everywhere.
  std::function<double(double relative_slip)> friction_by_slip;
  bool friction_in_foot = true; ///< whether friction tractions deform the foot
  bool friction_in_substrate = true;

  MeridianOptions meridian;      ///< order and highest elastic harmonic
  MeridianResolution resolution; ///< see resolved_for()
  /// Indices of the foot's active cells to be halved, mesh after mesh.
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
  /// elasticity of the bodies shapes the pressure, cells are 1/6 of the contact's half-width and 1/3 of a
  /// thin layer; on an interface 1000 times more compliant, all cells are halved once, and equal on a flat
  /// land. Under a hard interface, cells are refined towards the inner edge of a flat land.
  RevolutionSetup resolved_for(double normal_force) const;

  /// Returns the table's interface; for a hard table a penalty law whose penetration is 1 / hardness of the
  /// bodies' displacement under a band of pressure: of a half-space or, if smaller, of the substrate as a
  /// laterally confined layer. Throws std::invalid_argument if no part is compliant.
  std::shared_ptr<const InterfaceLaw> interface() const;

  /// Returns the compliance of foot and substrate without disabled parts. @p disc: nullptr without substrate.
  ContactCompliance total_compliance(const ContactCompliance &foot, const ContactCompliance *disc) const;

  /// Returns the half-width of the zone that may be in contact [m]: ten half-widths of the contact, for loads
  /// concentrated on a part of the rim; 0 for a flat land.
  double zone_half_width() const { return 10 * contact_half_width; }

  /// Returns the options for forces within zone_half_width() only; on the whole land if the width is 0.
  MeridianOptions meridian_of_zone() const;

  /// Returns the load per length of the rim under @p normal_force [N/m].
  double line_load(double normal_force) const;

  /// Returns (1 - nu^2) / E of the compliant bodies, 1 / E* [1/Pa].
  double plane_strain_compliance() const;
};

/// Returns the Hertz half-width of a crowned rim pressed evenly on its table, sqrt(4 q rho / (pi E*)) with q
/// = N / (2 pi R) [m]; 0 for a flat land.
double hertz_half_width(const RevolutionSetup &setup, double normal_force);

/// Returns the half-width across the rim of the Hertz ellipse on one of three crests of a wavy, rigid,
/// crowned rim [m] (Johnson, Contact Mechanics, 1985, section 4.2); 0 without waviness. Curvature along the
/// rim: root sum of squares of the harmonics' curvatures.
double crest_half_width(const RevolutionSetup &setup, double normal_force);

/// Returns the half-width of the contact of a crowned rim without moment [m]: the larger one due to bodies or
/// interface; 0 for a flat land. On hard crests, flattened by an unknown bending of the foot, the geometric
/// mean of crest_half_width() and the even rim's half-width, if larger.
double expected_half_width(const RevolutionSetup &setup, double normal_force);

} // namespace stemware::fem
