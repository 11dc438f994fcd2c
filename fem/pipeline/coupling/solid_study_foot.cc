#include "fem/pipeline/coupling/make_foot.h"
#include "fem/pipeline/coupling/revolution_setup.h"
#include "fem/pipeline/coupling/usable_mesh.h"
#include "fem/pipeline/study/study_file.h"
#include "fem/solid/solid_foot.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <string>
#include <utility>
#include <vector>

namespace stemware::pipeline
{

namespace
{

/// Returns a text that is equal for two specifications only if their feet have the same mesh, material and
/// elements.
std::string elements_of(const FootSpecification &specification)
{
  Study bare;
  bare.glass = specification.study.glass;
  bare.contact = specification.study.contact;
  std::string text = study_as_prm(with_paths_from("/", bare)) +
                     fmt::format(FMT_STRING("{}\n"), specification.study.edge_halvings());
  for (const std::vector<unsigned int> &cells : specification.discretisation.halved_cells)
    text += fmt::format(FMT_STRING("halved {}\n"), fmt::join(cells, " "));
  return text;
}

/// Returns the mesh before the cells for a goal are halved.
fem::SolidMesh mesh_before_goal(const ContactSection &contact, const fem::GlassProfile &profile,
                                unsigned int n_edge_halvings)
{
  if (contact.mesh_file.empty())
  {
    fem::FootResolution resolution = contact.resolution;
    resolution.refinements = contact.refinements;
    resolution.edge_halvings = n_edge_halvings;
    return fem::generate_solid_mesh(profile, resolution);
  }
  require_usable_mesh(contact, profile.contact_radius);
  return fem::read_solid_mesh(contact.mesh_file, contact.refinements, contact.mesh_file_options);
}

fem::SolidMesh solid_mesh(const FootSpecification &specification)
{
  const auto &[study, discretisation, model] = specification;
  fem::SolidMesh mesh = mesh_before_goal(study.contact, study.glass.profile, study.edge_halvings());
  for (const std::vector<unsigned int> &cells : discretisation.halved_cells)
    fem::halve(mesh, cells);
  return mesh;
}

/// Returns the linear solver of a foot. If its study needs only one or two contact solves, `automatic` is
/// replaced by multigrid, because a condensation costs about as much as four solves by multigrid.
fem::LinearSolver linear_solver_of(const FootSpecification &specification)
{
  const ContactSection &contact = specification.study.contact;
  const bool has_phases = !contact.mesh_file.empty() || specification.study.has_waviness();
  return contact.linear_solver != fem::LinearSolver::automatic || specification.is_refined() || has_phases ||
             specification.study.varies_with_spin()
           ? contact.linear_solver
           : fem::LinearSolver::multigrid;
}

fem::SolidSetup solid_setup(const FootSpecification &specification)
{
  const auto &[study, discretisation, model] = specification;
  fem::SolidSetup setup;
  setup.profile = study.glass.profile;
  setup.material = study.glass.material;
  setup.table = study.table.make();
  setup.options.degree = study.contact.degree;
  setup.options.linear_solver = linear_solver_of(specification);
  setup.options.line_factor = discretisation.line_factor;
  setup.hardness = discretisation.hardness;
  if (model.friction_in_foot && study.friction_deforms())
    set_friction(study.motion.orbit, setup);
  return setup;
}

/// Solid foot that stores the text of elements_of(). Feet with equal texts share mesh and elements.
class StudyFoot : public fem::SolidFoot
{
public:
  /// Precondition: the text of @p similar, if given, equals @p elements_given.
  StudyFoot(const fem::SolidMesh &mesh, const fem::SolidSetup &setup, const StudyFoot *similar,
            std::string elements_given)
      : SolidFoot(mesh, setup, similar)
      , elements(std::move(elements_given))
  {
  }

  const std::string elements;
};

} // namespace

std::shared_ptr<fem::Foot> make_solid_foot(const FootSpecification &specification, const fem::Foot *similar)
{
  const fem::SolidSetup setup = solid_setup(specification);
  const std::string elements = elements_of(specification);
  const auto *other = dynamic_cast<const StudyFoot *>(similar);
  if (other && other->elements != elements)
    other = nullptr;
  return std::make_shared<StudyFoot>(other ? other->own_mesh() : solid_mesh(specification), setup, other,
                                     elements);
}

} // namespace stemware::pipeline
