#include "fem/pipeline/coupling/make_foot.h"

#include "fem/geometry/foot_mesh.h"
#include "fem/pipeline/base/failures.h"
#include "fem/pipeline/base/ranks.h"
#include "fem/pipeline/coupling/revolution_setup.h"
#include "fem/pipeline/coupling/solid_study_foot.h"
#include "fem/pipeline/coupling/study_load.h"
#include "fem/pipeline/coupling/usable_mesh.h"
#include "fem/pipeline/study/study_entries.h"
#include "fem/pipeline/study/study_size.h"
#include "fem/revolution/meridian_meshes.h"
#include "fem/revolution/meshed_revolution_foot.h"

#include <deal.II/grid/tria.h>

#include <stdexcept>

namespace stemware::pipeline
{

void prepare_foot_of(const Study &study)
{
  if (!study.load.is_from_contact() || study.contact.body != BodyKind::solid)
    return;
#ifdef STEMWARE_HAS_SOLID
  start_mpi();
#else
  throw BadInput(
    "Contact/Body = solid needs the solid foot, which this Stemware was built without; build it with "
    "`./quickstart install`, or in a build folder with `cmake -D STEMWARE_SOLID=ON . && cmake --build .`.");
#endif
}

std::shared_ptr<fem::Foot> make_foot(const Study &study, fem::ComplianceCache &cache,
                                     [[maybe_unused]] const fem::Foot *similar,
                                     const Discretisation &discretisation, const Model &model)
{
  prepare_foot_of(study);
  try
  {
    switch (study.contact.body)
    {
    case BodyKind::solid:
#ifdef STEMWARE_HAS_SOLID
      return make_solid_foot(study, discretisation, model, similar);
#else
      break;
#endif
    case BodyKind::revolution:
      return std::make_shared<fem::MeshedRevolutionFoot>(revolution_setup(study, discretisation, model),
                                                         cache);
    }
  }
  catch (const std::invalid_argument &error)
  {
    throw BadInput(with_entries(error.what()));
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
  return contact.refinements > 0 || edge_halvings(study) > 0 || !discretisation.halved_cells.empty();
}

std::vector<fem::SectionPolygon> foot_section(const Study &study, const Discretisation &discretisation)
{
  if (abilities(study.contact.body).is_of_revolution)
    return fem::section_cells(fem::MeridianMeshes(revolution_setup(study, discretisation)).foot);
  // Azimuth of the section [rad]. Usual meshes have no nodes at this azimuth.
  constexpr double azimuth = 0.02;
  dealii::Triangulation<3> mesh;
  if (study.contact.mesh_file.empty())
    fem::make_foot_mesh(study.glass.profile, study.contact.resolution, mesh);
  else
    read_mesh_file(study.contact.mesh_file, study.contact.mesh_file_options, mesh,
                   study.contact.memory_limit);
  return fem::section_cells(mesh, azimuth);
}

} // namespace stemware::pipeline
