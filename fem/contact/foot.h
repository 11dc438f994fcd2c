#pragma once

#include "fem/contact/contact_demand.h"
#include "fem/contact/contact_goal.h"
#include "fem/contact/contact_newton.h"
#include "fem/contact/load_harmonics.h"
#include "fem/contact/pressure_map.h"
#include "fem/geometry/mesh_io.h"
#include "fem/geometry/waviness.h"

#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace stemware::fem
{

/// How the foot slides over the table, as far as its contact depends on it.
struct Slip
{
  /// omega / v [1/m], counter-clockwise > 0: the direction of the friction tractions.
  double spin_per_speed = 0;
  /// Where the marks of glass and table stand; only a foot or a table that is out of flat knows them.
  FootOrientation orientation;
};

/// One solved contact: plain data that stays what it is when the foot is pressed again.
struct ContactState
{
  LoadHarmonics load;                    ///< in the slip frame
  ContactSolution solution;              ///< slip frame
  std::vector<ContactIteration> history; ///< Newton steps, of a foot that reports them: see Foot::solve()
  ContactDemand demand;                  ///< that it was solved for
  Slip slip;                             ///< that it was solved for
  unsigned int zone = 0; ///< which of the foot's contact zones the solution is of, for the foot itself
  /// Between which radii the load lies but for rounding [m].
  double inner_radius = 0;
  double outer_radius = 0;
};

/// What a foot is made of, for people and for summary.json.
struct FootDescription
{
  std::string body;                    ///< "revolution", "solid"
  std::optional<unsigned int> n_cells; ///< of a three-dimensional mesh
  unsigned int n_unknowns = 0;         ///< of the finite-element system, or displacement harmonics
  unsigned int n_contact_nodes = 0;
  std::optional<MeshReport> mesh_report; ///< of a mesh file
  double contact_cell_size = 0; ///< of a three-dimensional mesh: smallest extent of a contact cell [m]
};

/// What a foot can do, to be asked instead of its kind.
struct FootCapabilities
{
  /// Friction tractions act back on the pressure: the load depends on the spin.
  bool friction_deforms = false;
  /// The angle by which the glass can be turned (Slip::orientation) without changing the load, beyond what is
  /// out of flat by the study's entries [rad]; 0: any angle.
  double period_of_glass = 0;
  /// Solving takes all MPI ranks together, so two feet cannot be solved side by side.
  bool is_collective = false;
};

/// A file of a result, still in memory.
struct FieldFile
{
  std::string name; ///< "contact.vtu"; on several ranks "contact_0.vtu" ... and "contact.pvtu"
  std::string text;
};

/// An elastic foot on its table: mesh, stiffness and table law, set up once for any number of loads.
///
/// Where capabilities().is_collective, MPI must have been started and all ranks call every function together.
/// A foot answers one call at a time; different feet may be solved by different threads unless they are
/// collective.
class Foot
{
public:
  Foot() = default;
  Foot(const Foot &) = delete; // laws and bodies keep references to each other
  Foot &operator=(const Foot &) = delete;
  virtual ~Foot() = default;

  virtual FootDescription description() const = 0;
  virtual FootCapabilities capabilities() const = 0;

  /// Solves the contact under @p demand at @p slip, from the solution before where there is one.
  /// @p progress is called after each Newton step, which the state's history keeps too, where a solve takes
  /// long (a solid foot; not a body of revolution); may be empty. Throws ContactFailure.
  virtual ContactState solve(const ContactDemand &demand, const Slip &slip = {},
                             const std::function<void(const ContactIteration &)> &progress = {}) = 0;

  /// Makes @p state, a contact of this foot, the solution before: where several contacts are followed in
  /// turn, each starts from its own. A foot whose state is more than that may go on from the last one.
  virtual void resume(const ContactState & /*state*/) {}

  /// Contacts of this foot start from what those of @p similar let expect, a foot that differs little. Feet
  /// that cannot make use of it go on as they are.
  virtual void start_like(const Foot & /*similar*/) {}

  /// Highest harmonic that the contact resolves.
  virtual unsigned int n_resolved_harmonics() const = 0;

  /// The load of any state of this foot, rings and harmonics as ContactDemand has them.
  virtual LoadHarmonics gather(const ContactState &state, const std::vector<double> &ring_radii,
                               unsigned int n_harmonics) = 0;

  /// The pressure of any state of this foot as forces where they lie, slip frame; of a collective foot on the
  /// first rank, nothing on the others.
  virtual std::vector<PointForce> point_forces(const ContactState &state) = 0;

  /// The pressure p(r, theta) of any state of this foot, slip frame; of a collective foot on the first rank,
  /// empty on the others.
  virtual PressureMap pressure_map(const ContactState &state) = 0;

  /// Displacement, stress and contact pressure of @p state, the last one solved, as VTU files: what this rank
  /// has to write. Throws std::logic_error for a state whose displacement the body has left.
  virtual std::vector<FieldFile> fields(const ContactState &state) = 0;

  /// What the mesh does to @p goal in @p state, a contact of this foot, solved again on no mesh; nothing
  /// where this foot cannot tell. @p with_cells: with the cells' shares.
  virtual std::optional<MeshError> mesh_error(const ContactState & /*state*/, const ContactGoal & /*goal*/,
                                              bool /*with_cells*/)
  {
    return std::nullopt;
  }

protected:
  /// ContactDemand::n_harmonics as far as they are resolved.
  unsigned int kept_harmonics(unsigned int asked) const
  {
    return asked == 0 ? n_resolved_harmonics() : std::min(asked, n_resolved_harmonics());
  }
};

/// Throws std::logic_error unless the displacement of @p body is that of @p solution, u_z + Q q = normal
/// displacement to rounding.
void require_latest(const ElasticBody &body, const ContactSolution &solution);
/// Whether @p body has the displacement of @p solution.
bool is_latest(const ElasticBody &body, const ContactSolution &solution);

} // namespace stemware::fem
