#pragma once

#include "fem/contact/contact_newton.h"
#include "fem/contact/load_harmonics.h"
#include "fem/contact/pressure_map.h"
#include "fem/geometry/foot_mesh.h"
#include "fem/geometry/waviness.h"
#include "fem/pipeline/study/study.h"
#include "fem/revolution/compliance_cache.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace stemware::pipeline
{

/// A foot pressed on the table under one load.
struct FootContactResult
{
  fem::LoadHarmonics load;
  fem::ContactSolution solution;
  std::vector<fem::ContactIteration> history;
};

/// The elastic foot and the table of a study: mesh, finite elements and table law, set up once for any number
/// of loads. Whatever the body, the results are of one kind. MPI must have been started; collective over all
/// ranks.
class FootContact
{
public:
  using Progress = std::function<void(const fem::ContactIteration &)>;

  virtual ~FootContact() = default;

  /// The body's name in summary.json.
  virtual std::string name() const = 0;
  /// Cells of a three-dimensional mesh; nothing for other bodies.
  virtual std::optional<unsigned int> n_cells() const { return std::nullopt; }
  /// Unknowns of the contact problem: of the finite-element system, or displacement harmonics.
  virtual unsigned int n_unknowns() const = 0;
  virtual unsigned int n_contact_nodes() const = 0;
  /// What was found in the mesh file; nothing for generated meshes.
  virtual std::optional<fem::MeshReport> mesh_report() const { return std::nullopt; }

  /// Solves the contact under @p load; @p spin_per_speed = omega / v [1/m] sets the direction of the friction
  /// where that acts back on the pressure. Later loads start from the solution before. Throws ContactFailure.
  virtual FootContactResult solve(const fem::ContactLoad &load, double spin_per_speed,
                                  const Progress &progress) = 0;

  /// Whether the load depends on |M_N| alone and turns with it, so that a curve over the moment ratio says
  /// all.
  virtual bool is_isotropic() const { return false; }

  /// The latest solution's load where it lies in the plane, and its pressure for pictures; slip frame.
  virtual std::vector<fem::PointForce> point_forces(const FootContactResult &result) const = 0;
  virtual fem::Footprint footprint(const FootContactResult &result) const = 0;

  /// Where the marks of glass and table stand in the contacts to come; at first where they are at t = 0. Only
  /// a foot or a table that is out of flat knows them.
  virtual void turn_to(const fem::FootPhase & /*phase*/) {}

  /// Writes <folder>/contact.vtu for the latest solution; false for a body that has no such fields.
  virtual bool write_fields(const std::string &folder, const FootContactResult &result) const = 0;
};

/// Contact/Body = solid: three-dimensional finite elements. Throws BadInput when the mesh file cannot be
/// used.
std::unique_ptr<FootContact> make_solid_contact(const Study &study);

/// Contact/Body = revolution: displacement harmonics, its compliances from @p store. Throws BadInput for a
/// setup that is not allowed.
std::unique_ptr<FootContact> make_revolution_contact(const Study &study, fem::ComplianceStore &store);

/// The body that the study asks for; feet that are to share what they can are given the same store.
std::unique_ptr<FootContact> make_foot_contact(const Study &study, fem::ComplianceStore &store);

} // namespace stemware::pipeline
