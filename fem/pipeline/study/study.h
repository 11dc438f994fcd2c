#pragma once

#include "fem/contact/contact_newton.h"
#include "fem/contact/rough_interface.h"
#include "fem/contact/table.h"
#include "fem/elasticity/elastic_material.h"
#include "fem/geometry/foot_mesh.h"
#include "fem/geometry/glass_profile.h"
#include "fem/geometry/meridian_mesh.h"
#include "fem/pipeline/study/waviness_text.h"
#include "fem/solid/solid_body.h"
#include "ring_model/moment_balance.h"
#include "ring_model/motion.h"

#include <string>

namespace stemware::pipeline
{

/// Subsection Motion: the glass, the hand that leads it, the friction.
struct MotionSection
{
  ring::Motion orbit;
  ring::Closure closure = ring::Closure::full;
  double end_time = 2;      ///< of the spin-up [s]
  double euler_step = 1e-3; ///< largest step of the forward Euler method [s]
};

/// Subsection Glass: shape and material of the foot.
struct GlassSection
{
  fem::GlassProfile profile;
  fem::ElasticMaterial material;
  Waviness waviness; ///< of the rim, fixed to the glass: positive where it is higher above the table
};

enum class TableKind
{
  rigid,
  mat,
  rough,
  elastic
};

/// Subsection Table.
struct TableSection
{
  TableKind kind = TableKind::mat;
  double foundation_modulus = 1e10; ///< of the mat [Pa/m]
  fem::RoughInterface roughness;    ///< of a rough table
  fem::TableDisc disc;              ///< an elastic table
  fem::ElasticMaterial disc_material = { 10e9, 0.3 };
  Waviness waviness; ///< fixed to the ground: positive where the table is lower

  /// The table as the finite elements know it, which is to be asked instead of its kind.
  fem::Table make() const;
  /// Whether the surface yields nothing by itself (Signorini's condition): there friction decides the second
  /// harmonic of a foot that does not lift off (docs/method/revolution.md).
  bool is_hard() const;
};

enum class BodyKind
{
  solid,     ///< three-dimensional finite elements
  revolution ///< displacement harmonics on a meridional mesh
};

/// What only one of the two bodies can do.
struct BodyAbilities
{
  bool reads_meshes = false;     ///< takes its shape from Contact/Mesh file
  bool is_of_revolution = false; ///< answers a moment in all directions alike, and has a gap that can turn
  bool stands_on_elastic_disc = false;
  bool friction_can_deform = false; ///< friction tractions can act back on the pressure
  bool is_collective = false;       ///< solving takes all MPI ranks together
  unsigned int highest_degree = 2;  ///< of its elements
};

BodyAbilities abilities(BodyKind body);

enum class FrictionCoupling
{
  automatic, ///< elastic for a body of revolution on a hard table, else none; see
             ///< Study::friction_deforms_foot()
  none,      ///< friction tractions do not act back on the pressure
  elastic    ///< they do
};

/// Subsection Contact: the elastic body and its discretisation.
struct ContactSection
{
  BodyKind body = BodyKind::revolution;
  std::string mesh_file; ///< empty: the mesh is generated from the glass
  unsigned int degree = 2;
  fem::FootResolution resolution;
  fem::LinearSolver linear_solver = fem::LinearSolver::automatic;
  unsigned int refinements = 0; ///< halvings of every cell of a body of revolution
  double land_grading = 3;      ///< size ratio of neighbouring cells across the land of a body of revolution
  unsigned int harmonics = 16;  ///< of a body of revolution
  unsigned int azimuth_lines = 256; ///< on which a body of revolution meets a mat or a rough table
  FrictionCoupling friction_coupling = FrictionCoupling::automatic;
};

enum class LoadSource
{
  contact,        ///< the finite-element contact
  first_harmonic, ///< the paper's ansatz, balanced at every spin; no finite elements
  file            ///< Fourier coefficients from a file
};

enum class LoadCoupling
{
  frozen,   ///< the load of omega = 0 at every spin
  response, ///< a curve of loads over the moment ratio, interpolated
  exact     ///< the contact is solved again, in balance with the friction, at every spin
};

/// Subsection Load: where lambda(theta) comes from.
struct LoadSection
{
  LoadSource source = LoadSource::contact;
  LoadCoupling coupling = LoadCoupling::frozen;
  double response_tolerance = 1e-6;     ///< of coupling = response, over a_0
  double moment_ratio = -1;             ///< m = |M_N| / (N R / 2); negative: the closure's
  double moment_direction = -1.5707963; ///< theta of the load's maximum [rad], used with moment_ratio >= 0
  std::string file;                     ///< Fourier coefficients, used with source = file

  bool is_from_contact() const { return source == LoadSource::contact; }
  /// Whether the moment is given, instead of following from the moment balance.
  bool is_static() const { return moment_ratio >= 0; }
  /// Whether the load is one of a contact in balance with friction at every spin.
  bool is_in_balance() const { return is_from_contact() && !is_static() && coupling != LoadCoupling::frozen; }
};

/// Everything that a study file says: one member per subsection. SI units, or any other consistent set.
struct Study
{
  MotionSection motion;
  GlassSection glass;
  TableSection table;
  ContactSection contact;
  LoadSection load;

  /// Whether rim or table are out of flat: the load then depends on where their marks stand.
  bool has_waviness() const { return !glass.waviness.empty() || !table.waviness.empty(); }

  /// Whether friction tractions deform the foot: what Contact/Friction coupling asks for, and with
  /// `automatic` where it matters and the body can, a body of revolution on a hard table.
  bool friction_deforms_foot() const;

  /// What the table's pressure has to balance at omega = 0, where the friction is exactly (-mu N, 0): N = m g
  /// with the closure's moment, or with the given moment of a static study, M_N = m N R/2 (sin,
  /// -cos)(direction of the load's maximum) [N, N m]. Throws BadInput when the foot would tip, m >= 2.
  fem::Resultants required_resultants() const;
};

/// m = |M_N| / (N R / 2).
double moment_ratio(const fem::Resultants &load, double contact_radius);

/// A sentence without subject for the console where the table is hard, so that friction matters for the
/// pressure: whether friction deforms the foot. Empty elsewhere.
std::string friction_note(const Study &study);

/// Throws BadInput, with one sentence, for values that do not go together, that no physical system has, or
/// that this version does not know.
void check_study(const Study &study);

/// Refuses a study whose rim or table is out of flat for @p verb, which follows one load over the spin: that
/// of such a study depends on the yaw angle too. Throws BadInput.
void require_flat(const Study &study, const std::string &verb);

} // namespace stemware::pipeline
