#pragma once

#include "fem/contact/load_harmonics.h"
#include "fem/elasticity/elastic_material.h"
#include "fem/geometry/glass_profile.h"
#include "fem/geometry/meridian_mesh.h"
#include "fem/geometry/waviness.h"
#include "fem/revolution/body_of_revolution.h"
#include "fem/revolution/meridian_problem.h"

#include <iosfwd>
#include <memory>

namespace stemware::fem
{

class ComplianceStore;

/// What the foot stands on.
enum class TableSupport
{
  rigid,  ///< complementarity: no penetration, no pull
  mat,    ///< thin elastic mat, pressure proportional to penetration
  rough,  ///< asperities, pressure exponential in the separation
  elastic ///< thick disc of its own material, touched without penetration
};

/// A foot of revolution, its table, and how finely both are resolved.
struct RevolutionSetup
{
  GlassProfile profile;
  ElasticMaterial material;

  TableSupport support = TableSupport::mat;
  double foundation_modulus = 1e10;              ///< mat [Pa/m]
  RoughInterface interface;                      ///< rough
  TableDisc disc;                                ///< elastic
  ElasticMaterial disc_material = { 10e9, 0.3 }; ///< elastic: hardwood
  RimImperfection imperfection;
  double friction_coefficient =
    0; ///< of the friction that deforms the foot; 0: friction does not act back on the pressure

  MeridianOptions meridian;      ///< order and highest elastic harmonic
  MeridianResolution resolution; ///< see resolved_for()
  unsigned int n_lines =
    256; ///< azimuth lines of a mat or a rough interface; the other supports take 2 n_harmonics + 1
  unsigned int n_load_harmonics = 24;

  /// The same with a meridional mesh that resolves the contact under @p normal_force [N]: cells of half the
  /// contact's half-width where the support is rigid or elastic (Hertz line contact; towards the inner edge
  /// of a flat land), equal cells on a flat land.
  RevolutionSetup resolved_for(double normal_force) const;
};

/// Half-width of the Hertz contact of a crowned rim pressed evenly on its support, sqrt(4 q rho / (pi E*))
/// with q = N / (2 pi R) [m]; 0 for a flat land.
double hertz_half_width(const RevolutionSetup &setup, double normal_force);

/// An elastic foot of revolution that answers one load after another, each started from the one before: what
/// coupled spin-up needs at every step.
class FootResponse
{
public:
  /// Computes the compliances. Throws std::invalid_argument for a setup that is not allowed.
  explicit FootResponse(const RevolutionSetup &setup);
  /// The same with compliances from @p store, where other feet have left or will find them.
  FootResponse(const RevolutionSetup &setup, ComplianceStore &store);
  ~FootResponse();

  /// The load with the given resultants; marks of glass and table stand at @p phase, the foot yaws at @p
  /// spin_per_speed = omega / v [1/m] (used by friction coupling only). Started from the last solution, cold
  /// where that fails. Throws ContactFailure.
  LoadHarmonics press(const ContactLoad &load, const FootPhase &phase = {}, double spin_per_speed = 0);

  /// Whether the load depends on |M_N| alone and turns with it: no imperfection, no friction coupling. Then a
  /// one-dimensional response curve holds.
  bool is_isotropic() const;

  /// Forgets the last solution: the next load starts cold.
  void forget();

  /// The last solution; its x axis stands at direction() in the slip frame.
  const ContactSolution &solution() const;
  /// The load's maximum where is_isotropic(), else 0 [rad].
  double direction() const;
  /// Writes the foot under the last load as a VTU file: write_revolution_fields().
  void write_fields(std::ostream &file) const;
  const BodyOfRevolution &body() const;
  const TableLaw &law() const;
  unsigned int n_cold_starts() const;

private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation;
};

} // namespace stemware::fem
