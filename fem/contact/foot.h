#pragma once

#include "fem/contact/contact_demand.h"
#include "fem/contact/contact_goal.h"
#include "fem/contact/contact_load.h"
#include "fem/contact/contact_newton.h"
#include "fem/contact/pressure_map.h"
#include "fem/geometry/mesh_io.h"
#include "fem/geometry/section_view.h"
#include "ring_model/load/slip.h"

#include <algorithm>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace stemware::fem
{

/// One solved contact: all that its load, fields and estimates need, and that the next contact may start
/// from.
struct ContactState
{
  ContactLoad load;                      ///< in the slip frame
  ContactSolution solution;              ///< slip frame
  std::vector<ContactIteration> history; ///< Newton steps
  ContactDemand demand;                  ///< that it was solved for
  ring::Slip slip;                       ///< that it was solved for
  /// Radii between which the load lies but for rounding [m].
  double inner_radius = 0;
  double outer_radius = 0;

  // For the foot itself:
  unsigned int zone = 0;    ///< which of the foot's contact zones the solution is of
  bool with_crests = false; ///< whether it was found where the contact before goes to with the crests
  std::shared_ptr<const std::string> body = {}; ///< of a solid body, this rank's part of its state
};

/// Places from which a foot looks for a contact.
struct ContactGuess
{
  const ContactState *before = nullptr; ///< a contact of the same foot that is near; nothing: none is known
  /// Contact that is expected, in the slip frame, at the nodes of `before`'s zone, or of the first zone.
  std::optional<ContactStart> expected = {};
};

/// Description of a foot for people and for summary.json.
struct FootDescription
{
  std::string body;                    ///< "revolution", "solid"
  std::optional<unsigned int> n_cells; ///< of a three-dimensional mesh
  unsigned int n_unknowns = 0;         ///< of the finite-element system, or displacement harmonics
  unsigned int n_contact_nodes = 0;
  std::optional<MeshReport> mesh_report; ///< of a mesh file
  double contact_cell_size = 0; ///< of a three-dimensional mesh: smallest extent of a contact cell [m]
};

/// Abilities of a foot, to be asked instead of its kind.
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
/// Answers depend on the arguments alone. Where capabilities().is_collective, MPI must have been started and
/// all ranks call every function together. A foot works on one call at a time; different feet may be solved
/// by different threads unless they are collective.
class Foot
{
public:
  Foot() = default;
  Foot(const Foot &) = delete; // laws and bodies keep references to each other
  Foot &operator=(const Foot &) = delete;
  virtual ~Foot() = default;

  /// The same foot for another thread, with the same answers; nothing where it is collective.
  virtual std::shared_ptr<const Foot> twin() const { return nullptr; }

  virtual FootDescription description() const = 0;
  virtual FootCapabilities capabilities() const = 0;

  /// Solves the contact under @p demand at @p slip, from @p guess.
  /// @p progress is called after each Newton step, which the state's history keeps too, where a solve takes
  /// long (a solid foot; not a body of revolution); may be empty. Throws ContactFailure.
  virtual ContactState solve(const ContactDemand &demand, const ring::Slip &slip = {},
                             const ContactGuess &guess = {},
                             const std::function<void(const ContactIteration &)> &progress = {}) const = 0;

  /// Contact that is expected of this foot after @p start, a contact in zone @p zone of @p similar, a foot
  /// that differs little; nothing where @p start does not tell.
  virtual std::optional<ContactStart> expected_from(const ContactStart & /*start*/, unsigned int /*zone*/,
                                                    const Foot & /*similar*/) const
  {
    return std::nullopt;
  }

  /// Highest harmonic that the contact resolves.
  virtual unsigned int n_resolved_harmonics() const = 0;

  /// The load of any state of this foot, rings and harmonics as ContactDemand has them.
  virtual ContactLoad gather(const ContactState &state, const std::vector<double> &ring_radii,
                             unsigned int n_harmonics) const = 0;

  /// The pressure of any state of this foot as forces where they lie, slip frame; of a collective foot on the
  /// first rank, nothing on the others.
  virtual std::vector<PointForce> point_forces(const ContactState &state) const = 0;

  /// The pressure p(r, theta) of any state of this foot, slip frame; of a collective foot on the first rank,
  /// empty on the others.
  virtual PressureMap pressure_map(const ContactState &state) const = 0;

  /// Displacement, stress and contact pressure of any state of this foot as VTU files: what this rank has to
  /// write. Nothing of a foot without a mesh.
  virtual std::vector<FieldFile> fields(const ContactState & /*state*/) const { return {}; }

  /// The section of any state of this foot through its axis, at azimuth @p theta [rad] of the slip frame
  /// where x > 0, relative to the stem's cut; empty where this foot cannot tell.
  virtual std::vector<StressedPatch> section(const ContactState & /*state*/, double /*theta*/) const
  {
    return {};
  }

  /// Error of @p goal in @p state, a contact of this foot, that is due to the mesh alone; nothing where this
  /// foot cannot tell. @p with_cells: with the cells' shares.
  virtual std::optional<MeshError> mesh_error(const ContactState & /*state*/, const ContactGoal & /*goal*/,
                                              bool /*with_cells*/) const
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

} // namespace stemware::fem
