#pragma once

#include "fem/meridian/compliance_cache.h"
#include "fem/meshing/foot_mesh.h"
#include "fem/meshing/mesh_io.h"
#include "fem/meshing/mesh_quality.h"
#include "fem/meshing/section_view.h"
#include "fem/revolution/revolution_setup.h"

#include <exception>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace stemware::fem
{
class Foot;
}

namespace stemware::pipeline
{

/// Function table stemware_finite_elements of the module fem: all functions that need deal.II, whose two
/// hundred libraries take half a second to load. A function with the name of a function of fem/ is that
/// function.
struct FiniteElementFunctions
{
  using Mesh = dealii::Triangulation<3, 3>;
  using Compliance = std::shared_ptr<const fem::ContactCompliance>;

  /// fem::MeshedRevolutionFoot.
  std::shared_ptr<fem::Foot> (*make_revolution_foot)(const fem::RevolutionSetup &, fem::ComplianceCache &);
  /// Cells of the meridional mesh of the foot.
  std::vector<fem::SectionPolygon> (*meridian_cells)(const fem::RevolutionSetup &);
  /// Returns the compliances of foot and disc in the expected contact zone; nullptr for the disc without a
  /// substrate.
  std::pair<Compliance, Compliance> (*compliances)(const fem::RevolutionSetup &, fem::ComplianceCache &);

  std::shared_ptr<Mesh> (*empty_mesh)();
  decltype(&fem::make_foot_mesh) make_foot_mesh;
  decltype(&fem::move_to_crown) move_to_crown;
  decltype(&fem::read_foot_mesh) read_foot_mesh;
  decltype(&fem::check_mesh) check_mesh;
  std::vector<fem::SectionPolygon> (*section_cells)(const Mesh &, double azimuth);
  decltype(&fem::write_msh) write_msh;
  decltype(&fem::write_mesh_vtu) write_mesh_vtu;

  /// Returns a text compressed (gzip) in base64.
  std::string (*compressed_base64)(const std::string &);
  /// Returns one sentence for an exception of deal.II, an empty string for others.
  std::string (*sentence_of)(const std::exception &);
  void (*set_thread_limit)(unsigned int n_threads);
};

/// Returns the table; loads the module at the first call. Throws BadInput if it cannot be loaded.
const FiniteElementFunctions &finite_elements();

/// Returns the table if the module is loaded, else nullptr.
const FiniteElementFunctions *loaded_finite_elements();

/// Limits deal.II, and thereby TBB in the whole program, to @p n_threads once the module is loaded; 1 until
/// the first call. Returns the previous limit.
unsigned int limit_threads(unsigned int n_threads);

} // namespace stemware::pipeline
