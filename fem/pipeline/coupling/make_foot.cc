#include "fem/pipeline/coupling/make_foot.h"

#include "fem/pipeline/coupling/revolution_setup.h"
#include "fem/pipeline/coupling/solid_feet.h"
#include "fem/pipeline/coupling/study_load.h"
#include "fem/pipeline/coupling/usable_mesh.h"
#include "fem/pipeline/study/study_size.h"
#include "fem/pipeline/support/failures.h"
#include "fem/pipeline/support/ranks.h"
#include "fem/revolution/meridian_meshes.h"
#include "fem/revolution/meshed_revolution_foot.h"

#include <deal.II/grid/tria.h>

#include <stdexcept>

namespace stemware::pipeline
{

void require_known_body(const Study &study)
{
  if (study.load.is_from_contact() && study.contact.body == BodyKind::solid && !has_solid_feet())
    throw BadInput(
      "Contact/Body = solid needs a Stemware with MPI, p4est and Trilinos, and this one was built without; "
      "set Contact/Body = revolution, or build it with a deal.II that has the three.");
}

std::shared_ptr<fem::Foot> make_foot(const Study &study, fem::ComplianceCache &cache,
                                     const fem::Foot *similar)
{
  require_known_body(study);
  try
  {
    switch (study.contact.body)
    {
    case BodyKind::solid:
      start_mpi();
      return make_solid_foot(study, similar);
    case BodyKind::revolution:
      return std::make_shared<fem::MeshedRevolutionFoot>(revolution_setup(study), cache);
    }
  }
  catch (const std::invalid_argument &error)
  {
    throw BadInput(error.what());
  }
  throw std::logic_error("a body without a foot");
}

std::shared_ptr<ElasticFoot> study_foot(const Study &study, fem::ComplianceCache &cache, Progress &progress,
                                        const ElasticFoot *similar)
{
  return study_foot(
    study, [&](const Study &asked, const fem::Foot *like) { return make_foot(asked, cache, like); }, progress,
    similar);
}

bool has_focused_mesh(const Study &study)
{
  return abilities(study.contact.body).is_of_revolution && revolution_setup(study).resolution.has_focus();
}

bool has_spring_for_hard_table(const Study &study)
{
  const ContactSection &contact = study.contact;
  if (!study.table.is_hard() || abilities(contact.body).is_of_revolution)
    return study.table.is_hard();
  return contact.linear_solver != fem::LinearSolver::direct &&
         (contact.refinements > 0 || edge_halvings(study) > 0 || !contact.halved.empty());
}

std::vector<fem::SectionPolygon> foot_section(const Study &study)
{
  if (abilities(study.contact.body).is_of_revolution)
  {
    const fem::RevolutionSetup setup = revolution_setup(study);
    return fem::section_cells(fem::MeridianMeshes(setup).foot);
  }
  // Between two sectors of any usual mesh.
  constexpr double azimuth = 0.02;
  dealii::Triangulation<3> mesh;
  if (study.contact.mesh_file.empty())
    fem::make_foot_mesh(study.glass.profile, study.contact.resolution, mesh);
  else
    read_mesh_file(study.contact.mesh_file, study.contact.mesh_marks, mesh);
  return fem::section_cells(mesh, azimuth);
}

} // namespace stemware::pipeline
