#include "fem/pipeline/coupling/foot_contact.h"
#include "fem/pipeline/coupling/usable_mesh.h"
#include "fem/solid/solid_body.h"

#include <deal.II/distributed/tria.h>

#include <algorithm>
#include <cmath>

namespace stemware::pipeline
{

namespace
{

using Mesh = dealii::parallel::distributed::Triangulation<3>;

/// Fills the triangulation; the report is that of a mesh file.
std::optional<fem::MeshReport> make_mesh(const Study &study, Mesh &mesh)
{
  if (study.contact.mesh_file.empty())
  {
    fem::make_foot_mesh(study.glass.profile, study.contact.resolution, mesh);
    return std::nullopt;
  }
  return read_usable_mesh(study, mesh);
}

/// A generated mesh has a flat land, whose crown is a gap; a mesh file says all about its rim itself.
fem::SolidBody::Gap gap_of(const Study &study)
{
  if (!study.contact.mesh_file.empty())
    return [](double, double) { return 0.; };
  return [profile = study.glass.profile](double x, double y) { return profile.gap(std::hypot(x, y)); };
}

std::unique_ptr<fem::TableLaw> make_law(const Study &study, const fem::SolidBody &body)
{
  switch (study.table.kind)
  {
  case TableKind::rigid:
    return fem::make_rigid_table(body.contact_surface(),
                                 study.glass.material.young_modulus / body.contact_cell_size());
  case TableKind::mat:
    return fem::make_mat(body.contact_surface(), study.table.foundation_modulus);
  case TableKind::rough:
    return fem::make_rough_interface(body.contact_surface(), study.table.roughness);
  case TableKind::elastic:
    break;
  }
  throw std::logic_error("a table that a solid body does not know was not refused");
}

class SolidContact : public FootContact
{
public:
  explicit SolidContact(const Study &study)
      : contact_radius(study.glass.profile.contact_radius)
      , mesh(MPI_COMM_WORLD)
      , report(make_mesh(study, mesh))
      , body(mesh, study.glass.material, gap_of(study), options(study))
      , law(make_law(study, body))
  {
  }

  std::string name() const override { return "solid"; }
  std::optional<unsigned int> n_cells() const override
  {
    return static_cast<unsigned int>(mesh.n_global_active_cells());
  }
  unsigned int n_unknowns() const override { return body.n_unknowns(); }
  unsigned int n_contact_nodes() const override { return body.contact_surface().n_nodes(); }
  std::optional<fem::MeshReport> mesh_report() const override { return report; }

  FootContactResult solve(const fem::ContactLoad &load, double /*spin_per_speed*/,
                          const Progress &progress) override
  {
    FootContactResult result;
    fem::ContactControl control;
    control.progress = [&](const fem::ContactIteration &iteration)
    {
      result.history.push_back(iteration);
      if (progress)
        progress(iteration);
    };
    result.solution =
      fem::solve_contact(body, *law, load, contact_radius, control, motion ? &*motion : nullptr);
    motion = result.solution.motion;
    result.load = fem::extract_load(*law, result.solution, n_harmonics());
    return result;
  }

  std::vector<fem::PointForce> point_forces(const FootContactResult &result) const override
  {
    return law->point_forces(result.solution.approach);
  }
  fem::Footprint footprint(const FootContactResult &result) const override
  {
    return law->footprint(result.solution.approach);
  }

  bool write_fields(const std::string &folder, const FootContactResult &result) const override
  {
    body.write_fields(folder, "contact", result.solution.motion,
                      law->nodal_pressure(result.solution.approach));
    return true;
  }

private:
  fem::SolidOptions options(const Study &study) const
  {
    fem::SolidOptions chosen;
    chosen.degree = study.contact.degree;
    chosen.linear_solver = study.contact.linear_solver;
    chosen.straight_edges = report && !report->round_rim;
    return chosen;
  }

  /// Half the cells round the rim resolve that many harmonics; more than 24 matter nowhere.
  unsigned int n_harmonics() const { return std::clamp(body.contact_surface().n_sectors / 2, 1u, 24u); }

  const double contact_radius;
  Mesh mesh;
  const std::optional<fem::MeshReport> report;
  fem::SolidBody body;
  const std::unique_ptr<fem::TableLaw> law;
  std::optional<Eigen::Vector3d> motion; ///< of the table under the solution before
};

} // namespace

std::unique_ptr<FootContact> make_solid_contact(const Study &study)
{
  return std::make_unique<SolidContact>(study);
}

} // namespace stemware::pipeline
