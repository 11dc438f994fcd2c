#include "fem/pipeline/coupling/make_foot.h"

#include "fem/pipeline/coupling/deforming_friction.h"
#include "fem/pipeline/coupling/orientation.h"
#include "fem/pipeline/coupling/solid_feet.h"
#include "fem/pipeline/coupling/usable_mesh.h"
#include "fem/pipeline/study/study_size.h"
#include "fem/pipeline/support/failures.h"
#include "fem/revolution/meridian_meshes.h"
#include "fem/revolution/revolution_foot.h"

#include <deal.II/grid/tria.h>

#include <stdexcept>

namespace stemware::pipeline
{

namespace
{

fem::RevolutionSetup revolution_setup(const Study &study)
{
  fem::RevolutionSetup setup;
  setup.profile = study.glass.profile;
  setup.material = study.glass.material;
  setup.table = study.table.make();
  setup.imperfection = imperfection_of(study);
  set_friction(study, setup);
  setup.meridian.degree = study.contact.degree;
  setup.meridian.n_harmonics = study.contact.harmonics;
  setup.resolution.land_cells = study.contact.resolution.radial_cells;
  setup.resolution.land_grading = study.contact.land_grading;
  setup.resolution.refinements = study.contact.refinements;
  setup.halved = study.contact.halved;
  setup.n_lines = study.contact.azimuth_lines;
  setup.fineness = study.contact.fineness;
  setup.halvings_beyond_focus = study.contact.halvings_beyond_focus;
  setup.hardness *= study.contact.hardness;
  setup.foot_is_rigid = study.model.foot_is_rigid;
  setup.friction_in_foot = study.model.friction_in_foot;
  setup.friction_in_substrate = study.model.friction_in_substrate;
  return setup.resolved_for(study.required_resultants().normal_force);
}

} // namespace

void require_known_body(const Study &study)
{
  if (study.load.is_from_contact() && study.contact.body == BodyKind::solid && !has_solid_feet())
    throw BadInput(
      "Contact/Body = solid needs a Stemware with MPI, p4est and Trilinos, and this one was built without; "
      "set Contact/Body = revolution, or build it with a deal.II that has the three.");
}

std::shared_ptr<fem::Foot> make_foot(const Study &study, fem::ComplianceCache &cache)
{
  require_known_body(study);
  try
  {
    switch (study.contact.body)
    {
    case BodyKind::solid:
      return make_solid_foot(study);
    case BodyKind::revolution:
      return std::make_shared<fem::RevolutionFoot>(revolution_setup(study), cache);
    }
  }
  catch (const std::invalid_argument &error)
  {
    throw BadInput(error.what());
  }
  throw std::logic_error("a body without a foot");
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
