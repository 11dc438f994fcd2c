#include "fem/pipeline/coupling/make_foot.h"

#include "fem/geometry/foot_mesh.h"
#include "fem/pipeline/base/failures.h"
#include "fem/pipeline/base/ranks.h"
#include "fem/pipeline/coupling/revolution_setup.h"
#include "fem/pipeline/coupling/usable_mesh.h"
#include "fem/pipeline/study/study_entries.h"
#include "fem/revolution/meridian_meshes.h"
#include "fem/revolution/meshed_revolution_foot.h"

#include <deal.II/grid/tria.h>

#include <stdexcept>

namespace stemware::pipeline
{

void prepare_body(BodyKind body)
{
  if (body != BodyKind::solid)
    return;
#ifdef STEMWARE_HAS_SOLID
  start_mpi();
#else
  throw BadInput(
    "Contact/Body = solid needs the solid foot, which this Stemware was built without; build it with "
    "`./quickstart install`, or in a build folder with `cmake -D STEMWARE_SOLID=ON . && cmake --build .`.");
#endif
}

FootMaker foot_maker(fem::ComplianceCache &cache)
{
  return [&cache](const FootSpecification &specification,
                  [[maybe_unused]] const fem::Foot *similar) -> std::shared_ptr<fem::Foot>
  {
    prepare_body(specification.study.contact.body);
    try
    {
#ifdef STEMWARE_HAS_SOLID
      if (specification.study.contact.body == BodyKind::solid)
        return make_solid_foot(specification, similar);
#endif
      return std::make_shared<fem::MeshedRevolutionFoot>(revolution_setup(specification), cache);
    }
    catch (const std::invalid_argument &error)
    {
      throw BadInput(with_entries(error.what()));
    }
  };
}

std::vector<fem::SectionPolygon> foot_section(const FootSpecification &specification)
{
  const ContactSection &contact = specification.study.contact;
  if (contact.is_of_revolution())
    return fem::section_cells(fem::MeridianMeshes(revolution_setup(specification)).foot);
  // Azimuth of the section [rad]. Usual meshes have no nodes at this azimuth.
  constexpr double azimuth = 0.02;
  dealii::Triangulation<3> mesh;
  if (contact.mesh_file.empty())
    fem::make_foot_mesh(specification.study.glass.profile, contact.resolution, mesh);
  else
    read_mesh_file(contact.mesh_file, contact.mesh_file_options, mesh, contact.memory_limit);
  return fem::section_cells(mesh, azimuth);
}

} // namespace stemware::pipeline
