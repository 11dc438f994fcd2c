#pragma once

#include "fem/contact/rough_interface.h"
#include "fem/elasticity/elastic_material.h"
#include "fem/geometry/foot_mesh.h"
#include "fem/geometry/glass_profile.h"
#include "fem/geometry/meridian_mesh.h"
#include "fem/pipeline/study/waviness_text.h"
#include "fem/solid/solid_body.h"
#include "ring_model/closures.h"
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
};

enum class BodyKind
{
  solid,     ///< three-dimensional finite elements
  revolution ///< displacement harmonics on a meridional mesh
};

enum class FrictionCoupling
{
  automatic, ///< elastic for a body of revolution on a hard table, else none; see used_friction_coupling()
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

  bool is_static() const { return moment_ratio >= 0; }
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
};

/// Throws BadInput, with one sentence, for values that do not go together, that no physical system has, or
/// that this version does not know.
void check_study(const Study &study);

} // namespace stemware::pipeline
