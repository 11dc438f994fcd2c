#pragma once

#include "fem/pipeline/study/study.h"

#include <utility>
#include <vector>

namespace stemware::pipeline
{

/// Numerical parameters of a foot that are no entries of a study; changed by error bands, goals and pages.
struct Discretisation
{
  double fineness = 1;                   ///< factor on the default fineness of the cells
  unsigned int halvings_beyond_zone = 0; ///< RevolutionSetup::halvings_beyond_zone
  /// Factor on the penalty of a hard interface. For a solid foot, a factor below 1 also multiplies the
  /// stiffness of other interfaces.
  double hardness = 1;
  unsigned int line_factor = 1; ///< factor on the contact lines of each face of a solid foot
  std::vector<std::vector<unsigned int>> halved_cells = {}; ///< indices of the halved cells, mesh after mesh
};

/// Parts of the model of a foot that a budget leaves out one at a time.
struct Model
{
  bool foot_is_rigid = false;        ///< the foot has no compliance
  bool friction_in_foot = true;      ///< friction deforms the foot, if Study::friction_deforms()
  bool friction_in_substrate = true; ///< the same for an elastic substrate
};

/// Study with the discretisation and the model of its foot, which together determine the foot.
struct FootSpecification
{
  FootSpecification(Study study = {}, // NOLINT(google-explicit-constructor): a study is a specification
                    Discretisation discretisation = {}, const Model &model = {})
      : study(std::move(study))
      , discretisation(std::move(discretisation))
      , model(model)
  {
  }

  /// Returns true if the mesh of a solid foot has a hierarchy: some or all of its cells are halved.
  bool is_refined() const
  {
    return study.contact.refinements > 0 || study.edge_halvings() > 0 || !discretisation.halved_cells.empty();
  }
  /// Returns true for a penalty law in place of a hard table (Discretisation::hardness); false for the nodal
  /// multipliers of a solid foot on a mesh without a hierarchy.
  bool uses_penalty_for_hard_table() const
  {
    return study.table.is_hard() && (study.contact.is_of_revolution() || is_refined());
  }

  Study study;
  Discretisation discretisation;
  Model model;
};

} // namespace stemware::pipeline
