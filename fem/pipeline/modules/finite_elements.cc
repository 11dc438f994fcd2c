#include "fem/pipeline/feet/finite_elements.h"

#include "fem/meridian/meridian_meshes.h"
#include "fem/meridian/meshed_revolution_foot.h"

#include <deal.II/base/exceptions.h>
#include <deal.II/base/multithread_info.h>
#include <deal.II/base/utilities.h>
#include <deal.II/grid/tria.h>

#include <sstream>

#ifndef DEAL_II_WITH_ZLIB
#error "The page is packed by deal.II's zlib."
#endif

namespace stemware::pipeline
{

namespace
{

std::shared_ptr<fem::Foot> make_revolution_foot(const fem::RevolutionSetup &setup,
                                                fem::ComplianceCache &cache)
{
  return std::make_shared<fem::MeshedRevolutionFoot>(setup, cache);
}

std::vector<fem::SectionPolygon> meridian_cells(const fem::RevolutionSetup &setup)
{
  return fem::section_cells(fem::MeridianMeshes(setup).foot);
}

std::pair<FiniteElementFunctions::Compliance, FiniteElementFunctions::Compliance>
compliances(const fem::RevolutionSetup &setup, fem::ComplianceCache &cache)
{
  const fem::MeridianMeshes meshes(setup);
  const fem::MeridianOptions options = setup.meridian_of_zone();
  return { cache.get(meshes.foot, setup.material, options),
           setup.table.substrate ? cache.get(meshes.disc, setup.table.substrate->material, options)
                                 : nullptr };
}

std::shared_ptr<FiniteElementFunctions::Mesh> empty_mesh()
{
  return std::make_shared<FiniteElementFunctions::Mesh>();
}

std::string compressed_base64(const std::string &text)
{
  const std::string compressed = dealii::Utilities::compress(text);
  return dealii::Utilities::encode_base64({ compressed.begin(), compressed.end() });
}

std::string sentence_of(const std::exception &failure)
{
  const auto *of_dealii = dynamic_cast<const dealii::ExceptionBase *>(&failure);
  if (of_dealii == nullptr)
    return "";
  std::ostringstream information;
  of_dealii->print_info(information);
  return "deal.II stopped: " + std::string(of_dealii->get_exc_name()) + " " + information.str();
}

void set_thread_limit(unsigned int n_threads)
{
  dealii::MultithreadInfo::set_thread_limit(n_threads);
}

} // namespace

extern "C" const FiniteElementFunctions stemware_finite_elements;
const FiniteElementFunctions stemware_finite_elements = {
  make_revolution_foot, meridian_cells,      compliances,     empty_mesh,         fem::make_foot_mesh,
  fem::move_to_crown,   fem::read_foot_mesh, fem::check_mesh, fem::section_cells, fem::write_msh,
  fem::write_mesh_vtu,  compressed_base64,   sentence_of,     set_thread_limit
};

} // namespace stemware::pipeline
