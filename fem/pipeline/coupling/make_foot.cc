#include "fem/pipeline/coupling/make_foot.h"

#include "fem/pipeline/coupling/orientation.h"
#include "fem/pipeline/coupling/usable_mesh.h"
#include "fem/pipeline/study/study_file.h"
#include "fem/pipeline/study/study_size.h"
#include "fem/pipeline/support/failures.h"
#include "fem/revolution/meridian_meshes.h"
#include "fem/revolution/revolution_foot.h"
#include "fem/solid/contact_checkpoint.h"
#include "fem/solid/solid_foot.h"

#include <deal.II/grid/tria.h>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <stdexcept>

namespace stemware::pipeline
{

namespace
{

/// Gives @p setup the friction that deforms the body, where one does.
template <typename Setup>
void set_friction(const Study &study, Setup &setup)
{
  if (!study.friction_deforms())
    return;
  const ring::Motion &motion = study.motion.orbit;
  setup.friction_coefficient = motion.friction_coefficient;
  if (!motion.has_constant_friction())
    setup.friction_by_slip = [motion](double relative_slip)
    { return motion.friction_at(relative_slip * motion.orbit_speed); };
}

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

fem::SolidMesh mesh_before_goal(const Study &study)
{
  if (study.contact.mesh_file.empty())
  {
    fem::FootResolution resolution = study.contact.resolution;
    resolution.refinements = study.contact.refinements;
    resolution.edge_halvings = edge_halvings(study);
    return fem::generate_solid_mesh(study.glass.profile, resolution);
  }
  require_usable_mesh(study);
  return fem::read_solid_mesh(study.contact.mesh_file, study.contact.refinements, study.contact.mesh_marks);
}

fem::SolidMesh solid_mesh(const Study &study)
{
  fem::SolidMesh mesh = mesh_before_goal(study);
  for (const fem::MarkedCells &marked : study.contact.halved)
    fem::halve(mesh, marked.foot);
  return mesh;
}

fem::SolidSetup solid_setup(const Study &study)
{
  fem::SolidSetup setup;
  setup.profile = study.glass.profile;
  setup.material = study.glass.material;
  setup.table = study.table.make();
  setup.options.degree = study.contact.degree;
  setup.options.linear_solver = study.contact.linear_solver;
  setup.hardness = study.contact.hardness;
  if (study.model.friction_in_foot)
    set_friction(study, setup);
  setup.checkpoint_folder = study.contact.checkpoint_folder;
  setup.checkpoint_owner = study.contact.checkpoint_owner;
  if (!setup.checkpoint_folder.empty()) // says before the work where it cannot be used
    fem::ContactCheckpoint(setup.checkpoint_folder, setup.checkpoint_owner, "");
  setup.problem = study_identity(study);
  for (const fem::MarkedCells &marked : study.contact.halved)
    setup.problem += fmt::format(FMT_STRING("halved {}\n"), fmt::join(marked.foot, " "));
  return setup;
}

} // namespace

std::shared_ptr<fem::Foot> make_foot(const Study &study, fem::ComplianceCache &cache)
{
  try
  {
    switch (study.contact.body)
    {
    case BodyKind::solid:
    {
      const fem::SolidSetup setup = solid_setup(study);
      return std::make_shared<fem::SolidFoot>(solid_mesh(study), setup);
    }
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
