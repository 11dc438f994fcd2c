#include "fem/pipeline/feet/make_foot.h"

#include "fem/pipeline/coupling/revolution_setup.h"
#include "fem/pipeline/coupling/study_load.h"
#include "fem/pipeline/feet/finite_elements.h"
#include "fem/pipeline/feet/solid_feet.h"
#include "fem/pipeline/feet/usable_mesh.h"
#include "fem/pipeline/input/study_size.h"
#include "fem/pipeline/support/failures.h"
#include "fem/pipeline/system/module.h"
#include "fem/pipeline/system/ranks.h"

#include <stdexcept>

namespace stemware::pipeline
{

namespace
{

const SolidFootFunctions &solid_feet()
{
  finite_elements(); // the module stands on this one
  return *static_cast<const SolidFootFunctions *>(
    load_table("solid", "stemware_solid_feet", "Contact/Body = solid, with MPI, p4est and Trilinos,"));
}

} // namespace

void load_modules_of(const Study &study)
{
  if (!study.load.is_from_contact())
    return;
  finite_elements();
  if (study.contact.body != BodyKind::solid)
    return;
  solid_feet();
  start_mpi();
}

std::shared_ptr<fem::Foot> make_foot(const Study &study, fem::ComplianceCache &cache,
                                     const fem::Foot *similar, const Discretisation &discretisation,
                                     const Model &model)
{
  load_modules_of(study);
  try
  {
    switch (study.contact.body)
    {
    case BodyKind::solid:
      return solid_feet().make_foot(study, discretisation, model, similar);
    case BodyKind::revolution:
      return finite_elements().make_revolution_foot(revolution_setup(study, discretisation, model), cache);
    }
  }
  catch (const std::invalid_argument &error)
  {
    throw BadInput(error.what());
  }
  throw std::logic_error("a body without a foot");
}

FootMaker foot_maker(fem::ComplianceCache &cache)
{
  return [&cache](const Study &study, const Discretisation &discretisation, const Model &model,
                  const fem::Foot *similar)
  { return make_foot(study, cache, similar, discretisation, model); };
}

std::shared_ptr<ElasticFoot> study_foot(const Study &study, fem::ComplianceCache &cache, Progress &progress,
                                        const ElasticFoot *similar, const Discretisation &discretisation,
                                        const Model &model)
{
  return study_foot(study, foot_maker(cache), progress, similar, discretisation, model);
}

bool has_focused_mesh(const Study &study, const Discretisation &discretisation)
{
  return abilities(study.contact.body).is_of_revolution &&
         revolution_setup(study, discretisation).resolution.has_focus();
}

bool uses_penalty_for_hard_table(const Study &study, const Discretisation &discretisation)
{
  const ContactSection &contact = study.contact;
  if (!study.table.is_hard() || abilities(contact.body).is_of_revolution)
    return study.table.is_hard();
  return contact.linear_solver != fem::LinearSolver::direct &&
         (contact.refinements > 0 || edge_halvings(study) > 0 || !discretisation.halved.empty());
}

std::vector<fem::SectionPolygon> foot_section(const Study &study, const Discretisation &discretisation)
{
  if (abilities(study.contact.body).is_of_revolution)
    return finite_elements().meridian_cells(revolution_setup(study, discretisation));
  // Between two sectors of any usual mesh.
  constexpr double azimuth = 0.02;
  const auto mesh = finite_elements().empty_mesh();
  if (study.contact.mesh_file.empty())
    finite_elements().make_foot_mesh(study.glass.profile, study.contact.resolution, *mesh);
  else
    read_mesh_file(study.contact.mesh_file, study.contact.mesh_file_options, *mesh,
                   study.contact.memory_limit);
  return finite_elements().section_cells(*mesh, azimuth);
}

} // namespace stemware::pipeline
