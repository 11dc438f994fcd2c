#pragma once

#include "fem/contact/contact_demand.h"
#include "fem/contact/contact_goal.h"
#include "fem/contact/contact_load.h"
#include "fem/contact/contact_newton.h"
#include "fem/contact/pressure_map.h"
#include "fem/geometry/mesh_report.h"
#include "fem/geometry/section_lengths.h"
#include "ring_model/load/slip.h"

#include <algorithm>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace stemware::fem
{

/// Solved contact with all data of its load, fields and estimates.
struct ContactState
{
  ContactLoad load;                      ///< load in the slip frame
  ContactSolution solution;              ///< slip frame
  std::vector<ContactIteration> history; ///< Newton steps
  ContactDemand demand;                  ///< required resultants
  ring::Slip slip;                       ///< spin over speed, orientation of glass and table
  /// Radii that enclose the load, up to rounding [m].
  double inner_radius = 0;
  double outer_radius = 0;

  // Internal data of the foot:
  unsigned int zone = 0;                        ///< index of the foot's contact zone
  bool start_rotated_with_waviness = false;     ///< the initial guess was rotated with the waviness
  std::shared_ptr<const std::string> body = {}; ///< state of a solid body, this rank's part
};

/// Initial guesses of a contact solve; `predicted` is tried first.
struct ContactGuess
{
  const ContactState *previous = nullptr; ///< nearby contact of the same foot; nullptr: none
  /// Predicted contact in the slip frame, at the nodes of the zone of `previous` or of the first zone.
  std::optional<ContactStart> predicted = {};
  /// Contact closer to rest, in the frame and zone of `predicted`. Near tipping, `previous` and `predicted`
  /// may lie on the branch of balances beyond the limit point.
  std::optional<ContactStart> nearer_to_rest = {};
};

/// Description of a foot for messages and summary.json.
struct FootDescription
{
  std::string body;                    ///< "revolution", "solid"
  std::optional<unsigned int> n_cells; ///< number of cells of a three-dimensional mesh
  unsigned int n_unknowns = 0;         ///< body of revolution: nodal forces and three motions
  unsigned int n_contact_nodes = 0;
  std::optional<MeshReport> mesh_report; ///< report on a mesh file
  double contact_cell_size = 0; ///< smallest extent of a contact cell of a three-dimensional mesh [m]
};

/// Abilities of a foot, queried instead of its type.
struct FootCapabilities
{
  /// True if friction tractions change the pressure, so that the load depends on the spin.
  bool friction_deforms = false;
  /// Rotation of the glass that leaves the load unchanged, waviness aside [rad]. 0: any rotation.
  double glass_period = 0;
  /// True if all MPI ranks must solve together; two such feet cannot be solved in parallel.
  bool is_collective = false;
};

/// Result file held in memory.
struct FieldFile
{
  std::string name; ///< "contact.vtu"; on several ranks "contact_0.vtu" ... and "contact.pvtu"
  std::string text;
};

/// Elastic foot on its table: mesh, stiffness and table law, set up once for any number of loads.
///
///     MeshedRevolutionFoot foot(setup.resolved_for(weight));            // or SolidFoot(mesh, setup)
///     const ContactLoad load = foot.solve({ weight, 0, -moment }).load; // N, M_Nx, M_Ny
///     load.a(2);                                                        // harmonic of the load [N/rad]
///
/// Results depend on the arguments only. A foot solves one call at a time. Different threads may solve
/// different feet, unless capabilities().is_collective: then all MPI ranks call every function together.
class Foot
{
public:
  Foot() = default;
  Foot(const Foot &) = delete; // laws and bodies keep references to each other
  Foot &operator=(const Foot &) = delete;
  virtual ~Foot() = default;

  /// Returns a copy of the foot with the same results, for another thread; nullptr if the foot is collective.
  virtual std::shared_ptr<const Foot> clone() const { return nullptr; }

  virtual FootDescription description() const = 0;
  virtual FootCapabilities capabilities() const = 0;

  /// Solves the contact under @p demand at @p slip from @p guess. A solid foot calls @p progress, if not
  /// empty, after each Newton step and records the steps in the history. Throws ContactFailure.
  virtual ContactState solve(const ContactDemand &demand, const ring::Slip &slip = {},
                             const ContactGuess &guess = {},
                             const std::function<void(const ContactIteration &)> &progress = {}) const = 0;

  /// Predicts a contact from @p start, a contact of @p similar in its @p zone; std::nullopt if it cannot.
  virtual std::optional<ContactStart> predict_from(const ContactStart & /*start*/, unsigned int /*zone*/,
                                                   const Foot & /*similar*/) const
  {
    return std::nullopt;
  }

  /// Returns the highest harmonic that the contact resolves.
  virtual unsigned int n_resolved_harmonics() const = 0;

  /// Projects the load of a state onto rings; radii and harmonics as in ContactDemand.
  virtual ContactLoad project_onto_rings(const ContactState &state, const std::vector<double> &ring_radii,
                                         unsigned int n_harmonics) const = 0;

  /// Returns the pressure as point forces in the slip frame; of a collective foot on the first rank, else
  /// empty.
  virtual std::vector<PointForce> point_forces(const ContactState &state) const = 0;

  /// Returns the pressure p(r, theta) in the slip frame; of a collective foot on the first rank, else empty.
  virtual PressureMap pressure_map(const ContactState &state) const = 0;

  /// Returns displacement, stress and contact pressure as VTU files of this rank; empty without a mesh.
  virtual std::vector<FieldFile> fields(const ContactState & /*state*/) const { return {}; }

  /// Returns the section of a state through the axis at azimuth @p theta [rad] of the slip frame (x > 0),
  /// with displacements relative to the stem's cut; empty if not available.
  virtual std::vector<StressedPatch> section(const ContactState & /*state*/, double /*theta*/) const
  {
    return {};
  }

  /// Estimates the mesh error of @p goal, @p with_cells with their shares; std::nullopt if the foot cannot.
  virtual std::optional<MeshError> mesh_error(const ContactState & /*state*/, const ContactGoal & /*goal*/,
                                              bool /*with_cells*/) const
  {
    return std::nullopt;
  }

protected:
  /// Returns ContactDemand::n_harmonics, limited to the resolved harmonics.
  unsigned int kept_harmonics(unsigned int asked) const
  {
    return asked == 0 ? n_resolved_harmonics() : std::min(asked, n_resolved_harmonics());
  }
};

} // namespace stemware::fem
