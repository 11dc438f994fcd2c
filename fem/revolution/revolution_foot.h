#pragma once

#include "fem/contact/foot.h"
#include "fem/contact/table.h"
#include "fem/contact/winkler_interface.h"
#include "fem/elasticity/elastic_material.h"
#include "fem/geometry/glass_profile.h"
#include "fem/geometry/meridian_mesh.h"
#include "fem/geometry/waviness.h"
#include "fem/revolution/body_of_revolution.h"
#include "fem/revolution/contact_compliance.h"

#include <memory>
#include <optional>

namespace stemware::fem
{

class ComplianceCache;

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
  bool friction_in_foot = true; ///< whether friction tractions deform the foot
  bool friction_in_substrate = true;

  MeridianOptions meridian;          ///< order and highest elastic harmonic
  MeridianResolution resolution;     ///< see resolved_for()
  unsigned int n_lines = 256;        ///< azimuth lines
  unsigned int n_load_harmonics = 0; ///< of the load; 0: as many as the lines resolve
  /// How stiff the spring is that stands for a hard interface, over the stiffness of the contact itself.
  double hardness = 1000;
  double fineness = 1;           ///< of the cells in the contact, over the usual
  double normal_force = 1;       ///< N that the contact is resolved for [N], see resolved_for()
  double contact_half_width = 0; ///< of a crowned rim under it, expected_half_width() [m]

  /// This setup with a meridional mesh that resolves the contact under @p normal_force [N]: cells of half the
  /// contact's half-width where the interface is hard (Hertz line contact; towards the inner edge of a flat
  /// land), equal cells on a flat land.
  RevolutionSetup resolved_for(double normal_force) const;
};

/// Half-width of the Hertz contact of a crowned rim pressed evenly on its table, sqrt(4 q rho / (pi E*)) with
/// q = N / (2 pi R) [m]; 0 for a flat land.
double hertz_half_width(const RevolutionSetup &setup, double normal_force);

/// Half-width that the contact of a crowned rim pressed evenly will have: that of its bodies or of its
/// interface, whichever is larger [m]; 0 for a flat land.
double expected_half_width(const RevolutionSetup &setup, double normal_force);

/// The foot as a body of revolution on its table. Solving is not collective; it is started from the solution
/// before, cold where that fails: then the interface is first softened until it carries on a wide band, and
/// stiffened step by step. Where that fails too, the moment grows from none to the whole in small steps; a
/// leaning glass whose path ends before that tips.
class RevolutionFoot : public Foot
{
public:
  /// Computes the compliances. Throws std::invalid_argument for a setup that is not allowed.
  explicit RevolutionFoot(const RevolutionSetup &setup);
  /// Takes the compliances from @p cache, which other feet share.
  RevolutionFoot(const RevolutionSetup &setup, ComplianceCache &cache);

  FootDescription description() const override;
  FootCapabilities capabilities() const override;
  ContactState solve(const ContactDemand &demand, const Slip &slip = {},
                     const std::function<void(const ContactIteration &)> &progress = {}) override;
  unsigned int n_load_harmonics() const override;
  LoadHarmonics gather(const ContactState &state, const std::vector<double> &ring_radii) override;
  std::vector<PointForce> point_forces(const ContactState &state) override;
  PressureMap pressure_map(const ContactState &state) override;
  std::vector<FieldFile> fields(const ContactState &state) override;

  const BodyOfRevolution &elastic_body() const { return body; }

private:
  double gap(double radius, double azimuth) const;
  void set_orientation(const FootOrientation &orientation);
  ContactSolution solve_from_before(const LinearConditions &conditions);
  /// @p largest_step: by how much the interface is stiffened at once.
  ContactSolution solve_cold(const LinearConditions &conditions, double largest_step);
  ContactSolution solve_along_moment(const LinearConditions &conditions);

  const RevolutionSetup setup;
  const std::shared_ptr<const ContactCompliance> compliance;
  FootOrientation phase; ///< that the body's gap stands at
  BodyOfRevolution body;
  const std::shared_ptr<const InterfaceLaw> interface; ///< a hard one as a stiff spring
  const std::unique_ptr<TableLaw> law;
  std::optional<ContactStart> before; ///< the solution before
};

} // namespace stemware::fem
