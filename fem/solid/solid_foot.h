#pragma once

#include "fem/contact/foot.h"
#include "fem/contact/sliding_traction.h"
#include "fem/contact/table.h"
#include "fem/geometry/elastic_material.h"
#include "fem/geometry/foot_mesh.h"
#include "fem/geometry/glass_profile.h"
#include "fem/geometry/triangulation.h"
#include "fem/solid/solid_options.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace stemware::fem
{

class CondensedBody;
class SolidBody;
struct NodalCompliance;

/// Mesh of a solid foot, distributed over all MPI ranks.
struct SolidMesh
{
  std::shared_ptr<dealii::Triangulation<3, 3>> triangulation;
  std::optional<MeshReport> report; ///< report on a mesh file; std::nullopt for a generated mesh
};

/// Halves the cells @p marked of @p mesh, numbered as in MeshError::mark() of a foot on this mesh, and others
/// so that neighbours differ by at most one level. Collective.
void halve(SolidMesh &mesh, const std::vector<unsigned int> &marked);

/// Returns the mesh of make_foot_mesh(): a flat land, whose crown is a gap.
SolidMesh generate_solid_mesh(const GlassProfile &profile, const FootResolution &resolution);

/// Returns the mesh of a file (crown included), all cells halved @p refinements times. Throws as
/// read_foot_mesh().
SolidMesh read_solid_mesh(const std::string &file, unsigned int refinements = 0,
                          const MeshFileOptions &marks = {});

/// Glass, table and numerical parameters of a solid foot.
struct SolidSetup
{
  GlassProfile profile;
  ElasticMaterial material;
  Table table;
  /// mu of the friction that deforms the foot; 0: no effect on the pressure.
  double friction_coefficient = 0;
  /// mu as a function of |v_rel| / v. Empty: friction_coefficient everywhere.
  std::function<double(double relative_slip)> friction_by_slip;
  SolidOptions options; ///< its straight_edges follow from the mesh
  double hardness = 1;  ///< over the default penalty of a hard interface; < 1: of any interface's stiffness
};

/// Foot as three-dimensional finite elements on all MPI ranks. A foot from a mesh file, with azimuth 0 along
/// x, rotates with ring::Slip::orientation. A generated mesh is axisymmetric and does not rotate.
///
///     SolidSetup setup;
///     setup.table.interface = std::make_shared<WinklerInterface>(1e10);       // [Pa/m]
///     const SolidFoot foot(generate_solid_mesh(setup.profile, {}), setup);
///     foot.solve({ weight, 0, -moment }).load.b(1); // N, M_Nx, M_Ny; [N/rad]
class SolidFoot : public Foot
{
public:
  /// Throws std::invalid_argument for an inadmissible mesh or setup, or a substrate. @p similar: foot of
  /// equal mesh, material and elements to share data with, not used while this one solves.
  SolidFoot(const SolidMesh &mesh, const SolidSetup &setup, const SolidFoot *similar = nullptr);

  ~SolidFoot() override;

  const SolidMesh &own_mesh() const { return mesh; }

  FootDescription description() const override;
  FootCapabilities capabilities() const override;
  /// Starts from ContactGuess::previous.
  ContactState solve(const ContactDemand &demand, const ring::Slip &slip = {}, const ContactGuess &guess = {},
                     const std::function<void(const ContactIteration &)> &progress = {}) const override;
  unsigned int n_resolved_harmonics() const override;
  ContactLoad project_onto_rings(const ContactState &state, const std::vector<double> &ring_radii,
                                 unsigned int n_harmonics) const override;
  std::vector<PointForce> point_forces(const ContactState &state) const override;
  PressureMap pressure_map(const ContactState &state) const override;
  std::vector<FieldFile> fields(const ContactState &state) const override;
  /// Returns estimate_mesh_error(), or std::nullopt for a hard table on a mesh without a hierarchy (nodal
  /// multipliers are of no use on other elements) and for a contact narrower than two cells, which finer
  /// elements do not resolve (except at the edge of a step's flat land).
  std::optional<MeshError> mesh_error(const ContactState &state, const ContactGoal &goal,
                                      bool with_cells) const override;

private:
  SlidingTraction sliding_at(const ring::Slip &slip) const;
  /// Sets `body` to the displacement of @p state.
  void restore_displacement(const ContactState &state) const;
  /// Returns the contact of @p state in the axes of the mesh.
  ContactSolution in_mesh_axes(const ContactState &state) const;
  /// Returns the azimuth of the mesh's x axis in the slip frame [rad].
  double axis_of(const ring::Slip &slip) const { return mesh.report ? slip.orientation.glass : 0; }
  /// Returns whether a hard table uses nodal multipliers: on a mesh without a coarser mesh.
  bool has_multipliers() const { return setup.table.interface->is_hard() && softening_of_coarser == 1; }
  /// Calls solve_contact() on this body; with multipliers, at decreasing tolerances.
  ContactSolution find_contact(const LinearConditions &conditions, ContactControl control,
                               std::optional<ContactStart> start) const;
  ContactSolution press(const ContactDemand &demand, const ring::Slip &slip, const ContactState *before,
                        const ContactControl &control) const;

  const SolidSetup setup;
  const SolidMesh mesh;
  const std::unique_ptr<SolidBody> body; ///< work space of contacts; its state between calls is undefined
  std::shared_ptr<const NodalCompliance> compliance;   ///< nullptr: contacts are solved on the whole body
  std::unique_ptr<CondensedBody> condensed;            ///< nullptr without compliance
  const std::shared_ptr<const InterfaceLaw> interface; ///< penalty law for a hard interface on a hierarchy
  const double softening_of_coarser;                   ///< see start_from_coarser_mesh()
  const std::unique_ptr<TableLaw> law;
  const unsigned int n_contact_nodes; ///< number of contact nodes of all ranks
};

} // namespace stemware::fem
