#include "fem/pipeline/coupling/solid_study_foot.h"

#include "fem/pipeline/coupling/revolution_setup.h"
#include "fem/pipeline/coupling/study_balance.h"
#include "fem/pipeline/coupling/usable_mesh.h"
#include "fem/pipeline/study/study_file.h"
#include "fem/pipeline/study/study_size.h"
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
  return fem::read_solid_mesh(study.contact.mesh_file, study.contact.refinements,
                              study.contact.mesh_file_options);
}

/// Returns a text that is equal for two studies only if their feet have the same mesh, material and elements.
std::string elements_of(const Study &study, const Discretisation &discretisation)
{
  Study bare;
  bare.glass = study.glass;
  bare.contact = study.contact;
  std::string text = study_identity(bare) + fmt::format(FMT_STRING("{}\n"), edge_halvings(study));
  for (const std::vector<unsigned int> &cells : discretisation.halved_cells)
    text += fmt::format(FMT_STRING("halved {}\n"), fmt::join(cells, " "));
  return text;
}

fem::SolidMesh solid_mesh(const Study &study, const Discretisation &discretisation)
{
  fem::SolidMesh mesh = mesh_before_goal(study);
  for (const std::vector<unsigned int> &cells : discretisation.halved_cells)
    fem::halve(mesh, cells);
  return mesh;
}

/// Returns the linear solver of @p study. If the study needs only one or two contact solves, `automatic` is
/// replaced by multigrid, because a condensation costs about as much as four solves by multigrid.
fem::LinearSolver linear_solver_of(const Study &study, const Discretisation &discretisation)
{
  const ContactSection &contact = study.contact;
  const bool is_refined =
    contact.refinements > 0 || edge_halvings(study) > 0 || !discretisation.halved_cells.empty();
  const bool has_phases = !contact.mesh_file.empty() || study.has_waviness();
  if (contact.linear_solver != fem::LinearSolver::automatic || is_refined || has_phases ||
      varies_with_spin(study))
    return contact.linear_solver;
  return fem::LinearSolver::multigrid;
}

fem::SolidSetup solid_setup(const Study &study, const Discretisation &discretisation, const Model &model)
{
  fem::SolidSetup setup;
  setup.profile = study.glass.profile;
  setup.material = study.glass.material;
  setup.table = study.table.make();
  setup.options.degree = study.contact.degree;
  setup.options.linear_solver = linear_solver_of(study, discretisation);
  setup.options.line_factor = discretisation.line_factor;
  setup.hardness = discretisation.hardness;
  if (model.friction_in_foot)
    set_friction(study, setup);
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

std::shared_ptr<fem::Foot> make_solid_foot(const Study &study, const Discretisation &discretisation,
                                           const Model &model, const fem::Foot *similar)
{
  const fem::SolidSetup setup = solid_setup(study, discretisation, model);
  const std::string elements = elements_of(study, discretisation);
  const auto *other = dynamic_cast<const StudyFoot *>(similar);
  if (other && other->elements != elements)
    other = nullptr;
  return std::make_shared<StudyFoot>(other ? other->own_mesh() : solid_mesh(study, discretisation), setup,
                                     other, elements);
}

} // namespace stemware::pipeline
