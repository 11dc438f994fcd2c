#pragma once

#include "fem/geometry/foot_mesh.h"
#include "fem/geometry/mesh_io.h"
#include "fem/geometry/mesh_quality.h"
#include "fem/geometry/section_view.h"
#include "fem/revolution/compliance_cache.h"
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

/// Table stemware_finite_elements of the module fem: everything of the program that stands on deal.II, whose
/// two hundred libraries take half a second to load. Functions that have the name of one of fem/ are that
/// one.
struct FiniteElementFunctions
{
  using Mesh = dealii::Triangulation<3, 3>;
  using Compliance = std::shared_ptr<const fem::ContactCompliance>;

  /// fem::MeshedRevolutionFoot.
  std::shared_ptr<fem::Foot> (*make_revolution_foot)(const fem::RevolutionSetup &, fem::ComplianceCache &);
  /// Cells of the meridional mesh of the foot.
  std::vector<fem::SectionPolygon> (*meridian_cells)(const fem::RevolutionSetup &);
  /// Compliances where the contact is expected, of the foot and of the disc under it: nullptr without
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

  /// Text compressed as gzip does, in base64.
  std::string (*compressed_base64)(const std::string &);
  /// One sentence for an exception of deal.II, empty for every other.
  std::string (*sentence_of)(const std::exception &);
  void (*set_thread_limit)(unsigned int n_threads);
};

/// The table; loads the module at the first call. Throws BadInput if it cannot be loaded.
const FiniteElementFunctions &finite_elements();

/// The table if the module is loaded, else nullptr.
const FiniteElementFunctions *loaded_finite_elements();

/// Holds deal.II, and with it TBB in the whole program, to @p n_threads from the time when the module is
/// loaded; 1 until the first call. Returns the limit before.
unsigned int limit_threads(unsigned int n_threads);

} // namespace stemware::pipeline
