#pragma once

#include "fem/contact/contact_goal.h"
#include "fem/contact/contact_newton.h"
#include "fem/contact/rough_interface.h"
#include "fem/contact/table.h"
#include "fem/elasticity/elastic_material.h"
#include "fem/elasticity/linear_solver.h"
#include "fem/geometry/foot_mesh.h"
#include "fem/geometry/glass_profile.h"
#include "fem/geometry/meridian_mesh.h"
#include "fem/geometry/mesh_io.h"
#include "fem/geometry/rim_circle.h"
#include "fem/pipeline/study/quantity_text.h"
#include "ring_model/load/ring_stack.h"
#include "ring_model/moment_balance.h"
#include "ring_model/motion.h"
#include "ring_model/orbit_speed_table.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace stemware::pipeline
{

/// Subsection Motion: the glass, the hand that leads it, the friction.
struct MotionSection
{
  ring::Motion orbit;
  ring::Closure closure = ring::Closure::full;
  bool tilt = true;             ///< the glass leans on its foot; see Study::tilts()
  double grip_torque = 0;       ///< of the fingers, against the spin [N m]
  std::string orbit_speed_file; ///< v(t) of the spin-up; empty: Motion/Orbit speed throughout
  std::shared_ptr<const ring::OrbitSpeedTable> orbit_speeds = {}; ///< of that file, where there is one
  std::string measured_spin_file; ///< points that are drawn beside the spin-up; empty: none
  double end_time = 2;            ///< of the spin-up [s]
  double euler_step = 1e-3;       ///< largest step of the forward Euler method [s]
  double step_limit = 1e6;        ///< estimated steps of the spin-up above which a study is refused
};

/// Subsection Glass: shape and material of the foot, by default the foot of a wine glass.
struct GlassSection
{
  GlassSection() { profile.shape = fem::GlassShape::foot; }

  fem::GlassProfile profile;
  std::string profile_file;          ///< points of the section, for the shape profile
  unsigned int n_profile_points = 0; ///< that it has
  /// Through the points of the land, where contact or crown radius follow from it; what the study was given
  /// has no error there.
  std::shared_ptr<const fem::RimCircle> rim_circle = {};
  fem::ElasticMaterial material;
  Waviness waviness; ///< of the rim, fixed to the glass: positive where it is higher above the table
};

/// The law by which foot and table touch.
enum class TableInterface
{
  hard,    ///< Signorini's conditions: no penetration, no tension
  winkler, ///< pressure proportional to the penetration
  rough    ///< pressure exponential in the distance
};

/// Body under the table's interface.
enum class TableSubstrate
{
  rigid,
  elastic ///< a disc, held at its bottom
};

/// Subsection Table: an interface on a substrate.
struct TableSection
{
  TableInterface interface = TableInterface::winkler;
  TableSubstrate substrate = TableSubstrate::rigid;
  double foundation_modulus = 1e10; ///< of the Winkler interface [Pa/m]
  double layer_thickness = 0;       ///< of the layer that a Winkler interface stands for [m]; 0: not named
  fem::RoughInterface roughness;
  fem::TableDisc disc; ///< the elastic substrate
  fem::ElasticMaterial disc_material = { 10e9, 0.3 };
  Waviness waviness; ///< fixed to the ground: positive where the table is lower

  /// The table as the finite elements know it, which is to be asked instead of these names.
  fem::Table make() const;
  /// Whether the interface yields nothing by itself (Signorini's conditions).
  bool is_hard() const;
};

enum class BodyKind
{
  solid,     ///< three-dimensional finite elements
  revolution ///< displacement harmonics on a meridional mesh
};

/// Abilities that only one of the two bodies has.
struct BodyAbilities
{
  bool reads_meshes = false;     ///< takes its shape from Contact/Mesh file
  bool is_of_revolution = false; ///< answers a moment in all directions alike, and has a gap that can turn
  bool stands_on_elastic_disc = false;
  bool is_collective = false;      ///< solving takes all MPI ranks together
  unsigned int highest_degree = 2; ///< of its elements
};

BodyAbilities abilities(BodyKind body);

enum class FrictionCoupling
{
  none,   ///< friction tractions do not act back on the pressure
  elastic ///< they deform foot and substrate
};

/// The number that a mesh is refined for.
enum class Goal
{
  none,
  terminal_spin,
  a2,    ///< a_2 / a_0 at rest
  torque ///< at half the terminal spin
};

/// Most rings on which a load is gathered. Nodes with forces lie beside the band of the J Chebyshev points
/// too, where the polynomials that share a force among the rings grow like cosh(J acosh x), x the distance
/// from the band's middle over its half-width. They take turns in sign, so that the sum is right, but
/// rounding, 1e-16, grows with them: at x = 1.5 to 1e-6 of the load with 25 rings, 1e-3 with 32, and all of
/// it with 40.
constexpr unsigned int most_rings = 25;

/// Subsection Contact: the elastic body and its discretisation.
struct ContactSection
{
  BodyKind body = BodyKind::revolution;
  std::string mesh_file; ///< empty: the mesh is generated from the glass
  fem::MeshMarks mesh_marks;
  std::string checkpoint_folder; ///< empty: no checkpoint is kept
  std::string checkpoint_owner;  ///< the study as it was given, whose variants share the folder; not an entry
  unsigned int degree = 2;
  fem::FootResolution resolution;
  fem::LinearSolver linear_solver = fem::LinearSolver::automatic;
  unsigned int refinements = 0; ///< halvings of every cell
  double land_grading = 3;      ///< size ratio of neighbouring cells across the land of a body of revolution
  unsigned int harmonics = 16;  ///< of a body of revolution
  unsigned int azimuth_lines = 128; ///< on which a body of revolution meets the table
  unsigned int rings = 5;           ///< that take the pressure over
  double fineness = 1;              ///< of the cells, over the usual; not an entry: error bands change it
  unsigned int halvings_beyond_zone = 0; ///< of cells, see fem::RevolutionSetup; likewise
  double hardness = 1; ///< of the spring in the place of a hard interface, over the usual; below 1 under a
                       ///< solid foot of any interface over its own; not an entry
  unsigned int load_harmonics = 0; ///< of each ring; 0: as many as the lines resolve and the kernels ask for
  FrictionCoupling friction_coupling = FrictionCoupling::elastic;
  Goal goal = Goal::none;
  double goal_tolerance = 1e-5; ///< on the goal's estimated error, relative to its value
  std::vector<fem::MarkedCells>
    halved; ///< cells, mesh by mesh, by the body's numbers; not an entry: the goal asks for them
  double memory_limit = 4e9; ///< estimated memory above which a study is refused [byte]
};

enum class LoadSource
{
  contact,        ///< the finite-element contact
  first_harmonic, ///< the paper's ansatz, balanced at every spin; no finite elements
  file            ///< Fourier coefficients from a file
};

enum class LoadCoupling
{
  two_way, ///< contact, friction and moments are in balance at every spin
  one_way  ///< the load of omega = 0 is kept at every spin
};

/// Subsection Load: where lambda(theta) comes from.
struct LoadSection
{
  LoadSource source = LoadSource::contact;
  LoadCoupling coupling = LoadCoupling::two_way;
  double moment_ratio = -1;             ///< m = |M_N| / (N R / 2); negative: the closure's
  double moment_direction = -1.5707963; ///< theta of the load's maximum [rad], used with moment_ratio >= 0
  std::string file;                     ///< Fourier coefficients, used with source = file
  std::shared_ptr<const ring::RingStack> from_file = {}; ///< the load of that file, used likewise

  bool is_from_contact() const { return source == LoadSource::contact; }
  /// Whether the moment is given, instead of following from the moment balance.
  bool is_static() const { return moment_ratio >= 0; }
  /// Whether the load is one of a contact in balance with friction at every spin; with a given moment it is
  /// that of rest, whatever the coupling.
  bool is_in_balance() const
  {
    return is_from_contact() && !is_static() && coupling == LoadCoupling::two_way;
  }
};

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

  /// Whether rim or table are out of flat: the load then depends on where their marks stand.
  bool has_waviness() const { return model.waviness && (!glass.waviness.empty() || !table.waviness.empty()); }

  /// Whether friction tractions deform foot and substrate: Contact/Friction coupling = elastic, and a body
  /// that can.
  bool friction_deforms() const;

  /// Whether the lean of the glass on its foot counts in the balance of moments: Motion/Tilt = included, in
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
